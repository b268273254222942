// SPDX-License-Identifier: GPL-3.0-or-later
// Reads Wavefront OBJ: v and f (v, v/vt, v//vn, v/vt/vn; negative indices count from the end; polygons), l as
// polylines. o and g do not start new surfaces: a file is one surface, because its groups share vertices and have no
// fixed meaning.
#include "readers/formats.hpp"
#include "readers/text/text.hpp"
#include "readers/triangles/single_surface.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns the next logical line, in which a backslash at the end of a line is followed by the next line.
std::string_view joined_line(LineReader& lines, std::string& buffer) {
  std::string_view line = lines.line();
  if (line.empty() || line.back() != '\\') return line;
  buffer.assign(line.substr(0, line.size() - 1));
  while (lines.next()) {
    line = lines.line();
    const bool more = !line.empty() && line.back() == '\\';
    buffer.append(" ").append(more ? line.substr(0, line.size() - 1) : line);
    if (!more) break;
  }
  return buffer;
}

std::int64_t vertex_row(const LineReader& lines, std::string_view token, std::size_t n_points) {
  const auto index = to_integer(token.substr(0, token.find('/')));
  if (!index || *index == 0)
    lines.fail("expected the index of a vertex (from 1, or negative), found " + in_quotes(token));
  return *index > 0 ? *index - 1 : static_cast<std::int64_t>(n_points) + *index;
}

bool is_obj_keyword(std::string_view word) {
  for (const std::string_view k : {"v", "vt", "vn", "vp", "f", "l", "p", "o", "g", "s", "mtllib", "usemtl"})
    if (word == k) return true;
  return false;
}

}  // namespace

bool is_obj(const InputFile& file) {
  LineReader lines(file);
  for (int seen = 0; seen < 1000 && lines.next(); ++seen) {
    const std::string_view word = Tokens(lines.line()).next();
    if (word.empty() || word.front() == '#') continue;
    if (!is_obj_keyword(word)) return false;
    if (word == "v" || file.extension() == ".obj") return true;
  }
  return file.extension() == ".obj" && !looks_binary(file);
}

FileContents read_obj(const InputFile& file) {
  LineReader lines(file);
  SurfaceBuilder builder(file);
  std::vector<std::int64_t> polygon;
  std::string buffer;
  struct Face {
    std::size_t first, line;
  };
  std::vector<Face> faces;
  // Faces of an OBJ file may refer to vertices that follow later, so triangles are built after the last line.
  std::vector<std::int64_t> corners;
  std::size_t n_other = 0;
  while (lines.next()) {
    const std::size_t number = lines.number();
    Tokens tokens(joined_line(lines, buffer));
    const std::string_view word = tokens.next();
    if (word.empty() || word.front() == '#') continue;
    if (word == "v") {
      builder.points().push_back(read_point(lines, tokens, std::to_string(builder.points().size() + 1)));
    } else if (word == "f") {
      faces.push_back({corners.size(), number});
      for (std::string_view t = tokens.next(); !t.empty() && t.front() != '#'; t = tokens.next())
        corners.push_back(vertex_row(lines, t, builder.points().size()));
    } else if (word == "l" || word == "p") {
      ++n_other;
    } else if (looks_binary(file)) {
      lines.fail("not a text file, though it is named as an OBJ file");
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::size_t last = i + 1 < faces.size() ? faces[i + 1].first : corners.size();
    polygon.assign(corners.begin() + static_cast<std::ptrdiff_t>(faces[i].first),
                   corners.begin() + static_cast<std::ptrdiff_t>(last));
    builder.add_polygon(polygon, faces[i].line);
  }
  FileContents contents = one_surface(file, "OBJ", std::move(builder));
  if (n_other > 0)
    contents.warnings.push_back(std::to_string(n_other) + " line or point elements (l, p) are passed over");
  return contents;
}

}  // namespace geomesh::geomodel

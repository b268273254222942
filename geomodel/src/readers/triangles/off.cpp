// SPDX-License-Identifier: GPL-3.0-or-later
// Reads OFF (Geomview): "OFF", counts, vertices, polygons with optional colours. The prefixes ST, C, N, 4 are accepted
// if each line still begins with three coordinates.
#include "readers/formats.hpp"
#include "readers/text/text.hpp"
#include "readers/triangles/single_surface.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns the keyword OFF with its prefixes if all of them are known, or an empty text.
std::string_view off_keyword(std::string_view token) {
  for (const std::string_view name : {"OFF", "COFF", "NOFF", "STOFF", "CNOFF", "NCOFF", "STNOFF", "STCNOFF"})
    if (token == name) return name;
  return {};
}

/// Finds the next line of an OFF file that contains more than a comment. `content` is the line without its comment.
bool next_content(LineReader& lines, std::string_view& content) {
  while (lines.next()) {
    const std::string_view line = lines.line();
    content = trim(line.substr(0, line.find('#')));
    if (!content.empty()) return true;
  }
  return false;
}

void require_content(LineReader& lines, std::string_view& content, const std::string& what) {
  if (!next_content(lines, content)) lines.fail("the file ends where " + what + " was expected (truncated?)");
}

std::size_t claimed(const LineReader& lines, std::string_view token, const char* what) {
  const auto n = to_integer(token);
  if (!n || *n < 0) lines.fail(std::string("expected ") + what + ", found " + in_quotes(token));
  if (static_cast<std::uint64_t>(*n) > lines.file().size() / 4) {
    lines.fail(std::string(what) + " is given as " + std::to_string(*n) + ", more than a file of " +
               std::to_string(lines.file().size()) + " bytes can hold (truncated, or a wrong count)");
  }
  return static_cast<std::size_t>(*n);
}

}  // namespace

bool is_off(const InputFile& file) {
  LineReader lines(file);
  std::string_view content;
  return next_content(lines, content) && !off_keyword(Tokens(content).next()).empty();
}

FileContents read_off(const InputFile& file) {
  LineReader lines(file);
  std::string_view content;
  require_content(lines, content, "OFF");
  Tokens head(content);
  head.next();
  if (head.rest().starts_with("BINARY")) lines.fail("binary OFF is not read; convert it to ASCII OFF, STL or PLY");
  if (head.at_end()) {
    require_content(lines, content, "the counts of vertices and faces");
    head = Tokens(content);
  }
  const std::size_t n_vertices = claimed(lines, head.next(), "the number of vertices");
  const std::size_t n_faces = claimed(lines, head.next(), "the number of faces");
  SurfaceBuilder builder(file);
  for (std::size_t i = 0; i < n_vertices; ++i) {
    require_content(lines, content, "vertex " + std::to_string(i) + " of " + std::to_string(n_vertices));
    Tokens tokens(content);
    builder.points().push_back(read_point(lines, tokens, std::to_string(i)));
  }
  std::vector<std::int64_t> polygon;
  for (std::size_t i = 0; i < n_faces; ++i) {
    require_content(lines, content, "face " + std::to_string(i) + " of " + std::to_string(n_faces));
    Tokens tokens(content);
    const std::size_t n = claimed(lines, tokens.next(), "the number of a face's vertices");
    polygon.clear();
    for (std::size_t k = 0; k < n; ++k) {
      const auto v = to_integer(tokens.next());
      if (!v) lines.fail("a face of " + std::to_string(n) + " vertices was expected, found " + in_quotes(content));
      polygon.push_back(*v);
    }
    builder.add_polygon(polygon, lines.number());
  }
  if (next_content(lines, content) && n_faces > 0)
    lines.fail("text behind the last face: " + in_quotes(content) + " (a wrong count of faces?)");
  return one_surface(file, "OFF", std::move(builder));
}

}  // namespace geomesh::geomodel

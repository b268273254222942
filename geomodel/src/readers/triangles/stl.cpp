// SPDX-License-Identifier: GPL-3.0-or-later
// Reads STL, ASCII and binary. A binary file may begin with "solid", so its size decides. Every triangle has three
// points of its own. Exactly equal points are merged here, because the format has no other way to express that
// triangles share a vertex.
#include <cmath>

#include "readers/formats.hpp"
#include "readers/text/binary.hpp"
#include "readers/text/text.hpp"
#include "readers/triangles/merge_points.hpp"
#include "readers/triangles/single_surface.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t header_bytes = 84, facet_bytes = 50;

bool has_binary_size(const InputFile& file) {
  if (file.size() < header_bytes) return false;
  const std::uint64_t n = read_little<std::uint32_t>(file.bytes, 80);
  return file.size() == header_bytes + facet_bytes * n;
}

bool begins_with_solid(const InputFile& file) {
  return starts_with_ignoring_case(trim(file.text().substr(0, 64)), "solid");
}

FileContents finish(const InputFile& file, const char* format, std::string name, std::vector<Vec3> corners) {
  if (corners.empty()) file.fail("the surface is empty: the file holds no triangle");
  FileContents contents;
  contents.format = format;
  TriangulatedSurface surface;
  surface.name = std::move(name);
  surface.file = file.shown();
  const std::vector<VertexIndex> row = merge_equal_points(corners, surface.points);
  for (std::size_t i = 0; i + 2 < row.size(); i += 3) surface.triangles.push_back({row[i], row[i + 1], row[i + 2]});
  contents.surfaces.push_back(std::move(surface));
  return contents;
}

FileContents read_binary(const InputFile& file) {
  if (file.size() < header_bytes)
    file.fail("a binary STL file of " + std::to_string(file.size()) + " bytes is too short (truncated)");
  const std::uint64_t n = read_little<std::uint32_t>(file.bytes, 80);
  if (file.size() < header_bytes + facet_bytes * n) {
    file.fail("the header names " + std::to_string(n) + " triangles (" +
              std::to_string(header_bytes + facet_bytes * n) + " bytes), the file has " + std::to_string(file.size()) +
              " bytes (truncated, or not an STL file)");
  }
  std::vector<Vec3> corners;
  corners.reserve(static_cast<std::size_t>(3 * n));
  for (std::uint64_t t = 0; t < n; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = header_bytes + facet_bytes * static_cast<std::size_t>(t) + 12 + 12 * k;
      const Vec3 p{read_little<float>(file.bytes, at), read_little<float>(file.bytes, at + 4),
                   read_little<float>(file.bytes, at + 8)};
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        file.fail("triangle " + std::to_string(t) + " (counted from 0) has a coordinate that is not finite");
      }
      corners.push_back(p);
    }
  }
  FileContents contents = finish(file, "STL (binary)", file.path.stem().string(), std::move(corners));
  contents.notes.push_back("coordinates have single precision in the file");
  if (file.size() > header_bytes + facet_bytes * n) {
    contents.warnings.push_back(std::to_string(file.size() - header_bytes - facet_bytes * n) +
                                " bytes behind the last triangle are ignored");
  }
  return contents;
}

/// Reads one triangle of an ASCII STL file. The reader is at the line with `facet`; the triangle ends with `endfacet`.
void read_facet(LineReader& lines, std::vector<Vec3>& corners) {
  std::size_t n = 0;
  while (lines.next()) {
    Tokens tokens(lines.line());
    const std::string_view word = tokens.next();
    if (word.empty() || equals_ignoring_case(word, "outer") || equals_ignoring_case(word, "endloop")) continue;
    if (equals_ignoring_case(word, "vertex")) {
      corners.push_back(read_point(lines, tokens, "of the facet"));
      ++n;
    } else if (equals_ignoring_case(word, "endfacet")) {
      if (n != 3) lines.fail("a facet with " + std::to_string(n) + " vertices; 3 were expected");
      return;
    } else {
      lines.fail("expected vertex, endloop or endfacet, found " + in_quotes(lines.line()));
    }
  }
  lines.fail("the file ends within a facet (truncated)");
}

FileContents read_ascii(const InputFile& file) {
  LineReader lines(file);
  std::vector<Vec3> corners;
  std::size_t n_solids = 0;
  bool open = false;
  while (lines.next()) {
    Tokens tokens(lines.line());
    const std::string_view word = tokens.next();
    if (word.empty()) continue;
    if (equals_ignoring_case(word, "solid")) {
      if (open) lines.fail("a new solid begins before the endsolid of the one before");
      open = true;
      ++n_solids;
    } else if (equals_ignoring_case(word, "endsolid")) {
      open = false;
    } else if (equals_ignoring_case(word, "facet") && open) {
      read_facet(lines, corners);
    } else {
      lines.fail("expected facet or endsolid, found " + in_quotes(lines.line()));
    }
  }
  if (open) lines.fail("the file ends without endsolid (truncated)");
  FileContents contents = finish(file, "STL (ASCII)", file.path.stem().string(), std::move(corners));
  if (n_solids > 1) contents.notes.push_back(std::to_string(n_solids) + " solids are read as one surface");
  return contents;
}

}  // namespace

bool is_stl(const InputFile& file) {
  if (has_binary_size(file)) return true;
  if (begins_with_solid(file))
    return file.text().substr(0, 4096).find("facet") != std::string_view::npos || file.extension() == ".stl";
  return file.extension() == ".stl";
}

FileContents read_stl(const InputFile& file) {
  const bool ascii = begins_with_solid(file) && !has_binary_size(file) && !looks_binary(file);
  return ascii ? read_ascii(file) : read_binary(file);
}

}  // namespace geomesh::geomodel

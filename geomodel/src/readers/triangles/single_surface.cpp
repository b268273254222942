// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/triangles/single_surface.hpp"

#include "readers/triangles/polygon.hpp"

namespace geomesh::geomodel {

SurfaceBuilder::SurfaceBuilder(const InputFile& file, std::string name) : file_(file) {
  surface_.name = std::move(name);
  surface_.file = file.shown();
}

void SurfaceBuilder::fail(std::size_t line, const std::string& message) const {
  if (line == 0) file_.fail(message);
  file_.fail(line, message);
}

void SurfaceBuilder::add_polygon(const std::vector<std::int64_t>& polygon, std::size_t line) {
  if (polygon.size() < 3)
    fail(line, "a face has " + std::to_string(polygon.size()) + " vertices; at least 3 were expected");
  loop_.clear();
  for (const std::int64_t v : polygon) {
    if (v < 0 || static_cast<std::uint64_t>(v) >= surface_.points.size()) {
      fail(line, "a face names vertex row " + std::to_string(v) + " (counted from 0), but there are " +
                     std::to_string(surface_.points.size()) + " vertices");
    }
    loop_.push_back(static_cast<VertexIndex>(v));
  }
  if (!append_polygon(surface_.points, loop_, surface_.triangles)) {
    fail(line, "a face of " + std::to_string(polygon.size()) +
                   " vertices is flat or crosses itself and cannot be split into triangles; give it as triangles");
  }
  if (polygon.size() > 3) ++n_split_;
}

FileContents one_surface(const InputFile& file, std::string format, SurfaceBuilder&& builder) {
  if (builder.empty()) file.fail("the surface is empty: the file holds no triangle");
  FileContents contents;
  contents.format = std::move(format);
  note_split_polygons(builder.n_split(), contents);
  contents.surfaces.push_back(builder.take());
  return contents;
}

void note_split_polygons(std::size_t n_split, FileContents& contents) {
  if (n_split > 0) {
    contents.notes.push_back(std::to_string(n_split) +
                             " polygon(s) of more than three corners were split into triangles");
  }
}

}  // namespace geomesh::geomodel

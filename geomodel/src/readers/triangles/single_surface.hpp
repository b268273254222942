// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Code shared by the readers of formats with a single surface in each file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

/// Collects the points and polygons of one surface from its file, and checks that the points of each polygon exist.
class SurfaceBuilder {
 public:
  SurfaceBuilder(const InputFile& file, std::string name);
  explicit SurfaceBuilder(const InputFile& file) : SurfaceBuilder(file, file.path.stem().string()) {}

  std::vector<Vec3>& points() { return surface_.points; }
  /// Adds a polygon whose point indices start at 0. `line` is for messages; 0 means that the line is not known.
  void add_polygon(const std::vector<std::int64_t>& polygon, std::size_t line);
  bool empty() const { return surface_.triangles.empty(); }
  std::size_t n_split() const { return n_split_; }
  TriangulatedSurface take() { return std::move(surface_); }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& message) const;

  const InputFile& file_;
  TriangulatedSurface surface_;
  std::vector<VertexIndex> loop_;
  std::size_t n_split_ = 0;  ///< number of polygons that were divided into several triangles
};

/// Returns the surface that `builder` collected as the contents of a file; throws if the surface has no triangle.
FileContents one_surface(const InputFile& file, std::string format, SurfaceBuilder&& builder);

void note_split_polygons(std::size_t n_split, FileContents& contents);

}  // namespace geomesh::geomodel

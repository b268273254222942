// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Shared by the readers of formats with a single mesh per file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

/// Collects polygons and points of one surface with checked indices.
class SurfaceBuilder {
 public:
  SurfaceBuilder(const InputFile& file, std::string name);
  explicit SurfaceBuilder(const InputFile& file) : SurfaceBuilder(file, file.path.stem().string()) {}

  std::vector<Vec3>& points() { return surface_.points; }
  /// `line` 0 means no line in messages. Indices start at 0.
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

/// Returns contents with that one surface; throws if it has no triangle.
FileContents one_surface(const InputFile& file, std::string format, SurfaceBuilder&& builder);

/// Adds a note if polygons were divided.
void note_split_polygons(std::size_t n_split, FileContents& contents);

}  // namespace geomesh::geomodel

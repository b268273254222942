// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks the cells of VTK files: offsets ascend, corners exist, and the number of corners fits the type.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "vtk_files/vtk_data.hpp"

namespace geomesh::geomodel {

struct CellLists {
  std::vector<std::int64_t> ends;  ///< for each cell, where its list of corners ends in `corners`
  std::vector<std::int64_t> corners;
};

/// Throws Error{invalid_input} if the offsets of cells descend or are negative.
void require_rising(const InputFile& file, const std::vector<std::int64_t>& ends);

/// Points of a VTK image, with equal steps along three axes.
struct ImageLattice {
  std::array<double, 3> origin{}, spacing{};
  std::array<double, 9> direction{};  ///< directions of the image's axes, as a matrix in rows
  std::array<std::int64_t, 3> first{};
  std::array<std::size_t, 3> n{};  ///< of points
};

class CellBuilder {
 public:
  enum class Shape { verts, lines, polys, strips };
  CellBuilder(const InputFile& file, VtkData& data) : file_(file), data_(data) {}

  /// Adds the cells of a VTK unstructured grid. The corners in `lists` count from the point `first_point`.
  void add_grid(const CellLists& lists, const std::vector<std::int64_t>& types, std::size_t first_point);
  void add_poly(Shape shape, const CellLists& lists, std::size_t first_point);
  void add_image(const ImageLattice& lattice);

 private:
  void add_corners(const CellLists& lists, std::size_t cell, std::size_t first_point);

  const InputFile& file_;
  VtkData& data_;
};

}  // namespace geomesh::geomodel

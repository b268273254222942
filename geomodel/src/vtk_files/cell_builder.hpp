// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Cells of VTK's files, checked: offsets that rise, corners that are there, as many as the type has.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "vtk_files/vtk_data.hpp"

namespace geomesh::geomodel {

/// Lists one after the other.
struct CellLists {
  std::vector<std::int64_t> ends;  ///< by list, into `corners`
  std::vector<std::int64_t> corners;
};

/// Throws Error{invalid_input} where they fall or are negative.
void require_rising(const InputFile& file, const std::vector<std::int64_t>& ends);

/// Points of an image: equal steps along three axes.
struct ImageLattice {
  std::array<double, 3> origin{}, spacing{};
  std::array<double, 9> direction{};  ///< rows of a matrix
  std::array<std::int64_t, 3> first{};
  std::array<std::size_t, 3> n{};  ///< of points
};

/// Adds cells to the data of one file. Throws Error{invalid_input} where they are damaged.
class CellBuilder {
 public:
  enum class Shape { verts, lines, polys, strips };
  CellBuilder(const InputFile& file, VtkData& data) : file_(file), data_(data) {}

  /// `first_point`: row of the point that the lists count from.
  void add_grid(const CellLists& lists, const std::vector<std::int64_t>& types, std::size_t first_point);
  void add_poly(Shape shape, const CellLists& lists, std::size_t first_point);
  /// The points too.
  void add_image(const ImageLattice& lattice);

 private:
  void add_corners(const CellLists& lists, std::size_t cell, std::size_t first_point);

  const InputFile& file_;
  VtkData& data_;
};

}  // namespace geomesh::geomodel

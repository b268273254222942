// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_files/cell_builder.hpp"

#include <string>

namespace geomesh::geomodel {
namespace {

std::string cell_name(std::size_t cell) { return "cell " + std::to_string(cell) + " (counted from 0)"; }

/// Returns the number of corners of a VTK cell type; 0 if it varies.
std::size_t n_corners_of(std::int64_t type) {
  constexpr std::array<std::size_t, 37> n{0, 1, 0, 2, 0, 3, 0,  0,  4,  4,  4, 8,  8, 6,  5,  10, 12, 0,
                                          0, 0, 0, 3, 6, 8, 10, 20, 15, 13, 9, 27, 6, 12, 18, 24, 7,  4};
  return type >= 0 && static_cast<std::size_t>(type) < n.size() ? n[static_cast<std::size_t>(type)] : 0;
}

std::uint8_t type_of_poly(CellBuilder::Shape shape, std::size_t n) {
  switch (shape) {
    case CellBuilder::Shape::verts:
      return n == 1 ? vtk_cell::vertex : vtk_cell::poly_vertex;
    case CellBuilder::Shape::lines:
      return n == 2 ? vtk_cell::line : vtk_cell::poly_line;
    case CellBuilder::Shape::strips:
      return vtk_cell::triangle_strip;
    default:
      return n == 3 ? vtk_cell::triangle : n == 4 ? vtk_cell::quad : vtk_cell::polygon;
  }
}

}  // namespace

void require_rising(const InputFile& file, const std::vector<std::int64_t>& ends) {
  std::int64_t before = 0;
  for (const std::int64_t end : ends) {
    if (end < before) file.fail("the offsets of its cells do not fit their connectivity (damaged)");
    before = end;
  }
}

/// Adds the corners of one cell to the VTK data. Precondition: the ends of the cells' lists of corners are ascending.
void CellBuilder::add_corners(const CellLists& lists, std::size_t cell, std::size_t first_point) {
  const auto begin = cell == 0 ? std::size_t{0} : static_cast<std::size_t>(lists.ends[cell - 1]);
  const auto end = static_cast<std::size_t>(lists.ends[cell]);
  if (end > lists.corners.size()) file_.fail("the offsets of its cells do not fit their connectivity (damaged)");
  const std::size_t n_points = data_.points.size() - first_point;
  for (std::size_t i = begin; i < end; ++i) {
    const std::int64_t row = lists.corners[i];
    if (row < 0 || static_cast<std::size_t>(row) >= n_points)
      file_.fail(cell_name(data_.cells.size()) + " names point " + std::to_string(row) + " of " +
                 std::to_string(n_points));
    data_.cells.corners.push_back(static_cast<VertexIndex>(first_point + static_cast<std::size_t>(row)));
  }
  data_.cells.first.push_back(data_.cells.corners.size());
}

void CellBuilder::add_grid(const CellLists& lists, const std::vector<std::int64_t>& types, std::size_t first_point) {
  for (std::size_t cell = 0; cell < lists.ends.size(); ++cell) {
    add_corners(lists, cell, first_point);
    const std::size_t n = data_.cells.first.back() - data_.cells.first[data_.cells.first.size() - 2];
    const std::int64_t type = types[cell];
    if (type < 0 || type > 255) file_.fail(cell_name(data_.cells.size()) + " has no known type (damaged)");
    if (const std::size_t wanted = n_corners_of(type); wanted != 0 && n != wanted)
      file_.fail(cell_name(data_.cells.size()) + " of type " + std::to_string(type) + " has " + std::to_string(n) +
                 " corners; " + std::to_string(wanted) + " were expected");
    data_.cells.types.push_back(static_cast<std::uint8_t>(type));
  }
}

void CellBuilder::add_poly(Shape shape, const CellLists& lists, std::size_t first_point) {
  const std::size_t least = shape == Shape::verts ? 1 : shape == Shape::lines ? 2 : 3;
  for (std::size_t cell = 0; cell < lists.ends.size(); ++cell) {
    add_corners(lists, cell, first_point);
    const std::size_t n = data_.cells.first.back() - data_.cells.first[data_.cells.first.size() - 2];
    if (n < least)
      file_.fail(cell_name(data_.cells.size()) + " has " + std::to_string(n) + " corners; at least " +
                 std::to_string(least) + " were expected");
    data_.cells.types.push_back(type_of_poly(shape, n));
  }
}

void CellBuilder::add_image(const ImageLattice& lattice) {
  const std::array<std::size_t, 3>& n = lattice.n;
  const std::size_t before = data_.points.size();
  if (n[0] * n[1] * n[2] >= no_vertex - before) file_.fail("it holds more points than 32 bits can count");
  std::array<double, 3> at{};
  for (std::size_t i = 0; i < n[0] * n[1] * n[2]; ++i) {
    const std::array<std::size_t, 3> step{i % n[0], i / n[0] % n[1], i / n[0] / n[1]};
    for (std::size_t k = 0; k < 3; ++k)
      at[k] = lattice.spacing[k] * static_cast<double>(lattice.first[k] + static_cast<std::int64_t>(step[k]));
    Vec3 p;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = lattice.origin[k] + lattice.direction[3 * k] * at[0] + lattice.direction[3 * k + 1] * at[1] +
             lattice.direction[3 * k + 2] * at[2];
    data_.points.push_back(p);
  }
  const std::array<std::size_t, 3> n_cells{std::max<std::size_t>(n[0], 2) - 1, std::max<std::size_t>(n[1], 2) - 1,
                                           std::max<std::size_t>(n[2], 2) - 1};
  const std::size_t n_axes = (n[0] > 1) + (n[1] > 1) + (n[2] > 1);
  constexpr std::array<std::uint8_t, 4> types{vtk_cell::vertex, vtk_cell::line, vtk_cell::pixel, vtk_cell::voxel};
  for (std::size_t c = 0; c < n_cells[0] * n_cells[1] * n_cells[2]; ++c) {
    const std::array<std::size_t, 3> first{c % n_cells[0], c / n_cells[0] % n_cells[1], c / n_cells[0] / n_cells[1]};
    for (std::size_t z = 0; z < (n[2] > 1 ? 2 : 1); ++z)
      for (std::size_t y = 0; y < (n[1] > 1 ? 2 : 1); ++y)
        for (std::size_t x = 0; x < (n[0] > 1 ? 2 : 1); ++x)
          data_.cells.corners.push_back(
              static_cast<VertexIndex>(before + first[0] + x + n[0] * (first[1] + y + n[1] * (first[2] + z))));
    data_.cells.first.push_back(data_.cells.corners.size());
    data_.cells.types.push_back(types[n_axes]);
  }
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/omf/omf_grid.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double clearly = 0.5;

/// Returns the node offsets of an OMF grid in rows along u; with `u_first` the file lists them in this order already.
std::vector<double> in_rows(const OmfGrid& grid, bool u_first) {
  if (u_first) return grid.offsets;
  std::vector<double> rows(grid.offsets.size());
  for (std::size_t i = 0; i < grid.n_columns(); ++i)
    for (std::size_t j = 0; j < grid.n_rows(); ++j)
      rows[j * grid.n_columns() + i] = grid.offsets[i * grid.n_rows() + j];
  return rows;
}

/// Returns the sum of the squared height differences between neighbouring nodes of a grid.
double roughness(const std::vector<double>& rows, std::size_t n_columns) {
  double sum = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if ((k + 1) % n_columns != 0) sum += (rows[k + 1] - rows[k]) * (rows[k + 1] - rows[k]);
    if (k + n_columns < rows.size()) sum += (rows[k + n_columns] - rows[k]) * (rows[k + n_columns] - rows[k]);
  }
  return sum;
}

std::optional<std::vector<double>> ordered_offsets(const OmfGrid& grid) {
  if (grid.offsets.empty()) return std::vector<double>(grid.n_columns() * grid.n_rows(), 0.0);
  std::vector<double> along_u = in_rows(grid, true), along_v = in_rows(grid, false);
  if (along_u == along_v) return along_u;
  const double u = roughness(along_u, grid.n_columns()), v = roughness(along_v, grid.n_columns());
  if (u <= clearly * v) return along_u;
  if (v <= clearly * u) return along_v;
  return std::nullopt;
}

}  // namespace

std::optional<NodeLattice> nodes_of(const OmfGrid& grid) {
  const auto offsets = ordered_offsets(grid);
  if (!offsets) return std::nullopt;
  const Vec3 axis_w = cross(grid.axis_u, grid.axis_v);
  NodeLattice lattice{grid.n_columns(), grid.n_rows(), {}};
  double v = 0;
  for (std::size_t j = 0; j < grid.n_rows(); ++j) {
    double u = 0;
    for (std::size_t i = 0; i < grid.n_columns(); ++i) {
      lattice.nodes.push_back(grid.origin + u * grid.axis_u + v * grid.axis_v +
                              (*offsets)[j * grid.n_columns() + i] * axis_w);
      if (i < grid.cells_u.size()) u += grid.cells_u[i];
    }
    if (j < grid.cells_v.size()) v += grid.cells_v[j];
  }
  return lattice;
}

}  // namespace geomesh::geomodel

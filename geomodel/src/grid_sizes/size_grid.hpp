// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Target sizes at points, read from a file as a background grid for refinement.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/refinement.hpp"

namespace geomesh::geomodel {

/// Sizes at points as a function of place. Points at all nodes of a lattice along the axes (any spacings): linear in
/// each axis between them. Others: mean of the eight nearest, weighted by one over the squared distance (Shepard 1968).
/// Beyond the points: the size at the nearest place of the lattice, or by the same weights.
class SizeGrid {
 public:
  /// Precondition: as many sizes as points, at least one. If points coincide, the first is used.
  SizeGrid(std::vector<Vec3> points, std::vector<double> sizes);

  double at(const Vec3& p) const;
  bool is_lattice() const { return !lattice_.empty(); }
  std::size_t n_points() const { return points_.size(); }

 private:
  struct Near {
    double squared_distance;
    Index row;
    friend auto operator<=>(const Near&, const Near&) = default;
  };
  bool make_lattice();
  void sort_tree(Index begin, Index end, unsigned axis);
  void find_nearest(const Vec3& p, Index begin, Index end, unsigned axis, std::vector<Near>& heap) const;
  double on_lattice(const Vec3& p) const;
  double weighted(const Vec3& p) const;

  std::vector<Vec3> points_;
  std::vector<double> sizes_;
  std::array<std::vector<double>, 3> axes_;  ///< coordinates of the lattice's nodes, ascending
  std::vector<double> lattice_;              ///< size by node, x fastest; empty if there is no lattice
  std::vector<Index> order_;  ///< rows as a balanced tree: the median of a range is in its middle, and axes alternate
};

/// Reads
///   - text (.csv, .txt, .xyz, ...): x y z size on each line, by blanks or a separator, a header line allowed;
///   - .vti, .vtu, .vtp: the point array `size`, or the cell array `size` at the cells' centres (as geomesh writes it).
/// Throws Error{usage} where the file cannot be opened, Error{invalid_input} where it holds no sizes or one that is not
/// positive.
SizeGrid read_size_grid(const std::filesystem::path& file);

/// Reads any finite numbers in the same way: lines of x y z value, or the array of that name.
SizeGrid read_value_grid(const std::filesystem::path& file, const std::string& array);

/// If the sizes name a background file, reads it into base.background. `origin` was subtracted from the model's
/// coordinates, but not from the file's.
void load_background(NamedSizes& sizes, const Vec3& origin);

}  // namespace geomesh::geomodel

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

/// Interpolates target sizes that are given at points. Points at all nodes of an axis-parallel lattice (with any
/// spacings) are interpolated linearly along each axis. For other points the size is the mean at the eight nearest
/// ones, weighted by the inverse squared distance (Shepard 1968). Outside the lattice the nearest size counts.
class SizeGrid {
 public:
  /// Each point has one size. Precondition: there is at least one point. If points coincide, the size of the first one
  /// counts.
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
  std::array<std::vector<double>, 3> axes_;  ///< by axis: coordinates of the nodes of the lattice, ascending
  std::vector<double> lattice_;  ///< size at each node of the lattice, x fastest; empty if there is no lattice
  std::vector<Index> order_;     ///< k-d tree of points: the median of a range is in its middle, and axes alternate
};

/// Reads target sizes at points from a file:
///   - text (.csv, .txt, .xyz, ...) with x y z size on each line, separated by blanks or a separator; a header line is
/// allowed;
///   - .vti, .vtu, .vtp: the point array `size`, or the cell array `size` at the cells' centres (as geomesh writes it).
/// Throws Error{usage} if the file cannot be opened, Error{invalid_input} if it has no sizes or one that is not
/// positive.
SizeGrid read_size_grid(const std::filesystem::path& file);

/// Reads numbers at points, which need not be positive, in the formats of read_size_grid: lines of x y z value, or a
/// VTK file with the given array.
SizeGrid read_value_grid(const std::filesystem::path& file, const std::string& array);

/// If the settings name a background file of target sizes, reads it into base.background. `origin` was subtracted from
/// the model's coordinates, but not from those in the file.
void load_background(NamedSizes& sizes, const Vec3& origin);

}  // namespace geomesh::geomodel

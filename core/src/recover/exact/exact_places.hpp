// SPDX-License-Identifier: MIT
/// @file
/// Vertices of the mesh under recovery whose places are not doubles but exact sums of doubles. A Steiner point at a
/// dyadic parameter of its segment, or of its facet's plane, lies on it exactly in this form; rounded it would not.
///
/// The nearest doubles of each such place are also stored (ConstrainedMesh::point), for inexact computations.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "predicates/filters.hpp"
#include "predicates/long_expansion.hpp"

namespace geomesh::recover {

struct ExactPlace {
  std::array<exact::LongExpansion, 3> coordinates;
  /// Vertices on whose line (two of them) or in whose plane (three) the place lies exactly; the others are no_vertex.
  std::array<VertexIndex, 3> frame{no_vertex, no_vertex, no_vertex};
  /// For a place on a line: coordinates = (1 - parameter) * frame[0] + parameter * frame[1].
  exact::LongExpansion parameter{};

  bool is_on_line() const { return frame[1] != no_vertex && frame[2] == no_vertex; }
  bool is_in_plane() const { return frame[2] != no_vertex; }
  Vec3 nearest() const { return {coordinates[0].estimate(), coordinates[1].estimate(), coordinates[2].estimate()}; }
  /// Returns whether products of three differences of coordinates of this size and precision can be computed exactly.
  bool is_safe() const;
};

class ExactPlaces {
 public:
  bool empty() const { return rows_.empty(); }
  bool contains(VertexIndex v) const {
    return v >= first_ && v - first_ < row_of_.size() && row_of_[v - first_] != no_index;
  }
  const ExactPlace& of(VertexIndex v) const { return rows_[row_of_[v - first_]].place; }

  void set(VertexIndex v, ExactPlace place);
  void erase(VertexIndex v);

  /// Returns the orientation of four vertices like orient3d. At least one of them must have an exact place. `points`
  /// are the nearest doubles of all vertices.
  Sign orient(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const;
  /// Returns the orientation of the coordinates (i, j) of three vertices like orient2d.
  Sign orient_flat(const std::vector<Vec3>& points, const std::array<VertexIndex, 3>& v, std::size_t i,
                   std::size_t j) const;
  /// Returns six times the signed volume of the tetrahedron v, whose vertices may have exact places, exactly.
  exact::LongExpansion volume(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const;
  /// Returns six times the signed volume of the tetrahedron v with a relative error of less than 2^-20.
  double rough_volume(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const;
  /// Error of a determinant of three rounded vectors from one vertex: `widening` times that for doubles, plus `slack`.
  struct OffsetError {
    double widening = 1, slack = 0;
  };
  OffsetError offset_error(const std::vector<Vec3>& points, VertexIndex from, std::span<const VertexIndex> to) const;
  /// Returns the vector between two vertices, each coordinate with a negligible error.
  Vec3 offset(const std::vector<Vec3>& points, VertexIndex from, VertexIndex to) const;
  exact::LongExpansion coordinate(const std::vector<Vec3>& points, VertexIndex v, std::size_t i) const;

  /// Returns the exact place of v minus the nearest point in doubles, rounded; zero if v has double coordinates.
  Vec3 rest_of(VertexIndex v) const { return contains(v) ? rows_[row_of_[v - first_]].rest : Vec3{}; }
  /// Returns how many orientations have been decided: a measure of work that is the same on every machine.
  std::size_t n_decided() const { return n_decided_; }
  void count_decided(std::size_t n) const { n_decided_ += n; }

 private:
  struct Row {
    ExactPlace place;
    Vec3 rest;                     ///< exact place minus the nearest point with double coordinates, rounded
    bool is_between_ends = false;  ///< whether the vertex was placed on a line, strictly between its two end vertices
  };
  /// Six times a tetrahedron's volume in doubles with its error bound, and two terms of the next filter's bound.
  struct Rough {
    filter::Estimate plain;
    double product = 0, by_rests = 0;
  };
  Rough rough(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const;
  filter::Estimate sharp(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v, const Rough& of) const;
  filter::Estimate of_nearest(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const;
  std::optional<Sign> side_of_line(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const;
  Sign side_of_end(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const;
  Sign decide(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const;
  bool are_in_plane_across_axis(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const;
  bool are_declared_flat(const std::array<VertexIndex, 4>& v) const;

  VertexIndex first_ = no_vertex;  ///< smallest index of a vertex that ever had an exact place
  std::vector<Index> row_of_;      ///< by vertex from first_ on: row in rows_; no_index if its coordinates are doubles
  std::vector<Row> rows_;
  mutable std::size_t n_decided_ = 0;
};

}  // namespace geomesh::recover

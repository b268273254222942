// SPDX-License-Identifier: MIT
/// @file
/// The predicates of incremental triangulation in 3D, for point records, with the fast paths inlined.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "delaunay/kernels/point_record.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "predicates/exact_stage.hpp"
#include "predicates/filters.hpp"

namespace geomesh {

/// A space decides on which side of a face a point lies, and with which cells it is in conflict. Apart from the
/// dimension, it is all that differs between the incremental algorithms in 2D, in the plane of a facet and in 3D.
///
/// Lattices and rounded data have coordinates that are multiples of one power of two. Plain determinants are then exact
/// in doubles for differences of up to 512 units, because 72 * 512^5 < 2^53, and ties need no expansions.
class Space3 {
 public:
  static constexpr int dimension = 3;
  using Record = PointRecord;
  using CellVertices = TetMesh::CellVertices;

  /// `points[infinite]` must exist; its coordinates become NaN, so that no filter decides anything about this point.
  /// All coordinates are multiples of `unit`, which is 0 if no such unit is known.
  Space3(PointRecord* points, VertexIndex infinite, double unit)
      : points_(points), infinite_(infinite), exact_reach_(512 * unit) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    static_cast<Vec3&>(points[infinite]) = {nan, nan, nan};
  }

  PointRecord& record(VertexIndex v) const { return points_[v]; }
  VertexIndex infinite() const { return infinite_; }
  std::size_t exact_calls() const { return exact_calls_; }
  double exact_reach() const { return exact_reach_; }

  /// Returns the orientation of p with face `face` of a finite cell: negative if p is beyond the face.
  Sign side(const CellVertices& v, unsigned face, const Vec3& p) {
    const auto& f = face_vertices[face];
    return orientation(points_[v[f[0]]], points_[v[f[1]]], points_[v[f[2]]], p);
  }

  bool finite_conflict(const CellVertices& v, const Vec3& p) {
    const Vec3 &a = points_[v[0]], &b = points_[v[1]], &c = points_[v[2]], &d = points_[v[3]];
    const filter::Estimate estimate = filter::in_sphere(a, b, c, d, p);
    if (estimate.certain()) [[likely]]
      return estimate.value > 0;
    return finite_conflict_after_filter(a, b, c, d, p, estimate.value);
  }

  /// Returns whether p is in conflict with a finite cell if the filter left the determinant `value` undecided.
  bool finite_conflict(const CellVertices& v, const Vec3& p, double value) {
    return finite_conflict_after_filter(points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]], p, value);
  }

  /// Returns whether p is strictly beyond the ghost's face, or in the plane of the face and inside its circumcircle.
  bool ghost_conflict(const CellVertices& v, const Vec3& p) {
    unsigned g = 0;
    while (v[g] != infinite_) ++g;
    const auto& f = face_vertices[g];
    const Vec3 &a = points_[v[f[0]]], &b = points_[v[f[1]]], &c = points_[v[f[2]]];
    const Sign s = orientation(a, b, c, p);
    if (s != Sign::zero) return s == Sign::positive;
    return in_circle_coplanar_perturbed(a, b, c, p) == Sign::positive;
  }

  double squared_distance(VertexIndex v, const Vec3& p) const {
    const Vec3 d = points_[v] - p;
    return dot(d, d);
  }

  Sign orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const filter::Estimate estimate = filter::orient3d(a, b, c, p);
    if (estimate.certain()) [[likely]]
      return estimate.sign();
    if (within_exact_reach(a, p) && within_exact_reach(b, p) && within_exact_reach(c, p))
      return sign_of(estimate.value);
    return detail::orient3d_after_filter(a, b, c, p, exact_calls_);
  }

 private:
  static Sign sign_of(double x) { return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero; }
  bool within_exact_reach(const Vec3& a, const Vec3& p) const {
    return std::fabs(a.x - p.x) <= exact_reach_ && std::fabs(a.y - p.y) <= exact_reach_ &&
           std::fabs(a.z - p.z) <= exact_reach_;
  }
  bool finite_conflict_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p,
                                    double value);
  bool near_tie_conflict(const std::array<Vec3, 4>& r);
  bool tie_conflict(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p);

  PointRecord* points_;
  VertexIndex infinite_;
  double exact_reach_;
  std::size_t exact_calls_ = 0;
};

/// Returns the largest power of two that divides all coordinates, or 0 if plain determinants would not be exact.
double coordinate_unit(std::span<const Vec3> points);

}  // namespace geomesh

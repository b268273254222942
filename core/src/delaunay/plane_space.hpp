// SPDX-License-Identifier: MIT
/// @file
/// The predicates of incremental triangulation in a plane that lies in space.
#pragma once

#include "delaunay/kernels/point_record.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// Projects points along an axis: the result is (y, z), (z, x) or (x, y), or these exchanged.
struct PlaneProjection {
  enum class Handedness { right, left };
  int axis = 2;
  Handedness handedness = Handedness::right;

  Vec2 operator()(const Vec3& p) const {
    const Vec2 q = axis == 0 ? Vec2{p.y, p.z} : axis == 1 ? Vec2{p.z, p.x} : Vec2{p.x, p.y};
    return handedness == Handedness::right ? q : Vec2{q.y, q.x};
  }
};

/// The exact orientation and conflict predicates for triangulating exactly coplanar points in space. Orientations are
/// those of a projection along an axis that is not parallel to the plane.
class PlaneSpace {
 public:
  static constexpr int dimension = 2;
  using CellVertices = TriMesh::CellVertices;

  PlaneSpace(PointRecord* points, VertexIndex infinite, PlaneProjection projection)
      : points_(points), infinite_(infinite), project_(projection) {}

  PointRecord& record(VertexIndex v) const { return points_[v]; }
  VertexIndex infinite() const { return infinite_; }

  Sign orient(VertexIndex a, VertexIndex b, VertexIndex c) const {
    return orientation(points_[a], points_[b], points_[c]);
  }
  /// Returns the orientation of p with edge `face` of a finite cell: negative if p is beyond the edge.
  Sign side(const CellVertices& v, unsigned face, const Vec3& p) const {
    return orientation(points_[v[(face + 1) % 3]], points_[v[(face + 2) % 3]], p);
  }
  bool finite_conflict(const CellVertices& v, const Vec3& p) const {
    return in_circle_coplanar_perturbed(points_[v[0]], points_[v[1]], points_[v[2]], p) == Sign::positive;
  }
  /// Returns whether p is strictly beyond the ghost's edge, or on its line strictly between its ends.
  bool ghost_conflict(const CellVertices& v, const Vec3& p) const {
    unsigned g = 0;
    while (v[g] != infinite_) ++g;
    const Vec3 &a = points_[v[(g + 1) % 3]], &b = points_[v[(g + 2) % 3]];
    const Sign s = orientation(a, b, p);
    if (s != Sign::zero) return s == Sign::positive;
    return compare_lexicographic(a, p) * compare_lexicographic(p, b) > 0;
  }
  double squared_distance(VertexIndex v, const Vec3& p) const {
    const Vec3 d = points_[v] - p;
    return dot(d, d);
  }

 private:
  Sign orientation(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return orient2d(project_(a), project_(b), project_(c));
  }

  PointRecord* points_;
  VertexIndex infinite_;
  PlaneProjection project_;
};

}  // namespace geomesh

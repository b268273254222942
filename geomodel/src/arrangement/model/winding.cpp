// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/model/winding.hpp"

#include <algorithm>

#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

struct DoubleQuery {
  const Vec3& q;
  Sign planar(const Vec3& a, const Vec3& b, std::size_t i, std::size_t j) const {
    return orient2d({a[i], a[j]}, {b[i], b[j]}, {q[i], q[j]});
  }
  Sign side(const Vec3& a, const Vec3& b, const Vec3& c) const { return orient3d(a, b, c, q); }
};

struct ExactQuery {
  const ExactFrame& frame;
  const ExactPoint& q;
  Sign planar(const Vec3& a, const Vec3& b, std::size_t i, std::size_t j) const {
    return exact_orient2d(frame.to_exact(a), frame.to_exact(b), q, i, j);
  }
  Sign side(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return exact_orient3d(frame.to_exact(a), frame.to_exact(b), frame.to_exact(c), q);
  }
};

Sign sign_of_difference(double a, double b) { return a > b ? Sign::positive : a < b ? Sign::negative : Sign::zero; }

/// Returns the sign of the area of the triangle of a, b and q after q is shifted by (e, e^2) for an infinitesimal e >
/// 0. It is zero only if a and b coincide in the projection.
template <typename Query>
Sign shifted_planar(const Query& query, const Vec3& a, const Vec3& b, std::size_t i, std::size_t j) {
  const Sign s = query.planar(a, b, i, j);
  if (s != Sign::zero) return s;
  const Sign first = sign_of_difference(a[j], b[j]);
  return first != Sign::zero ? first : sign_of_difference(b[i], a[i]);
}

}  // namespace

WindingNumber::WindingNumber(std::span<const Vec3> points, std::vector<Triangle> triangles)
    : points_(points), triangles_(std::move(triangles)) {
  for (const Triangle& t : triangles_)
    for (const VertexIndex v : t) box_.add(points_[v]);
}

int WindingNumber::contribution(Index t, std::size_t axis) const {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Vec3 &a = points_[triangles_[t][0]], &b = points_[triangles_[t][1]], &c = points_[triangles_[t][2]];
  return static_cast<int>(orient2d({a[i], a[j]}, {b[i], b[j]}, {c[i], c[j]}));
}

template <typename Query>
int WindingNumber::count(const Query& query, const Vec3& rounded, RayDirection ray, std::span<const Index> skip) const {
  const std::size_t k = ray.axis, i = (k + 1) % 3, j = (k + 2) % 3;
  int winding = 0;
  for (Index t = 0; t < triangles_.size(); ++t) {
    const Vec3 &a = points_[triangles_[t][0]], &b = points_[triangles_[t][1]], &c = points_[triangles_[t][2]];
    // Rounding is monotone: a point outside the triangle's box in doubles is outside it exactly.
    if (rounded[i] > std::max({a[i], b[i], c[i]}) || rounded[i] < std::min({a[i], b[i], c[i]})) continue;
    if (rounded[j] > std::max({a[j], b[j], c[j]}) || rounded[j] < std::min({a[j], b[j], c[j]})) continue;
    if (ray.up ? rounded[k] > std::max({a[k], b[k], c[k]}) : rounded[k] < std::min({a[k], b[k], c[k]})) continue;
    const Sign turn = orient2d({a[i], a[j]}, {b[i], b[j]}, {c[i], c[j]});
    if (turn == Sign::zero || std::binary_search(skip.begin(), skip.end(), t)) continue;
    if (shifted_planar(query, a, b, i, j) != turn || shifted_planar(query, b, c, i, j) != turn ||
        shifted_planar(query, c, a, i, j) != turn)
      continue;
    const Sign above = query.side(a, b, c) * turn;
    if (above == (ray.up ? Sign::negative : Sign::positive))
      winding += ray.up ? static_cast<int>(turn) : -static_cast<int>(turn);
  }
  return winding;
}

int WindingNumber::operator()(const ExactFrame& frame, const ExactPoint& q, const Vec3& rounded, RayDirection ray,
                              std::span<const Index> skip) const {
  return count(ExactQuery{frame, q}, rounded, ray, skip);
}
int WindingNumber::operator()(const Vec3& q, RayDirection ray) const { return count(DoubleQuery{q}, q, ray, {}); }

}  // namespace geomesh::geomodel::arrangement

namespace geomesh::geomodel {

int winding_number(const TriangulatedSurface& surface, const Vec3& p) {
  return arrangement::WindingNumber(surface.points, surface.triangles)(p, arrangement::RayDirection{});
}

}  // namespace geomesh::geomodel

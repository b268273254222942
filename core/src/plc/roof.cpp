// SPDX-License-Identifier: MIT
#include "plc/roof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "common/geometry.hpp"
#include "geomesh/core/predicates.hpp"
#include "plc/facet_triangulation.hpp"

namespace geomesh {

namespace {

/// Largest number of bits of a point's two coordinates in the plane: a millionth of the polygon's size suffices.
constexpr int most_bits = 20;

struct Circle {
  Vec3 centre;
  double radius;
};

Circle circumcircle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a, n = cross(u, v);
  const Vec3 to_centre = (0.5 / dot(n, n)) * (dot(u, u) * cross(v, n) + dot(v, v) * cross(n, u));
  return {a + to_centre, length(to_centre)};
}

class RoofBuilder {
 public:
  RoofBuilder(std::span<const Vec3> corners, const AxisChoice& axis_for)
      : points_(corners.begin(), corners.end()), n_(corners.size()) {
    if (!find_base(points_)) return;
    axis_ = axis_for(base());
    put_in_order();
    for (const Vec3& p : points_) flat_.push_back(projected(p));
    if (!find_base(flat_)) return;
    const Vec3 up = cross(flat_[base_[1]] - flat_[base_[0]], flat_[base_[2]] - flat_[base_[0]]);
    for (std::size_t i = 0; i < n_; ++i) {
      const Vec3 inward = cross(up, flat_[(i + 1) % n_] - flat_[i]);
      inward_.push_back((1 / length(inward)) * inward);
    }
  }

  std::optional<Roof> run() {
    if (inward_.empty()) return std::nullopt;
    for (std::size_t before = n_;;) {
      FacetFault fault;
      auto draft = triangulate_facet(flat_, polygon(), fault);
      if (!draft) return std::nullopt;
      std::vector<Triangle> low;
      for (const Triangle& t : draft->triangles)
        if (t[0] < n_ && t[1] < n_ && t[2] < n_) low.push_back(t);
      if (low.empty()) return roof(std::move(draft->triangles));
      if (low.size() >= before || !add_points(low)) return std::nullopt;
      before = low.size();
    }
  }

 private:
  /// Finds the largest of the triangles whose corners divide the border into thirds. It defines the plane of the
  /// polygon. Returns false if no such triangle has an area.
  bool find_base(const std::vector<Vec3>& corners) {
    double largest = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const std::array<std::size_t, 3> rows{i, (i + n_ / 3) % n_, (i + 2 * n_ / 3) % n_};
      const Vec3& a = corners[rows[0]];
      const Vec3 normal = cross(corners[rows[1]] - a, corners[rows[2]] - a);
      if (dot(normal, normal) <= largest) continue;
      base_ = rows;
      largest = dot(normal, normal);
    }
    return largest > 0;
  }
  std::array<Vec3, 3> base() const { return {points_[base_[0]], points_[base_[1]], points_[base_[2]]}; }
  /// Orders the polygon's corners, as projected along the axis, in a fixed sense of rotation from the least corner on.
  /// Polygons that are stacked along the axis then get inner points above each other, so that the spheres around the
  /// triangles of one roof contain no points of the other roofs.
  void put_in_order() {
    const auto [a, b, c] = base();
    is_turned_ = cross(projected(b - a), projected(c - a))[axis_] < 0;
    given_row_.resize(n_);
    std::iota(given_row_.begin(), given_row_.end(), VertexIndex{0});
    if (is_turned_) std::reverse(given_row_.begin(), given_row_.end());
    const auto is_less = [&](VertexIndex v, VertexIndex w) {
      return compare_lexicographic(projected(points_[v]), projected(points_[w])) < 0;
    };
    std::rotate(given_row_.begin(), std::min_element(given_row_.begin(), given_row_.end(), is_less), given_row_.end());
    std::vector<Vec3> ordered;
    for (const VertexIndex row : given_row_) ordered.push_back(points_[row]);
    points_ = std::move(ordered);
  }
  Vec3 projected(Vec3 p) const {
    p[axis_] = 0;
    return p;
  }
  FacetPolygon polygon() const {
    FacetPolygon out;
    out.loops.emplace_back(n_);
    std::iota(out.loops[0].begin(), out.loops[0].end(), VertexIndex{0});
    for (std::size_t v = n_; v < points_.size(); ++v) out.inner_points.push_back(static_cast<VertexIndex>(v));
    return out;
  }
  double distance_from_side(std::size_t i, const Vec3& p) const { return dot(inward_[i], p - flat_[i]); }

  /// Adds a point in the circumcircle of each triangle, unless a point added earlier by this call lies in the circle.
  bool add_points(const std::vector<Triangle>& triangles) {
    const auto first = static_cast<std::ptrdiff_t>(points_.size());
    for (const Triangle& t : triangles) {
      const Circle circle = circumcircle(flat_[t[0]], flat_[t[1]], flat_[t[2]]);
      const auto is_in_circle = [&](const Vec3& p) { return length(p - circle.centre) < circle.radius; };
      if (std::any_of(flat_.begin() + first, flat_.end(), is_in_circle)) continue;
      const auto place = place_near(towards(t, circle.centre), is_in_circle);
      if (!place || points_.size() >= 2 * n_) return false;
      points_.push_back(*place);
      flat_.push_back(projected(*place));
    }
    return true;
  }
  /// Returns a point on the line from the triangle's centroid to the centre of its circumcircle: that centre, unless it
  /// is too near the polygon's border; then a point at half of the centroid's distance from the border.
  Vec3 towards(const Triangle& t, const Vec3& centre) const {
    const Vec3 from = (1.0 / 3) * (flat_[t[0]] + flat_[t[1]] + flat_[t[2]]);
    double part = 1;
    for (std::size_t i = 0; i < n_; ++i) {
      const double here = distance_from_side(i, from), there = distance_from_side(i, centre);
      if (there < here) part = std::min(part, 0.5 * here / (here - there));
    }
    return from + part * (centre - from);
  }
  /// Returns an accepted point near x that lies exactly in the plane and is nearer to x than to the border. It is a sum
  /// of two vectors in the plane whose factors have as few bits as possible, because such sums are rounded less often,
  /// both here and when the model is sheared.
  template <class Accept>
  std::optional<Vec3> place_near(const Vec3& x, const Accept& is_accepted) const {
    const auto [a, b, c] = base();
    const Vec3 u = projected(b - a), v = projected(c - a), w = x - projected(a), up = cross(u, v);
    const double along_u = dot(cross(w, v), up) / dot(up, up), along_v = dot(cross(u, w), up) / dot(up, up);
    const double most_distance = 0.25 * rise_of(x);
    for (int bits = 1; bits <= most_bits; ++bits) {
      const auto rounded = [&](double t) { return std::ldexp(std::round(std::ldexp(t, bits)), -bits); };
      const Vec3 place = a + (rounded(along_u) * (b - a) + rounded(along_v) * (c - a));
      if (length(projected(place) - x) < most_distance && is_accepted(projected(place)) &&
          orient3d(a, b, c, place) == Sign::zero)
        return place;
    }
    return std::nullopt;
  }
  double rise_of(const Vec3& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n_; ++i) least = std::min(least, distance_from_side(i, p));
    return least;
  }
  Roof roof(std::vector<Triangle> triangles) const {
    Roof out;
    out.inner.assign(points_.begin() + static_cast<std::ptrdiff_t>(n_), points_.end());
    for (const Vec3& p : out.inner) out.rise.push_back(rise_of(projected(p)));
    for (Triangle& t : triangles) {
      for (VertexIndex& v : t)
        if (v < n_) v = given_row_[v];
      if (is_turned_) std::swap(t[1], t[2]);
    }
    out.triangles = std::move(triangles);
    return out;
  }

  std::vector<Vec3> points_;            ///< corners of the polygon, followed by the points added inside it
  std::size_t n_;                       ///< of corners
  std::array<std::size_t, 3> base_{};   ///< corners
  std::size_t axis_ = 0;                ///< axis along which the polygon is projected
  bool is_turned_ = false;              ///< whether points_ has the corners in reverse of the order given by the caller
  std::vector<VertexIndex> given_row_;  ///< by corner
  std::vector<Vec3> flat_;              ///< the points, projected
  std::vector<Vec3> inward_;            ///< inward unit normal of each side of the polygon, in the projection
};

}  // namespace

std::optional<Roof> roof_over(std::span<const Vec3> corners, const AxisChoice& axis_for) {
  return RoofBuilder(corners, axis_for).run();
}

}  // namespace geomesh

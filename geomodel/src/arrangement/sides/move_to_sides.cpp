// SPDX-License-Identifier: GPL-3.0-or-later
// Moves vertices to sides of the volume, declared in arrangement/sides/join_to_sides.hpp.
#include <algorithm>
#include <limits>
#include <unordered_set>
#include <utility>

#include "arrangement/model/displacement.hpp"
#include "arrangement/model/surface_ends.hpp"
#include "arrangement/sides/join_to_sides.hpp"
#include "arrangement/sides/reach.hpp"
#include "arrangement/snap/nearness.hpp"
#include "arrangement/snap/snap_search.hpp"
#include "geomesh/core/surface_distance.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) { return cross(b - a, c - a); }

/// Finds places on the volume's sides to which vertices can move: corners, points on edges, and points on facets.
class SidePlaces {
 public:
  SidePlaces(const Complex& complex, const Joining& joining, const SideFacets& sides, double tolerance)
      : complex_(complex),
        sides_(sides),
        planes_(joining.box),
        is_box_(!joining.sides_are_fixed),
        tolerance_(tolerance),
        reach_(complex, joining, sides, tolerance) {}

  /// Returns the place to which vertex v moves: a corner of the volume, otherwise a point on an edge between two sides,
  /// otherwise a point on a side. Ends of surfaces move to planes of a box later, in snap_near().
  std::optional<Vec3> nearest(VertexIndex v, bool is_end) const {
    const Vec3& p = complex_.points[v];
    Nearest corner, edge, side;
    sides_.visit_near(std::array{p}, tolerance_, [&](Index f) {
      const Triangle& t = complex_.facets[f];
      if (!is_box_ || !is_end) side.see(p, on_facet(p, t), [&] { return reach_.of_vertex(v, f, is_end); });
      for (const EdgeKey& e : edges_of(t)) {
        if (!reach_.is_crease(e)) continue;
        edge.see(p, on_edge(p, e), [&] { return reach_.of_vertex(v, e); });
        for (const VertexIndex c : {e.first, e.second})
          corner.see(p, complex_.points[c], [&] { return reach_.of_vertex_to_corner(v, c); });
      }
    });
    return corner.place ? corner.place : edge.place ? edge.place : side.place;
  }

  /// Returns a facet of a side of the volume along which the edge e, an end of a surface, runs: both ends of e are
  /// within reach of the facet's plane, even if they are beside the facet. Returns no_index if there is none.
  Index followed_by(const SurfaceEnd& e) const {
    const Vec3 &a = complex_.points[e.a], &b = complex_.points[e.b];
    Index found = no_index;
    sides_.visit_near(std::array{a, b}, tolerance_, [&](Index f) {
      const double distance = std::min(reach_.of_vertex(e.a, f, true), reach_.of_vertex(e.b, f, true));
      if (found == no_index && is_near_plane(a, f, distance) && is_near_plane(b, f, distance) &&
          passes(a, b, f, distance))
        found = f;
    });
    return found;
  }
  Vec3 on_plane(const Vec3& p, Index f) const {
    const Triangle& t = complex_.facets[f];
    const Vec3 &a = complex_.points[t[0]], &b = complex_.points[t[1]], &c = complex_.points[t[2]],
               n = area_vector(a, b, c);
    return planes_.onto(p - (dot(n, p - a) / dot(n, n)) * n, planes_.of(a) & planes_.of(b) & planes_.of(c));
  }

 private:
  bool is_near_plane(const Vec3& p, Index f, double distance) const { return length(p - on_plane(p, f)) < distance; }
  bool passes(const Vec3& a, const Vec3& b, Index f, double distance) const {
    const Triangle& t = complex_.facets[f];
    if (length(a - on_facet(a, t)) < distance || length(b - on_facet(b, t)) < distance) return true;
    for (const EdgeKey& e : edges_of(t)) {
      const auto nearest = nearest_of_edges(a, b, complex_.points[e.first], complex_.points[e.second]);
      if (nearest && length((*nearest)[0] - (*nearest)[1]) < distance) return true;
    }
    return false;
  }

  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    std::optional<Vec3> place{};
    /// Replaces `place` by `at` if `at` is nearer to p, and p may move as far as that according to `reach()`.
    void see(const Vec3& p, const Vec3& at, auto reach) {
      const double d = length(p - at);
      if (!(d < distance) || !(d < reach())) return;
      distance = d;
      place = at;
    }
  };

  /// Returns the point of facet t closest to p, exactly on those axis-aligned planes that contain t.
  Vec3 on_facet(const Vec3& p, const Triangle& t) const {
    const Vec3 &a = complex_.points[t[0]], &b = complex_.points[t[1]], &c = complex_.points[t[2]];
    return planes_.onto(closest_on_triangle(p, {a, b, c}), planes_.of(a) & planes_.of(b) & planes_.of(c));
  }
  Vec3 on_edge(const Vec3& p, const EdgeKey& e) const {
    const Vec3 &a = complex_.points[e.first], &b = complex_.points[e.second];
    return planes_.onto(closest_on_triangle(p, {a, b, b}), planes_.of(a) & planes_.of(b));
  }

  const Complex& complex_;
  const SideFacets& sides_;
  BoxPlanes planes_;
  bool is_box_;
  double tolerance_;
  Reach reach_;
};

/// Moves vertices to sides of the volume, and undoes the moves that would invert a facet.
class Moves {
 public:
  Moves(const Complex& complex, double unit) : complex_(complex), unit_(unit), points_(complex.points) {}

  /// Moves vertex v. Two vertices never get the same place: if it is taken, a place some ulps away is used.
  void add(VertexIndex v, Vec3 to) {
    if (to == points_[v]) return;
    if (taken_.empty()) taken_.insert(complex_.points.begin(), complex_.points.end());
    constexpr unsigned most_tries = 8;
    for (unsigned k = 0; k < most_tries; ++k, to.z += unit_)
      if (taken_.insert(to).second) {
        points_[v] = to;
        return;
      }
  }

  void take_back_where_facets_turn() {
    for (bool turns = !taken_.empty(); turns;) {
      turns = false;
      for (const Triangle& t : complex_.facets) turns |= take_back(t);
    }
  }

  const std::vector<Vec3>& points() const { return points_; }

 private:
  bool take_back(const Triangle& t) {
    const std::vector<Vec3>& old = complex_.points;
    if (std::ranges::all_of(t, [&](VertexIndex v) { return points_[v] == old[v]; })) return false;
    const Vec3 before = area_vector(old[t[0]], old[t[1]], old[t[2]]);
    if (dot(before, area_vector(points_[t[0]], points_[t[1]], points_[t[2]])) > least_share * dot(before, before))
      return false;
    for (const VertexIndex v : t) points_[v] = old[v];
    return true;
  }

  static constexpr double least_share = 0.1;  // fraction of its area that a moved facet keeps at least

  const Complex& complex_;
  double unit_;
  std::vector<Vec3> points_;
  std::unordered_set<Vec3, PointHash> taken_;
};

/// Classifies vertices: fixed (unused or on a side of the volume), at an end of a surface, and others.
class VerticesToMove {
 public:
  VerticesToMove(const Complex& complex, const SideFacets& sides, const std::vector<SurfaceEnd>& ends)
      : kinds_(complex.points.size(), Kind::other) {
    std::vector<std::uint8_t> is_used(complex.points.size(), 0);
    for (const Triangle& t : complex.facets)
      for (const VertexIndex v : t) is_used[v] = 1;
    for (const SurfaceEnd& e : ends) kinds_[e.a] = kinds_[e.b] = Kind::end;
    for (const Index f : sides.all())
      for (const VertexIndex v : complex.facets[f]) kinds_[v] = Kind::fixed;
    for (VertexIndex v = 0; v < kinds_.size(); ++v)
      if (!is_used[v]) kinds_[v] = Kind::fixed;
  }
  bool is_fixed(VertexIndex v) const { return kinds_[v] == Kind::fixed; }
  bool is_end(VertexIndex v) const { return kinds_[v] == Kind::end; }

 private:
  enum class Kind : std::uint8_t { fixed, end, other };
  std::vector<Kind> kinds_;
};

Displacement take_over(Complex& complex, const std::vector<Vec3>& points) {
  MovesOfStep moves;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (const double distance = length(points[v] - complex.points[v]); distance > 0) moves.note(distance, points[v]);
  complex.points = points;
  return moves.displacement();
}

}  // namespace

Displacement move_to_sides(Complex& complex, const Joining& joining, double tolerance) {
  const SideFacets sides(complex, joining);
  if (sides.all().empty()) return {};
  // A vertex whose new place is another vertex's is shifted by the merging distance divided by this number.
  constexpr double moves_a_distance = 16;
  const SidePlaces places(complex, joining, sides, tolerance);
  std::vector<SurfaceEnd> ends = surface_ends(complex);
  std::erase_if(ends, [&](const SurfaceEnd& e) { return e.surface >= joining.first_side; });
  const VerticesToMove vertices(complex, sides, ends);
  Moves moves(complex, joining.distance / moves_a_distance);
  // Points within joining.distance of the planes of a box are not moved here, because rounding moves them onto these.
  const bool is_box = !joining.sides_are_fixed;
  std::vector<std::uint8_t> is_placed(complex.points.size(), 0);
  for (VertexIndex v = 0; v < complex.points.size(); ++v) {
    if (vertices.is_fixed(v)) continue;
    const auto to = places.nearest(v, vertices.is_end(v));
    if (!to || (is_box && length(*to - complex.points[v]) < joining.distance)) continue;
    moves.add(v, *to);
    is_placed[v] = 1;
  }
  for (const SurfaceEnd& e : ends) {
    const Index side = places.followed_by(e);
    for (const VertexIndex v : {e.a, e.b})
      if (side != no_index && vertices.is_end(v) && !std::exchange(is_placed[v], 1))
        moves.add(v, places.on_plane(complex.points[v], side));
  }
  moves.take_back_where_facets_turn();
  return take_over(complex, moves.points());
}

}  // namespace geomesh::geomodel::arrangement

// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/sides/join_to_sides.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "arrangement/sides/side_facets.hpp"
#include "arrangement/snap/nearness.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/core/surface_distance.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

using Corners = std::array<Vec3, 3>;

Corners corners_of(const Complex& complex, Index f) {
  const Triangle& t = complex.facets[f];
  return {complex.points[t[0]], complex.points[t[1]], complex.points[t[2]]};
}

/// All corners of t are farther from the plane than the distance, and on one side of it.
bool is_apart(const Corners& plane, const Corners& t, double distance) {
  const PlaneWithin near(plane, distance);
  const int side = near.side(t[0]);
  return side != 0 && near.side(t[1]) == side && near.side(t[2]) == side;
}

/// A corner of t is within the distance of the triangle `of`, and not exactly in its plane.
bool has_corner_near(const Corners& t, const Corners& of, double distance) {
  return std::ranges::any_of(t, [&](const Vec3& p) {
    return length(p - closest_on_triangle(p, of)) < distance && orient3d(of[0], of[1], of[2], p) != Sign::zero;
  });
}

/// Edges of the two pass each other within the distance, and do not meet.
bool has_edges_near(const Corners& s, const Corners& t, double distance) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3 &a = s[i], &b = s[(i + 1) % 3], &c = t[j], &d = t[(j + 1) % 3];
      const auto nearest = nearest_of_edges(a, b, c, d);
      if (nearest && length((*nearest)[0] - (*nearest)[1]) < distance && orient3d(a, b, c, d) != Sign::zero)
        return true;
    }
  return false;
}

bool lies_beside(const Corners& s, const Corners& t, double distance) {
  if (is_apart(s, t, distance) || is_apart(t, s, distance)) return false;
  return has_corner_near(s, t, distance) || has_corner_near(t, s, distance) || has_edges_near(s, t, distance);
}

}  // namespace

std::optional<SnapOutcome> join_to_sides(Complex& complex, const Joining& joining,
                                         std::vector<VertexIndex>& vertex_now) {
  if (!joining.sides_are_fixed) return std::nullopt;
  const SideFacets sides(complex, joining);
  if (sides.all().empty()) return std::nullopt;
  std::vector<std::uint8_t> active;
  std::set<SurfacePair> pairs;
  for (Index f = 0; f < complex.facets.size(); ++f) {
    if (sides.is_of_side(f)) continue;
    const Corners t = corners_of(complex, f);
    sides.visit_near(t, joining.distance, [&](Index side) {
      if (!lies_beside(corners_of(complex, side), t, joining.distance)) return;
      active.resize(complex.facets.size(), 0);
      active[f] = active[side] = 1;
      for (const Origin& o : complex.origins.of(f))
        for (const Origin& of_side : complex.origins.of(side)) pairs.insert(surface_pair(o.surface, of_side.surface));
    });
  }
  if (pairs.empty()) return std::nullopt;
  SnapOutcome outcome = snap_near(
      complex, active, {joining.distance, joining.box, MoveToBox::none, JoinRule::all_of(std::move(pairs), no_index)},
      &vertex_now);
  if (!outcome.changed()) return std::nullopt;
  return outcome;
}

}  // namespace geomesh::geomodel::arrangement

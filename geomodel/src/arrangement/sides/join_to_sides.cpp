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

/// Returns whether all corners of triangle t are farther from the plane than the distance, and on the same side of it.
bool is_apart(const Corners& plane, const Corners& t, double distance) {
  const PlaneWithin near(plane, distance);
  const int side = near.side(t[0]);
  return side != 0 && near.side(t[1]) == side && near.side(t[2]) == side;
}

/// Position of a point or edge relative to a triangle or another edge: farther away than the distance (apart), or
/// within the distance and exactly coplanar with it (exact) or not (beside).
enum class Nearness : std::uint8_t { apart, exact, beside };

Nearness nearness(double distance, double most, Sign orientation) {
  if (!(distance < most)) return Nearness::apart;
  return orientation == Sign::zero ? Nearness::exact : Nearness::beside;
}

/// Returns `beside` if a corner of t is near the triangle `of` but not in its plane, else `exact` if one is near and in
/// the plane, else `apart`.
Nearness nearness_of_corners(const Corners& t, const Corners& of, double distance) {
  Nearness found = Nearness::apart;
  for (const Vec3& p : t)
    found =
        std::max(found, nearness(length(p - closest_on_triangle(p, of)), distance, orient3d(of[0], of[1], of[2], p)));
  return found;
}

/// Returns `beside` if two edges pass each other within the distance, else `exact` if two cross, else `apart`.
Nearness nearness_of_edges(const Corners& s, const Corners& t, double distance) {
  Nearness found = Nearness::apart;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3 &a = s[i], &b = s[(i + 1) % 3], &c = t[j], &d = t[(j + 1) % 3];
      if (const auto nearest = nearest_of_edges(a, b, c, d))
        found = std::max(found, nearness(length((*nearest)[0] - (*nearest)[1]), distance, orient3d(a, b, c, d)));
    }
  return found;
}

Nearness nearness(const Corners& s, const Corners& t, double distance) {
  if (is_apart(s, t, distance) || is_apart(t, s, distance)) return Nearness::apart;
  return std::max(
      {nearness_of_corners(s, t, distance), nearness_of_corners(t, s, distance), nearness_of_edges(s, t, distance)});
}

}  // namespace

std::optional<SnapOutcome> join_to_sides(Complex& complex, const Joining& joining,
                                         std::vector<VertexIndex>& vertex_now) {
  if (!joining.sides_are_fixed) return std::nullopt;
  const SideFacets sides(complex, joining);
  if (sides.all().empty()) return std::nullopt;
  struct NearFacets {
    Index facet, side;
    bool exactly;
  };
  std::vector<NearFacets> near;
  for (Index f = 0; f < complex.facets.size(); ++f) {
    if (sides.is_of_side(f)) continue;
    const Corners t = corners_of(complex, f);
    sides.visit_near(t, joining.distance, [&](Index side) {
      const Nearness how = nearness(corners_of(complex, side), t, joining.distance);
      if (how != Nearness::apart) near.push_back({f, side, how == Nearness::exact});
    });
  }
  if (std::ranges::all_of(near, &NearFacets::exactly)) return std::nullopt;
  std::vector<std::uint8_t> active(complex.facets.size(), 0);
  std::set<SurfacePair> pairs;
  for (const auto& [f, side, exactly] : near) {
    active[f] = active[side] = 1;
    for (const Origin& o : complex.origins.of(f))
      for (const Origin& of_side : complex.origins.of(side)) pairs.insert(surface_pair(o.surface, of_side.surface));
  }
  SnapOutcome outcome = snap_near(
      complex, active, {joining.distance, joining.box, MoveToBox::none, JoinRule::all_of(std::move(pairs), no_index)},
      &vertex_now);
  if (!outcome.changed()) return std::nullopt;
  return outcome;
}

std::vector<std::uint64_t> sides_of_vertices(const Complex& complex, const Joining& joining) {
  std::vector<std::uint64_t> sides_of;
  const SideFacets sides(complex, joining);
  if (!joining.sides_are_fixed || sides.all().empty()) return sides_of;
  constexpr Index n_bits = 64;
  for (const Vec3& p : complex.points) {
    std::uint64_t& bits = sides_of.emplace_back(0);
    sides.visit_near(std::array{p}, joining.distance, [&](Index f) {
      if (!(length(p - closest_on_triangle(p, corners_of(complex, f))) < joining.distance)) return;
      for (const Origin& o : complex.origins.of(f))
        if (o.surface >= joining.first_side) bits |= std::uint64_t{1} << o.surface % n_bits;
    });
  }
  return sides_of;
}

}  // namespace geomesh::geomodel::arrangement

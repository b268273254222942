// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/join/join_surfaces.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "arrangement/model/surface_ends.hpp"
#include "arrangement/search/bvh.hpp"
#include "arrangement/snap/nearness.hpp"
#include "arrangement/snap/snap_search.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

Box3 box_of(const Complex& complex, std::initializer_list<VertexIndex> vertices, double margin) {
  Box3 box;
  for (const VertexIndex v : vertices) box.add(complex.points[v]);
  return {box.min - Vec3{margin, margin, margin}, box.max + Vec3{margin, margin, margin}};
}

/// Edges at which surfaces end, and which may be moved onto other surfaces.
class Ends {
 public:
  struct Near {
    std::vector<std::uint8_t> facets;  ///< for each facet: whether it is near an end of a surface; empty if none is
    std::set<SurfacePair> surfaces;
  };

  Ends(const Complex& complex, const Joining& joining) : complex_(complex), joining_(joining), planes_(joining.box) {
    for (const SurfaceEnd& e : surface_ends(complex)) {
      if (e.surface >= joining.first_side || lies_on_or_beyond_box(e)) continue;
      ends_.push_back(e);
      boxes_.push_back(box_of(complex, {e.a, e.b}, joining.distance));
    }
  }

  /// Marks facets with free edges that are close to another surface, and the facets of that surface.
  Near find_near() const {
    Near near;
    if (ends_.empty()) return near;
    const BoxTree tree(boxes_);
    for (Index f = 0; f < complex_.facets.size(); ++f) {
      const Triangle& t = complex_.facets[f];
      tree.boxes_meeting(box_of(complex_, {t[0], t[1], t[2]}, 0), [&](Index k) {
        if (!is_other(f, ends_[k].surface) || !comes_near(ends_[k], t)) return;
        near.facets.resize(complex_.facets.size(), 0);
        near.facets[f] = near.facets[ends_[k].facet] = 1;
        for (const Origin& o : complex_.origins.of(f)) near.surfaces.insert(surface_pair(o.surface, ends_[k].surface));
      });
    }
    return near;
  }

 private:
  bool lies_on_or_beyond_box(const SurfaceEnd& e) const {
    if (!joining_.box) return false;
    const Vec3 &a = complex_.points[e.a], &b = complex_.points[e.b];
    if ((planes_.of(a) & planes_.of(b)) != 0) return true;
    for (std::size_t i = 0; i < 3; ++i)
      if (std::max(a[i], b[i]) < joining_.box->min[i] || std::min(a[i], b[i]) > joining_.box->max[i]) return true;
    return false;
  }
  bool is_other(Index f, Index surface) const {
    const auto origins = complex_.origins.of(f);
    return std::none_of(origins.begin(), origins.end(), [&](const Origin& o) { return o.surface == surface; });
  }
  /// Returns whether an end of the edge is near the plane of the facet, possibly because of rounding, but not on it. An
  /// end on the plane is intersected exactly, and an edge with its ends on both sides of the plane is a plain crossing.
  bool comes_near(const SurfaceEnd& e, const Triangle& t) const {
    const Vec3 &p = complex_.points[t[0]], &q = complex_.points[t[1]], &r = complex_.points[t[2]];
    const PlaneWithin plane({p, q, r}, joining_.distance);
    return std::ranges::any_of(std::array{e.a, e.b}, [&](VertexIndex end) {
      const Vec3& x = complex_.points[end];
      return plane.side(x) == 0 && orient3d(p, q, r, x) != Sign::zero;
    });
  }

  const Complex& complex_;
  const Joining& joining_;
  BoxPlanes planes_;
  std::vector<SurfaceEnd> ends_;
  std::vector<Box3> boxes_;
};

}  // namespace

std::optional<SnapOutcome> join_ends(Complex& complex, const Joining& joining, std::vector<VertexIndex>& vertex_now) {
  const Ends::Near near = Ends(complex, joining).find_near();
  if (near.facets.empty()) return std::nullopt;
  JoinRule rule({}, joining.sides_are_fixed ? static_cast<Index>(joining.first_side) : no_index);
  rule.join_ends_of(near.surfaces);
  SnapOutcome outcome =
      snap_near(complex, near.facets, {joining.distance, joining.box, MoveToBox::none, rule}, &vertex_now);
  if (!outcome.changed()) return std::nullopt;
  return outcome;
}

std::optional<SnapOutcome> join_what_lies_in_each_other(Complex& complex, const Contacts& contacts,
                                                        const Joining& joining) {
  std::set<SurfacePair> pairs = surfaces_in_contact(complex, contacts);
  std::erase_if(pairs, [&](const SurfacePair& pair) { return pair.second >= joining.first_side; });
  if (pairs.empty()) return std::nullopt;
  // Needles that joining the surfaces creates are removed as well, in surfaces and in sides of the volume.
  for (const auto& [a, b] : std::set(pairs)) pairs.insert({{a, a}, {b, b}});
  for (const Origin& o : complex.origins.items)
    if (o.surface >= joining.first_side) pairs.insert({o.surface, o.surface});
  const JoinRule rule =
      JoinRule::all_of(std::move(pairs), joining.sides_are_fixed ? static_cast<Index>(joining.first_side) : no_index);
  SnapOutcome outcome = snap_near(complex, std::vector<std::uint8_t>(complex.facets.size(), 1),
                                  {joining.distance, joining.box, MoveToBox::none, rule});
  if (!outcome.changed()) return std::nullopt;
  return outcome;
}

}  // namespace geomesh::geomodel::arrangement

// SPDX-License-Identifier: GPL-3.0-or-later
// Moves facets that pass beside feature edges of the volume onto them, declared in arrangement/sides/join_to_sides.hpp.
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "arrangement/search/bvh.hpp"
#include "arrangement/sides/join_to_sides.hpp"
#include "arrangement/sides/reach.hpp"
#include "arrangement/snap/nearness.hpp"
#include "arrangement/snap/rebuilding.hpp"
#include "arrangement/snap/snap_search.hpp"
#include "arrangement/snap/vertices_on_edges.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

/// Collects vertices to insert where facets pass close to feature edges of the volume.
class Drawing {
 public:
  Drawing(Complex& complex, const Joining& joining, double tolerance)
      : complex_(complex),
        n_points_(complex.points.size()),
        rounding_(joining.distance),
        planes_(joining.box),
        on_edges_(complex, tolerance),
        places_(complex) {}

  /// Inserts those ends of the feature edge that are closer than the distance into the facet or its edges. Facet edges
  /// that pass the feature edge get a common vertex with it.
  void see(const EdgeKey& crease, Index facet, double distance) {
    for (const VertexIndex corner : {crease.first, crease.second}) insert_corner(corner, facet, distance);
    for (const EdgeKey& e : edges_of(complex_.facets[facet])) {
      edges_.insert(e);
      join_edges(crease, e, distance);
    }
    edges_.insert(crease);
  }

  /// Splits facets at the collected vertices; changes and returns nothing if all are exactly on their edges and facets.
  std::optional<SnapOutcome> rebuild() {
    Insertions insertions{on_edges_.take_sorted(), std::move(in_facet_)};
    if (!is_any_beside_) {
      complex_.points.resize(n_points_);
      complex_.input_point.resize(n_points_);
      return std::nullopt;
    }
    SnapOutcome outcome;
    MovesOfStep moves;
    rebuild_with(complex_, insertions, {edges_.begin(), edges_.end()}, {}, outcome, moves);
    outcome.moved = moves.displacement();
    return outcome;
  }

 private:
  const Vec3& point(VertexIndex v) const { return complex_.points[v]; }

  /// Inserts vertex v into edge e to join it to another edge or facet; `orientation` is zero if v lies exactly on both.
  void insert(const EdgeKey& e, VertexIndex v, Sign orientation) {
    if (on_edges_.is_on(e, v)) return;
    on_edges_.insert(e, v);
    is_any_beside_ |= orientation != Sign::zero;
  }

  void insert_corner(VertexIndex v, Index facet, double distance) {
    const Vec3& p = point(v);
    const Triangle& t = complex_.facets[facet];
    if (std::ranges::any_of(t, [&](VertexIndex w) { return length(point(w) - p) < distance; })) return;
    const Sign orientation = orient3d(point(t[0]), point(t[1]), point(t[2]), p);
    bool is_on_edge = false;
    for (const EdgeKey& e : edges_of(t)) {
      const double s = on_edges_.parameter(e, p);
      if (!(s > 0 && s < 1 && length(p - on_edges_.at(e, s)) < distance)) continue;
      insert(e, v, orientation);
      is_on_edge = true;
    }
    std::vector<VertexIndex>& in = in_facet_[facet];
    if (!is_on_edge && std::ranges::find(in, v) == in.end() &&
        is_near_inside(p, {point(t[0]), point(t[1]), point(t[2])}, distance)) {
      in.push_back(v);
      is_any_beside_ |= orientation != Sign::zero;
    }
    if (in.empty()) in_facet_.erase(facet);
  }

  void join_edges(const EdgeKey& crease, const EdgeKey& e, double distance) {
    for (const VertexIndex v : {e.first, e.second})
      if (v == crease.first || v == crease.second) return;
    const auto nearest = nearest_of_edges(point(crease.first), point(crease.second), point(e.first), point(e.second));
    if (!nearest || !(length((*nearest)[0] - (*nearest)[1]) < distance)) return;
    const auto& [p, q] = *nearest;
    const VertexIndex on_crease = on_edges_.nearer(crease, p), on_e = on_edges_.nearer(e, q);
    const Sign orientation = orient3d(point(crease.first), point(crease.second), point(e.first), point(e.second));
    if (on_e != no_vertex) {
      if (on_crease == no_vertex && length(point(on_e) - p) < rounding_) insert(crease, on_e, orientation);
      return;
    }
    const VertexIndex v = on_crease != no_vertex ? on_crease : places_.at(planes_.onto(p, planes_of(crease))).first;
    insert(crease, v, orientation);
    insert(e, v, orientation);
  }
  unsigned planes_of(const EdgeKey& e) const { return planes_.of(point(e.first)) & planes_.of(point(e.second)); }

  Complex& complex_;
  std::size_t n_points_;  ///< that there were
  double rounding_;
  /// Whether some inserted vertex is beside its edge or facet. If none is, exact intersection inserts all vertices.
  bool is_any_beside_ = false;
  BoxPlanes planes_;
  VerticesOnEdges on_edges_;
  std::map<Index, std::vector<VertexIndex>> in_facet_;
  VerticesByPlace places_;
  std::set<EdgeKey> edges_;  ///< edges of the facets near feature edges of the volume, and these feature edges
};

Box3 box_about(const Complex& complex, const auto& vertices, double margin) {
  Box3 box;
  for (const VertexIndex v : vertices) box.add(complex.points[v]);
  return {box.min - Vec3{margin, margin, margin}, box.max + Vec3{margin, margin, margin}};
}

}  // namespace

std::optional<SnapOutcome> draw_to_feature_edges(Complex& complex, const Joining& joining, double tolerance) {
  const SideFacets sides(complex, joining);
  if (sides.all().empty()) return std::nullopt;
  const Reach reach(complex, joining, sides, tolerance);
  std::vector<EdgeKey> creases;
  std::vector<Box3> boxes;
  for (const auto& [crease, at] : reach.creases()) {
    creases.push_back(crease);
    boxes.push_back(box_about(complex, std::array{crease.first, crease.second}, tolerance));
  }
  const BoxTree tree(boxes);
  Drawing drawing(complex, joining, tolerance);
  for (Index f = 0; f < complex.facets.size(); ++f)
    if (!sides.is_of_side(f))
      tree.boxes_meeting(box_about(complex, complex.facets[f], 0), [&](Index c) {
        if (reach.runs_along(f, creases[c])) drawing.see(creases[c], f, reach.of_facet(f, creases[c]));
      });
  return drawing.rebuild();
}

}  // namespace geomesh::geomodel::arrangement

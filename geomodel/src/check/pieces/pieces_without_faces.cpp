// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/pieces/pieces_without_faces.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "check/pieces/uncovered_places.hpp"

namespace geomesh::geomodel::checking {
namespace {

using Ends = std::pair<VertexIndex, VertexIndex>;
Ends ends_of(const Triangle& t, std::size_t i) { return std::minmax(t[i], t[(i + 1) % 3]); }

}  // namespace

PiecesWithoutFaces::PiecesWithoutFaces(const CheckedFaces& checked, Index surface, const TakenByRules& rules,
                                       double tolerance,
                                       const std::function<bool(VertexIndex, VertexIndex)>& may_end_at)
    : checked_(checked), surface_(surface), rules_(rules), tolerance_(tolerance), tree_(tree_over({}, {})) {
  const TrimRules& trim = checked.specification().trims[surface];
  std::map<Ends, int> uses;
  std::set<Ends> of_cutters;
  for (Index f = 0; f < checked.candidates().size(); ++f) {
    const auto cuts = [&](Index row) { return checked.carries(f, row); };
    const bool of_cutter = std::ranges::any_of(trim.above, cuts) || std::ranges::any_of(trim.below, cuts);
    for (std::size_t i = 0; i < 3; ++i) {
      const Ends e = ends_of(checked.candidates()[f], i);
      if (checked.carries(f, surface)) ++uses[e];
      if (of_cutter) of_cutters.insert(e);
    }
  }
  for (const auto& [e, n] : uses) {
    if (n != 1) continue;
    open_edges_.push_back({e.first, e.second, e.second});
    at_cutter_.push_back(of_cutters.contains(e) || may_end_at(e.first, e.second));
  }
  tree_ = tree_over(checked.mesh().file.points, open_edges_);
}

/// Returns whether some point of the segment a b is on the triangle. Ternary search finds it, because the distance
/// outside the triangle is convex along the segment.
bool PiecesWithoutFaces::runs_on(const PlaneTriangle& triangle, const Vec3& a, const Vec3& b) const {
  double from = 0, to = 1;
  for (int k = 0; k < 60; ++k) {
    const double third = (to - from) / 3;
    const Vec3 p = a + (from + third) * (b - a), q = a + (to - third) * (b - a);
    if (triangle.outside(p) <= triangle.outside(q)) {
      to -= third;
    } else {
      from += third;
    }
  }
  const Vec3 nearest = a + 0.5 * (from + to) * (b - a);
  return triangle.outside(nearest) <= tolerance_ && triangle.distance(nearest) <= tolerance_;
}

void PiecesWithoutFaces::add(const PlaneTriangle& triangle, Index row, const std::vector<Index>& faces) {
  UncoveredTriangle& part = uncovered_.emplace_back(UncoveredTriangle{row});
  const std::vector<PlaneTriangle> flat = flat_faces(checked_, faces);
  const double weight = 2 * triangle.area() / ((lattice_parts - 1) * (lattice_parts - 2));
  for_each_uncovered(triangle, flat, tolerance_, [&](const Vec3& p) {
    if (rules_.is_outside(p)) return true;
    if (rules_.is_beyond_cutters(surface_, p)) {
      part.beyond += weight;
    } else if (!rules_.may_be_away(surface_, row, p) &&
               !checked_.is_removed(surface_, p, (4 * tolerance_) * triangle.normal())) {
      part.within += weight;
      part.place = p;
    }
    return true;
  });
  const auto& c = triangle.corners();
  for (std::size_t i = 0; i < 3; ++i)
    for (int k = 1; k < lattice_parts && !part.goes_on[i]; ++k)
      part.goes_on[i] = !is_covered(c[i] + (double(k) / lattice_parts) * (c[(i + 1) % 3] - c[i]), flat, tolerance_);
  const std::vector<Vec3>& points = checked_.mesh().file.points;
  tree_.query(inflated(box_of(c[0], c[1], c[2]), tolerance_), [&](Index e) {
    if (!at_cutter_[e] && runs_on(triangle, points[open_edges_[e][0]], points[open_edges_[e][1]]))
      part.ends_at_cutters = false;
  });
}

std::vector<UncoveredTriangle> PiecesWithoutFaces::not_taken() const {
  std::vector<UncoveredTriangle> out;
  for (const Index row : not_taken_as_pieces(checked_.specification().surfaces[surface_], uncovered_))
    out.push_back(uncovered_[row]);
  return out;
}

}  // namespace geomesh::geomodel::checking

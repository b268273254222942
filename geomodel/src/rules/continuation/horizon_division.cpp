// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/horizon_division.hpp"

#include <algorithm>

#include "naming/sheets.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {

HorizonDivision::HorizonDivision(const TriangulatedSurface& horizon, Index row, const BlockFramework& framework,
                                 const Walls& cutters, const BorderStates& states)
    : horizon_(horizon), framework_(framework) {
  for (const auto& [edge, state] : states) states_[std::minmax(edge.first, edge.second)] = state;
  triangles_ = merged_triangles(horizon);
  for (Index t = 0; t < triangles_.size(); ++t)
    for_each_edge_of(t, [&](VertexIndex a, VertexIndex b) {
      if (a != b) at_edge_.emplace_back(std::minmax(a, b), t);
    });
  std::ranges::sort(at_edge_);
  crosses_.assign(triangles_.size(), false);
  for (auto at = at_edge_.begin(); at != at_edge_.end();) {
    const auto next = std::find_if(at, at_edge_.end(), [&](const auto& use) { return use.first != at->first; });
    const Vec3 &p = horizon.points[at->first.first], &q = horizon.points[at->first.second];
    const bool is_cut = cutters.first_surface(p, q, row) || cutters.first_surface(q, p, row);
    for (; at != next; ++at)
      if (is_cut) crosses_[at->second] = true;
  }
  Index last = no_index;
  for (Index t = 0; t < triangles_.size(); ++t)
    block_.push_back(crosses_[t] || !has_area(t) ? no_index : block_of(t, last));
}

std::optional<BorderState> HorizonDivision::border_state(VertexIndex a, VertexIndex b) const {
  const auto at = states_.find(std::minmax(a, b));
  return at == states_.end() ? std::nullopt : std::optional(at->second);
}

std::vector<Index> HorizonDivision::sheet_of(Index block) const {
  std::vector<Index> sheet;
  std::vector<bool> taken(triangles_.size(), false);
  for (Index t = 0; t < triangles_.size(); ++t)
    if (block_[t] == block) {
      sheet.push_back(t);
      taken[t] = true;
    }
  for (std::size_t k = 0; k < sheet.size(); ++k) {
    const bool crosses = crosses_[sheet[k]];
    for_each_edge_of(sheet[k], [&](VertexIndex a, VertexIndex b) {
      const MapEdge edge(std::minmax(a, b));
      for (auto at = std::ranges::lower_bound(at_edge_, edge, {}, &std::pair<MapEdge, Index>::first);
           at != at_edge_.end() && at->first == edge; ++at) {
        const Index other = at->second;
        if (taken[other] || block_[other] != no_index) continue;
        if (crosses && !(crosses_[other] && framework_.overlaps(block, corners(other)))) continue;
        taken[other] = true;
        sheet.push_back(other);
      }
    });
  }
  return sheet;
}

/// Returns the block that contains a triangle's centroid or, if this lies outside the model, another of its points.
/// `last` is the tetrahedron found last, at which the next search begins.
Index HorizonDivision::block_of(Index t, Index& last) const {
  const auto [a, b, c] = corners(t);
  const Vec3 centre = (1.0 / 3) * (a + b + c);
  for (const Vec3& p : {centre, 0.5 * (centre + a), 0.5 * (centre + b), 0.5 * (centre + c), a, b, c})
    if (const Index block = framework_.block_at(p, last); block != no_index) return block;
  return no_index;
}

}  // namespace geomesh::geomodel

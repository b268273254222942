// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <numeric>

#include "corpus_judge_parts.hpp"

namespace geomesh::test {

namespace {

struct EdgeUses {
  std::vector<std::array<Index, 2>> triangles;  ///< facet, apex
  bool is_kept = false;                         ///< something else lies there
};

std::map<std::array<VertexIndex, 2>, EdgeUses> uses_of_edges(const PiecewiseLinearComplex& plc) {
  std::map<std::array<VertexIndex, 2>, EdgeUses> uses;
  const auto at = [&](VertexIndex a, VertexIndex b) -> EdgeUses& { return uses[{std::min(a, b), std::max(a, b)}]; };
  std::vector<bool> is_plain(plc.n_facets(), true);
  for (const auto& s : plc.facet_segments) is_plain[s.facet] = false;
  for (const auto& p : plc.facet_points) is_plain[p.facet] = false;
  for (Index f = 0; f < plc.n_facets(); ++f)
    for (Index l = plc.facet_loops[f]; l < plc.facet_loops[f + 1]; ++l) {
      const auto loop = plc.loop(l);
      const bool is_triangle = is_plain[f] && plc.n_loops(f) == 1 && loop.size() == 3;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        EdgeUses& edge = at(loop[i], loop[(i + 1) % loop.size()]);
        if (is_triangle)
          edge.triangles.push_back({f, loop[(i + 2) % 3]});
        else
          edge.is_kept = true;
      }
    }
  for (const auto& s : plc.segments) at(s.a, s.b).is_kept = true;
  for (const auto& s : plc.facet_segments) at(s.a, s.b).is_kept = true;
  return uses;
}

}  // namespace

std::vector<std::vector<Index>> coplanar_groups(const PiecewiseLinearComplex& plc) {
  std::vector<Index> parent(plc.n_facets());
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto find = [&](Index f) {
    while (parent[f] != f) f = parent[f] = parent[parent[f]];
    return f;
  };
  for (const auto& [edge, uses] : uses_of_edges(plc)) {
    if (uses.is_kept || uses.triangles.size() != 2) continue;
    const auto [f, apex] = uses.triangles[0];
    const auto [g, other] = uses.triangles[1];
    if (plc.facet_provenance[f] == plc.facet_provenance[g] &&
        exact_orientation(plc.points[edge[0]], plc.points[edge[1]], plc.points[apex], plc.points[other]) == 0)
      parent[find(f)] = find(g);
  }
  std::map<Index, std::vector<Index>> groups;
  for (Index f = 0; f < plc.n_facets(); ++f) groups[find(f)].push_back(f);
  std::vector<std::vector<Index>> out;
  for (auto& [root, group] : groups)
    if (group.size() > 1) out.push_back(std::move(group));
  return out;
}

}  // namespace geomesh::test

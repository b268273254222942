// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/sheet_topology.hpp"

#include "common/edge_uses.hpp"
#include "common/union_find.hpp"

namespace geomesh::geomodel {

SheetTopology topology_of(const TriangulatedSurface& surface) {
  SheetTopology topology;
  UnionFind parts(surface.triangles.size());
  for_each_edge(sorted_edge_uses(std::span<const Triangle>(surface.triangles)), [&](std::span<const EdgeUse> uses) {
    for (const EdgeUse& use : uses) parts.unite(uses.front().facet, use.facet);
    topology.n_border_edges += uses.size() == 1;
    if (uses.size() > 2 && topology.n_bad_edges++ == 0) topology.bad_place = surface.points[uses.front().a];
  });
  for (Index t = 0; t < surface.triangles.size(); ++t) topology.n_parts += parts.find(t) == t;
  return topology;
}

}  // namespace geomesh::geomodel

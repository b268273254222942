// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/curves_at_faces.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "common/edge_uses.hpp"
#include "verify/fault_list.hpp"

namespace geomesh::geomodel {

namespace {

using EdgeKey = std::pair<VertexIndex, VertexIndex>;

/// Returns the edges on intersections, borders and tips of surfaces, sorted, once for each curve on which they are.
std::vector<EdgeKey> edges_of_surface_curves(const ModelMesh& mesh) {
  std::set<std::int32_t> wells;
  for (const NamedCurve& curve : mesh.curves)
    if (curve.kind == "well") wells.insert(curve.id);
  std::vector<EdgeKey> edges;
  for (const ModelMesh::CurveEdge& e : mesh.curve_edges)
    if (!wells.contains(e.curve)) edges.emplace_back(std::min(e.a, e.b), std::max(e.a, e.b));
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

void check_curves_at_faces(const ModelMesh& mesh, std::vector<std::string>& faults) {
  FaultList missing("faces at an edge where surfaces meet or end that is on no curve"),
      several("faces at an edge on several curves of surfaces"), inside("faces at an edge on a curve inside a patch"),
      patches("faces whose patch differs from that of the face beside them");
  const std::vector<EdgeKey> on_curves = edges_of_surface_curves(mesh);
  auto at = on_curves.begin();
  for_each_edge(sorted_edge_uses(mesh.faces), [&](std::span<const EdgeUse> edge) {
    const EdgeKey key{edge[0].a, edge[0].b};
    while (at != on_curves.end() && *at < key) ++at;
    std::size_t n_curves = 0;
    for (; at != on_curves.end() && *at == key; ++at) ++n_curves;
    const ModelMesh::Face &first = mesh.faces[edge.front().facet], &last = mesh.faces[edge.back().facet];
    if (edge.size() == 2 && first.surface_set == last.surface_set) {
      if (n_curves > 0) inside.add(edge[0].facet);
      if (first.patch != last.patch) patches.add(edge[1].facet);
    } else if (n_curves != 1) {
      (n_curves == 0 ? missing : several).add(edge[0].facet);
    }
  });
  for (const FaultList& list : {missing, several, inside, patches}) list.flush(faults);
}

}  // namespace geomesh::geomodel

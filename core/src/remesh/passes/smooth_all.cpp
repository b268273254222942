// SPDX-License-Identifier: MIT
// Vertices that are moved on all cores, declared in remesh/passes/improve_passes.hpp.
#include "remesh/operations/improve.hpp"
#include "remesh/passes/improve_passes.hpp"

namespace geomesh::remesh {

std::vector<double> smooth_all(Toolbox& tools, const SmoothRule& rule, BlockPass& blocks,
                               const std::function<bool(VertexIndex)>& leaves) {
  const auto is_movable = [&](VertexIndex v) {
    return tools.mesh.kind(v) != VertexKind::corner && !(leaves && leaves(v));
  };
  std::vector<VertexIndex> movable = tools.mesh.vertices_by_cells();
  std::erase_if(movable, [&](VertexIndex v) { return !is_movable(v); });
  tools.make_room_for_normals();
  std::vector<double> gains(tools.mesh.n_vertices(), 0);
  blocks.run(std::move(movable), BlockPass::Changes::places, [&](VertexIndex v, Toolbox& own) {
    const std::optional<double> gain = smooth_beside_others(tools, v, rule, own.work);
    own.statistics.smoothing_moves += gain.has_value();
    gains[v] = gain.value_or(0);
  });
  return gains;
}

}  // namespace geomesh::remesh

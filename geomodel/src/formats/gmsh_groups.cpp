// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gmsh_groups.hpp"

#include <algorithm>

#include "solver_mesh/names.hpp"

namespace geomesh::geomodel {

GmshGroups gmsh_groups(const SolverMesh& mesh, const WriteOptions& options) {
  GmshGroups result;
  result.of_block.resize(mesh.blocks.size());
  SolverNames names(name_limit_gmsh);
  const auto add = [&](const CellGroup& group) {
    const std::string name = names.give(group.full_name);
    result.physicals.push_back({group.dimension, group.id, name});
    result.sidecar.push_back({"physical", group.dimension, group.id, name, group.full_name, group.members});
    for (const std::size_t b : group.blocks) result.of_block[b].push_back(group.id);
  };
  for (const CellGroup& group : options.groups == GroupChoice::both ? mesh.groups : mesh.labels) add(group);
  std::stable_sort(result.physicals.begin(), result.physicals.end(),
                   [](const auto& a, const auto& b) { return a.dimension < b.dimension; });
  return result;
}

int gmsh_type(const SolverMesh& mesh, CellShape shape) {
  const bool second = mesh.second_order();
  switch (shape) {
    case CellShape::vertex:
      return 15;
    case CellShape::edge:
      return second ? 8 : 1;
    case CellShape::triangle:
      return second ? 9 : 2;
    case CellShape::tetrahedron:
      return second ? 11 : 4;
    case CellShape::prism:
      break;
  }
  return 6;
}

std::size_t gmsh_node(const CellBlock& block, std::size_t i) {
  if (block.nodes_per_cell != 10 || i < 8) return i;
  return i == 8 ? 9 : 8;
}

void write_gmsh_head(OutputText& out, const char* version, Encoding encoding, const GmshGroups& groups) {
  out << "$MeshFormat\n" << version << (encoding == Encoding::binary ? " 1 8\n" : " 0 8\n");
  if (encoding == Encoding::binary) out.raw(std::int32_t{1}) << "\n";
  out << "$EndMeshFormat\n$PhysicalNames\n" << groups.physicals.size() << "\n";
  for (const GmshPhysical& p : groups.physicals) out << p.dimension << " " << p.tag << " \"" << p.name << "\"\n";
  out << "$EndPhysicalNames\n";
}

}  // namespace geomesh::geomodel

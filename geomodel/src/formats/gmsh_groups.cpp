// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gmsh_groups.hpp"

#include <algorithm>
#include <limits>

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

namespace {

/// Writes the values of one array to a Gmsh file. `give` receives a function and calls it with each value. Row numbers
/// have 32 bits in every version of the format.
template <class Give>
void write_data(OutputText& out, Encoding encoding, const char* section, const std::string& name, std::size_t n,
                Give&& give) {
  out << "$" << section << "\n1\n\"" << transliterated(name) << "\"\n1\n0\n3\n0\n1\n" << n << "\n";
  GmshNumbers numbers(out, encoding);
  std::int32_t number = 0;
  give([&](double value) {
    numbers.integer(++number);
    numbers.real(value);
    numbers.line();
  });
  out << (encoding == Encoding::binary ? "\n$End" : "$End") << section << "\n";
}

}  // namespace

void write_gmsh_fields(OutputText& out, Encoding encoding, const SolverMesh& mesh,
                       const std::vector<std::size_t>& blocks) {
  std::size_t n = 0;
  for (const std::size_t b : blocks) n += mesh.blocks[b].n_cells();
  for (const CellArray& array : mesh.source->cell_arrays)
    write_data(out, encoding, "ElementData", array.name, n, [&](const auto& put) {
      for (const std::size_t b : blocks) {
        const CellBlock& block = mesh.blocks[b];
        for (std::size_t c = 0; c < block.n_cells(); ++c)
          put(block.shape == CellShape::tetrahedron ? array.values[block.rows[c]]
                                                    : std::numeric_limits<double>::quiet_NaN());
      }
    });
  for (const PointArray& array : mesh.source->point_arrays)
    write_data(out, encoding, "NodeData", array.name, mesh.n_nodes(), [&](const auto& put) {
      for (std::size_t v = 0; v < mesh.n_nodes(); ++v) put(array.values[v]);
    });
}

void write_gmsh_head(OutputText& out, const char* version, Encoding encoding, const GmshGroups& groups) {
  out << "$MeshFormat\n" << version << (encoding == Encoding::binary ? " 1 8\n" : " 0 8\n");
  if (encoding == Encoding::binary) out.raw(std::int32_t{1}) << "\n";
  out << "$EndMeshFormat\n$PhysicalNames\n" << groups.physicals.size() << "\n";
  for (const GmshPhysical& p : groups.physicals) out << p.dimension << " " << p.tag << " \"" << p.name << "\"\n";
  out << "$EndPhysicalNames\n";
}

}  // namespace geomesh::geomodel

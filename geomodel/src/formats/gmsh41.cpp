// SPDX-License-Identifier: GPL-3.0-or-later
// Writes Gmsh MSH 4.1, text and binary. Each block of cells is an entity with its physical groups. Source: the
// reference manual of Gmsh 4.8, "MSH file format".
#include <algorithm>

#include "formats/format_list.hpp"
#include "formats/gmsh41_parts.hpp"
#include "formats/gmsh_groups.hpp"
#include "mesh_readers/mesh_readers.hpp"

namespace geomesh::geomodel {

namespace {

/// A block of cells as a Gmsh entity, with the nodes that it owns. A node belongs to the entity of lowest dimension
/// that contains it.
struct Entity {
  int dimension;
  std::size_t block;
  /// Numbers of the blocks of faces (Gmsh surfaces) that bound a volume, negative if their normal points inwards.
  std::vector<std::int32_t> boundary;
  std::vector<VertexIndex> owned;
};

std::vector<Entity> make_entities(const SolverMesh& mesh) {
  std::vector<Entity> entities;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    entities.push_back({dimension_of(mesh.blocks[b].shape), b, {}, {}});
  for (Entity& volume : entities) {
    const CellBlock& region = mesh.blocks[volume.block];
    if (region.shape != CellShape::tetrahedron) continue;
    for (const CellBlock& face : mesh.blocks) {
      if (face.shape != CellShape::triangle || face.region_minus == face.region_plus) continue;
      if (face.region_minus == region.id) volume.boundary.push_back(face.id);
      if (face.region_plus == region.id) volume.boundary.push_back(-face.id);
    }
  }
  std::stable_sort(entities.begin(), entities.end(),
                   [](const Entity& a, const Entity& b) { return a.dimension < b.dimension; });
  std::vector<bool> taken(mesh.n_nodes(), false);
  for (Entity& entity : entities) {
    for (const VertexIndex v : mesh.blocks[entity.block].nodes)
      if (!taken[v]) {
        taken[v] = true;
        entity.owned.push_back(v);
      }
    std::sort(entity.owned.begin(), entity.owned.end());
  }
  return entities;
}

/// Writes the end of a section of a Gmsh file, on a line of its own, which binary data do not end by themselves.
void end_section(OutputText& out, Encoding encoding, const char* name) {
  out << (encoding == Encoding::binary ? "\n$End" : "$End") << name << "\n";
}

void write_entities(OutputText& out, Encoding encoding, const SolverMesh& mesh, const std::vector<Entity>& entities,
                    const GmshGroups& groups) {
  out << "$Entities\n";
  GmshNumbers numbers(out, encoding);
  for (int d = 0; d < 4; ++d)
    numbers.size(static_cast<std::size_t>(
        std::count_if(entities.begin(), entities.end(), [d](const Entity& e) { return e.dimension == d; })));
  numbers.line();
  for (const Entity& e : entities) {
    const CellBlock& block = mesh.blocks[e.block];
    Box3 box;
    for (const VertexIndex v : block.nodes) box.add(mesh.node(v));
    numbers.integer(block.id);
    numbers.real(box.min);
    if (e.dimension > 0) numbers.real(box.max);
    numbers.size(groups.of_block[e.block].size());
    for (const std::int32_t tag : groups.of_block[e.block]) numbers.integer(tag);
    if (e.dimension > 0) numbers.size(e.boundary.size());
    for (const std::int32_t b : e.boundary) numbers.integer(b);
    numbers.line();
  }
  end_section(out, encoding, "Entities");
}

void write_nodes(OutputText& out, Encoding encoding, const SolverMesh& mesh, const std::vector<Entity>& entities) {
  out << "$Nodes\n";
  GmshNumbers numbers(out, encoding);
  const auto n_blocks =
      std::count_if(entities.begin(), entities.end(), [](const Entity& e) { return !e.owned.empty(); });
  numbers.size(static_cast<std::size_t>(n_blocks));
  numbers.size(mesh.n_nodes());
  numbers.size(1);
  numbers.size(mesh.n_nodes());
  numbers.line();
  for (const Entity& e : entities) {
    if (e.owned.empty()) continue;
    numbers.integer(e.dimension);
    numbers.integer(mesh.blocks[e.block].id);
    numbers.integer(0);
    numbers.size(e.owned.size());
    numbers.line();
    for (const VertexIndex v : e.owned) {
      numbers.size(std::size_t{v} + 1);
      numbers.line();
    }
    for (const VertexIndex v : e.owned) {
      numbers.real(mesh.node(v));
      numbers.line();
    }
  }
  end_section(out, encoding, "Nodes");
}

void write_elements(OutputText& out, Encoding encoding, const SolverMesh& mesh, const std::vector<Entity>& entities) {
  std::size_t n = 0, n_blocks = 0;
  for (const CellBlock& block : mesh.blocks) {
    n += block.n_cells();
    n_blocks += block.n_cells() > 0;
  }
  out << "$Elements\n";
  GmshNumbers numbers(out, encoding);
  numbers.size(n_blocks);
  numbers.size(n);
  numbers.size(1);
  numbers.size(n);
  numbers.line();
  std::size_t element = 0;
  for (const Entity& e : entities) {
    const CellBlock& block = mesh.blocks[e.block];
    if (block.n_cells() == 0) continue;
    numbers.integer(e.dimension);
    numbers.integer(block.id);
    numbers.integer(gmsh_type(mesh, block.shape));
    numbers.size(block.n_cells());
    numbers.line();
    for (std::size_t c = 0; c < block.n_cells(); ++c) {
      numbers.size(++element);
      for (std::size_t i = 0; i < block.nodes_per_cell; ++i)
        numbers.size(std::size_t{block.nodes[c * block.nodes_per_cell + gmsh_node(block, i)]} + 1);
      numbers.line();
    }
  }
  end_section(out, encoding, "Elements");
}

std::vector<std::filesystem::path> write_gmsh41(const ModelMesh& model, const WriteOptions& options,
                                                const std::filesystem::path& stem, Encoding encoding) {
  const SolverMesh mesh = make_solver_mesh(model, options);
  if (options.partitions > 1) return write_gmsh41_parts(mesh, options, stem, encoding);
  const GmshGroups groups = gmsh_groups(mesh, options);
  const std::vector<Entity> entities = make_entities(mesh);
  const std::filesystem::path file = stem.string() + ".msh";
  write_output_text(file, [&](OutputText& out) {
    write_gmsh_head(out, "4.1", encoding, groups);
    write_entities(out, encoding, mesh, entities, groups);
    write_nodes(out, encoding, mesh, entities);
    write_elements(out, encoding, mesh, entities);
    std::vector<std::size_t> blocks;
    for (const Entity& e : entities) blocks.push_back(e.block);
    write_gmsh_fields(out, encoding, mesh, blocks);
  });
  return {file, write_sidecar(model, groups.sidecar, file)};
}

std::vector<std::filesystem::path> write_text(const ModelMesh& mesh, const WriteOptions& options,
                                              const std::filesystem::path& stem) {
  return write_gmsh41(mesh, options, stem, Encoding::text);
}
std::vector<std::filesystem::path> write_binary(const ModelMesh& mesh, const WriteOptions& options,
                                                const std::filesystem::path& stem) {
  return write_gmsh41(mesh, options, stem, Encoding::binary);
}

const FormatHolds holds{.second_order = true,
                        .prisms = true,
                        .curves = true,
                        .overlapping = true,
                        .partitions = true,
                        .triangles_alone = true};

}  // namespace

Format gmsh41_format() { return {"msh", {".msh"}, "Gmsh 4.1, text", holds, write_text, read_gmsh_mesh}; }
Format gmsh41_binary_format() {
  return {"msh-binary", {".msh"}, "Gmsh 4.1, binary", holds, write_binary, read_gmsh_mesh};
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Writes Gmsh MSH 2.2, text and binary, for readers that know no newer version (netgen, FreeFEM, DuMux, Elmer). Source:
// the reference manual of Gmsh 4.8, "MSH file format version 2 (Legacy)".
#include <algorithm>

#include "formats/format_list.hpp"
#include "formats/gmsh41_parts.hpp"
#include "formats/gmsh_groups.hpp"
#include "mesh_readers/mesh_readers.hpp"

namespace geomesh::geomodel {

namespace {

void write_nodes(OutputText& out, Encoding encoding, const SolverMesh& mesh) {
  out << "$Nodes\n" << mesh.n_nodes() << "\n";
  GmshNumbers numbers(out, encoding);
  for (std::size_t v = 0; v < mesh.n_nodes(); ++v) {
    numbers.integer(static_cast<std::int32_t>(v + 1));
    numbers.real(mesh.node(v));
    numbers.line();
  }
  out << (encoding == Encoding::binary ? "\n" : "") << "$EndNodes\n";
}

/// Writes each element once for each of its Gmsh physical groups: the first tag is the group, the second the block.
void write_elements(OutputText& out, Encoding encoding, const SolverMesh& mesh, const GmshGroups& groups) {
  std::size_t n = 0;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) n += mesh.blocks[b].n_cells() * groups.of_block[b].size();
  out << "$Elements\n" << n << "\n";
  GmshNumbers numbers(out, encoding);
  std::int32_t element = 0;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const CellBlock& block = mesh.blocks[b];
    const int type = gmsh_type(mesh, block.shape);
    for (const std::int32_t tag : groups.of_block[b]) {
      if (encoding == Encoding::binary) {
        numbers.integer(type);
        numbers.integer(static_cast<std::int32_t>(block.n_cells()));
        numbers.integer(2);
      }
      for (std::size_t c = 0; c < block.n_cells(); ++c) {
        numbers.integer(++element);
        if (encoding == Encoding::text) {
          numbers.integer(type);
          numbers.integer(2);
        }
        numbers.integer(tag);
        numbers.integer(block.id);
        for (std::size_t i = 0; i < block.nodes_per_cell; ++i)
          numbers.integer(static_cast<std::int32_t>(block.nodes[c * block.nodes_per_cell + gmsh_node(block, i)] + 1));
        numbers.line();
      }
    }
  }
  out << (encoding == Encoding::binary ? "\n" : "") << "$EndElements\n";
}

/// Writes the nodes and elements of a mesh part to a Gmsh file with their numbers in the whole mesh. The tags of an
/// element are its physical group, its block of cells, the part that owns it (from 1), and, as negative numbers, the
/// parts in which it is a ghost.
void write_part(OutputText& out, const SolverMesh& whole, const MeshParts& parts, const SolverPart& part,
                const GmshGroups& groups) {
  out << "$Nodes\n" << part.mesh.n_nodes() << "\n";
  for (std::size_t v = 0; v < part.mesh.n_nodes(); ++v)
    out << part.part.nodes[v] + std::size_t{1} << " " << part.mesh.node(v) << "\n";
  out << "$EndNodes\n$Elements\n";
  std::size_t n = 0;
  for (std::size_t b = 0; b < whole.blocks.size(); ++b) n += part.cells[b].size() * groups.of_block[b].size();
  out << n << "\n";
  std::size_t first = 1;  // number in the whole mesh of the first element of a block of cells and physical group
  for (std::size_t b = 0; b < whole.blocks.size(); ++b) {
    const CellBlock& block = part.mesh.blocks[b];
    for (const std::int32_t tag : groups.of_block[b]) {
      for (std::size_t c = 0; c < block.n_cells(); ++c) {
        const auto node = [&](std::size_t i) { return part.part.nodes[block.nodes[c * block.nodes_per_cell + i]]; };
        std::vector<std::int32_t> others;
        for (std::size_t i = 0; i < block.nodes_per_cell; ++i)
          for (const std::int32_t p : parts.parts_at(node(i)))
            if (p != part.owner[b][c]) others.push_back(p);
        std::sort(others.begin(), others.end());
        others.erase(std::unique(others.begin(), others.end()), others.end());
        out << first + part.cells[b][c] << " " << gmsh_type(part.mesh, block.shape) << " " << 4 + others.size() << " "
            << tag << " " << block.id << " " << 1 + others.size() << " " << part.owner[b][c] + 1;
        for (const std::int32_t p : others) out << " " << -(p + 1);
        for (std::size_t i = 0; i < block.nodes_per_cell; ++i) out << " " << node(gmsh_node(block, i)) + std::size_t{1};
        out << "\n";
      }
      first += whole.blocks[b].n_cells();
    }
  }
  out << "$EndElements\n";
}

std::vector<std::filesystem::path> write_gmsh22(const ModelMesh& model, const WriteOptions& options,
                                                const std::filesystem::path& stem, Encoding encoding) {
  const SolverMesh mesh = make_solver_mesh(model, options);
  if (options.partitions > 1)
    return write_gmsh_parts(
        mesh, options, stem,
        [&](OutputText& out, const MeshParts& parts, const SolverPart& part, const GmshGroups& groups) {
          write_gmsh_head(out, "2.2", Encoding::text, groups);
          write_part(out, mesh, parts, part, groups);
        });
  const GmshGroups groups = gmsh_groups(mesh, options);
  const std::filesystem::path file = stem.string() + ".msh";
  write_output_text(file, [&](OutputText& out) {
    write_gmsh_head(out, "2.2", encoding, groups);
    write_nodes(out, encoding, mesh);
    write_elements(out, encoding, mesh, groups);
    std::vector<std::size_t> blocks;
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) blocks.insert(blocks.end(), groups.of_block[b].size(), b);
    write_gmsh_fields(out, encoding, mesh, blocks);
  });
  return {file, write_sidecar(model, groups.sidecar, file)};
}

std::vector<std::filesystem::path> write_text(const ModelMesh& mesh, const WriteOptions& options,
                                              const std::filesystem::path& stem) {
  return write_gmsh22(mesh, options, stem, Encoding::text);
}
std::vector<std::filesystem::path> write_binary(const ModelMesh& mesh, const WriteOptions& options,
                                                const std::filesystem::path& stem) {
  return write_gmsh22(mesh, options, stem, Encoding::binary);
}

constexpr FormatHolds holds(Encoding encoding) {
  return {.second_order = true,
          .prisms = true,
          .curves = true,
          .overlapping = true,
          .partitions = encoding == Encoding::text,
          .triangles_alone = true};
}

}  // namespace

Format gmsh22_format() {
  return {"msh22", {".msh"}, "Gmsh 2.2, text", holds(Encoding::text), write_text, read_gmsh_mesh};
}
Format gmsh22_binary_format() {
  return {"msh22-binary", {".msh"}, "Gmsh 2.2, binary", holds(Encoding::binary), write_binary, read_gmsh_mesh};
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh MSH 2.2, text and binary, for readers that know no newer version (netgen, FreeFEM, DuMux, Elmer). Followed: the
// reference manual of Gmsh 4.8, "MSH file format version 2 (Legacy)".
#include "formats/format_list.hpp"
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

/// An element is there once for each of its groups, with the group as first tag and the block as second.
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

std::vector<std::filesystem::path> write(const ModelMesh& model, const WriteOptions& options,
                                         const std::filesystem::path& stem, Encoding encoding) {
  const SolverMesh mesh = make_solver_mesh(model, options);
  const GmshGroups groups = gmsh_groups(mesh, options);
  const std::filesystem::path file = stem.string() + ".msh";
  write_output_text(file, [&](OutputText& out) {
    write_gmsh_head(out, "2.2", encoding, groups);
    write_nodes(out, encoding, mesh);
    write_elements(out, encoding, mesh, groups);
  });
  return {file, write_sidecar(model, groups.sidecar, file)};
}

std::vector<std::filesystem::path> write_text(const ModelMesh& mesh, const WriteOptions& options,
                                              const std::filesystem::path& stem) {
  return write(mesh, options, stem, Encoding::text);
}
std::vector<std::filesystem::path> write_binary(const ModelMesh& mesh, const WriteOptions& options,
                                                const std::filesystem::path& stem) {
  return write(mesh, options, stem, Encoding::binary);
}

const FormatHolds holds{.second_order = true, .prisms = true, .curves = true, .overlapping = true};

}  // namespace

Format gmsh22_format() { return {"msh22", {".msh"}, "Gmsh 2.2, text", holds, write_text, read_gmsh_mesh}; }
Format gmsh22_binary_format() {
  return {"msh22-binary", {".msh"}, "Gmsh 2.2, binary", holds, write_binary, read_gmsh_mesh};
}

}  // namespace geomesh::geomodel

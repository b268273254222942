// SPDX-License-Identifier: GPL-3.0-or-later
// Writes TetGen's files: NAME.node, NAME.ele (attribute: the region), NAME.face and NAME.edge (marker: the surface, the
// curve). The marker of a node is the id of a named point, or 0. Items are numbered from 1. Source: "File formats" of
// TetGen 1.5.
#include "formats/format_list.hpp"
#include "solver_mesh/sidecar.hpp"
#include "solver_mesh/solver_mesh.hpp"
#include "writers/text_file.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

/// TetGen: writes a line with the number of nodes and `3 0 1`, then `NUMBER X Y Z MARKER` for each node.
void write_nodes(OutputText& out, const SolverMesh& mesh) {
  std::vector<std::int32_t> markers(mesh.n_nodes(), 0);
  for (const CellGroup& label : mesh.labels)
    if (label.dimension == 0)
      for (const VertexIndex v : nodes_of(mesh, label)) markers[v] = label.id;
  out << mesh.n_nodes() << " 3 0 1\n";
  for (std::size_t v = 0; v < mesh.n_nodes(); ++v) out << v + 1 << " " << mesh.node(v) << " " << markers[v] << "\n";
}

/// TetGen: writes the cells of one dimension as `NUMBER NODES LABEL`, after a line with their number and `columns`.
void write_cells(OutputText& out, const SolverMesh& mesh, int dimension, const char* columns) {
  out << mesh.count(dimension) << columns << "\n";
  std::size_t number = 0;
  for (const CellGroup& label : mesh.labels) {
    if (label.dimension != dimension) continue;
    for (const std::size_t b : label.blocks) {
      const CellBlock& block = mesh.blocks[b];
      for (std::size_t c = 0; c < block.n_cells(); ++c) {
        out << ++number;
        for (std::size_t i = 0; i < block.nodes_per_cell; ++i)
          out << " " << block.nodes[c * block.nodes_per_cell + i] + 1;
        out << " " << label.id << "\n";
      }
    }
  }
}

std::vector<std::filesystem::path> write_tetgen(const ModelMesh& model, const WriteOptions& options,
                                                const std::filesystem::path& stem) {
  WriteOptions one_label = options;
  // A TetGen face has only one marker.
  if (one_label.groups == GroupChoice::both) one_label.groups = GroupChoice::whole;
  const SolverMesh mesh = make_solver_mesh(model, one_label);
  WrittenFiles written;
  const auto write_part = [&](const char* extension, const auto& compose) {
    const std::filesystem::path file = stem.string() + extension;
    write_output_text(file, compose);
    written.add(file);
    return file;
  };
  write_part(".node", [&](OutputText& out) { write_nodes(out, mesh); });
  const auto cells = write_part(".ele", [&](OutputText& out) { write_cells(out, mesh, 3, " 4 1"); });
  write_part(".face", [&](OutputText& out) { write_cells(out, mesh, 2, " 1"); });
  write_part(".edge", [&](OutputText& out) { write_cells(out, mesh, 1, " 1"); });
  std::vector<SidecarGroup> sidecar;
  for (const CellGroup& label : mesh.labels)
    sidecar.push_back({label.dimension == 3 ? "attribute" : "marker", label.dimension, label.id, label.full_name,
                       label.full_name, label.members});
  written.add(write_sidecar(model, sidecar, cells));
  return written.keep();
}

}  // namespace

Format tetgen_format() {
  return {"tetgen",     {".ele"}, "TetGen's .node, .ele, .face, .edge", {.curves = true, .names = false},
          write_tetgen, nullptr};
}

}  // namespace geomesh::geomodel

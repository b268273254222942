// SPDX-License-Identifier: GPL-3.0-or-later
// Writes an implicit unstructured grid for PFLOTRAN: NAME.ugi (cells and vertices), NAME_REGION.txt (cells of a region,
// for REGION / FILE), NAME_SURFACE.ss (faces of a surface). Cells and vertices are numbered from 1. Source: PFLOTRAN's
// user guide, GRID card, TYPE unstructured, and REGION card.
#include "formats/format_list.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "solver_mesh/solver_mesh.hpp"
#include "writers/text_file.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

/// Writes one PFLOTRAN cell or face: a tetrahedron `T 1 2 3 4`, a triangle `T 1 2 3`, a prism `W` with six nodes.
void write_cell(OutputText& out, const CellBlock& block, std::size_t cell) {
  out << (block.shape == CellShape::prism ? "W" : "T");
  for (std::size_t i = 0; i < block.nodes_per_cell; ++i) out << " " << block.nodes[cell * block.nodes_per_cell + i] + 1;
  out << "\n";
}

void write_grid(OutputText& out, const SolverMesh& mesh) {
  out << mesh.n_solids() << " " << mesh.n_nodes() << "\n";
  for (const CellBlock& block : mesh.blocks)
    if (dimension_of(block.shape) == 3)
      for (std::size_t c = 0; c < block.n_cells(); ++c) write_cell(out, block, c);
  for (std::size_t v = 0; v < mesh.n_nodes(); ++v) out << mesh.node(v) << "\n";
}

std::vector<std::filesystem::path> write_pflotran(const ModelMesh& model, const WriteOptions& options,
                                                  const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, options);
  WrittenFiles written;
  SolverNames names(name_limit_plain);
  std::vector<SidecarGroup> sidecar;
  const std::filesystem::path grid = stem.string() + ".ugi";
  write_output_text(grid, [&](OutputText& out) { write_grid(out, mesh); });
  written.add(grid);
  std::vector<std::size_t> first(mesh.blocks.size(), 1);  // number of the first cell of each block of cells
  for (std::size_t b = 1; b < mesh.blocks.size(); ++b)
    first[b] = first[b - 1] + (dimension_of(mesh.blocks[b - 1].shape) == 3 ? mesh.blocks[b - 1].n_cells() : 0);
  for (const CellGroup& group : mesh.groups) {
    if (group.dimension < 2) continue;
    const std::filesystem::path file =
        stem.string() + "_" + names.give(group.full_name) + (group.dimension == 3 ? ".txt" : ".ss");
    write_output_text(file, [&](OutputText& out) {
      std::size_t n = 0;
      for (const std::size_t b : group.blocks) n += mesh.blocks[b].n_cells();
      if (group.dimension == 2) out << n << "\n";
      for (const std::size_t b : group.blocks)
        for (std::size_t c = 0; c < mesh.blocks[b].n_cells(); ++c)
          if (group.dimension == 3) {
            out << first[b] + c << "\n";
          } else {
            write_cell(out, mesh.blocks[b], c);
          }
    });
    written.add(file);
    sidecar.push_back({"file", group.dimension, 0, file.filename().string(), group.full_name, group.members});
  }
  written.add(write_sidecar(model, sidecar, grid));
  return written.keep();
}

}  // namespace

Format pflotran_format() {
  return {"pflotran", {".ugi"}, "PFLOTRAN implicit grid", {.overlapping = true}, write_pflotran, nullptr};
}

}  // namespace geomesh::geomodel

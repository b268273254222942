// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a FLAC3D grid (.f3grid, text): zones in groups by region, faces in groups by surface. A slot holds at most one
// group for each zone or face, so groups that share faces get different slots. Source: "Grid Format (f3grid)" of the
// FLAC3D 7.0 manual, and the reader of meshio.
#include <algorithm>
#include <map>
#include <set>

#include "formats/codes/each_cell.hpp"
#include "formats/format_list.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/text_file.hpp"

namespace geomesh::geomodel {

namespace {

class GridWriter {
 public:
  GridWriter(OutputText& out, const SolverMesh& mesh) : out_(out), mesh_(mesh), first_of_(mesh.blocks.size(), 0) {}

  std::vector<SidecarGroup> write() {
    out_ << "* FLAC3D grid written by geomesh\n* GRIDPOINTS\n";
    for (std::size_t v = 0; v < mesh_.n_nodes(); ++v) out_ << "G " << v + 1 << " " << mesh_.node(v) << "\n";
    out_ << "* ZONES\n";
    write_cells(CellShape::tetrahedron, "Z T4 ");
    out_ << "* FACES\n";
    write_cells(CellShape::triangle, "F T3 ");
    out_ << "* ZONE GROUPS\n";
    write_groups(3, "ZGROUP");
    out_ << "* FACE GROUPS\n";
    write_groups(2, "FGROUP");
    return std::move(sidecar_);
  }

 private:
  void write_cells(CellShape shape, std::string_view start) {
    std::size_t number = 0;
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
      const CellBlock& block = mesh_.blocks[b];
      if (block.shape != shape) continue;
      first_of_[b] = number + 1;
      for (std::size_t c = 0; c < block.n_cells(); ++c) {
        out_ << start << ++number;
        for (std::size_t i = 0; i < block.nodes_per_cell; ++i)
          out_ << " " << block.nodes[c * block.nodes_per_cell + i] + std::size_t{1};
        out_ << "\n";
      }
    }
  }
  /// Returns the first FLAC3D slot in which no cell of the group belongs to another group.
  std::size_t free_slot(const CellGroup& group) {
    std::size_t slot = 1;
    const auto is_taken = [&](std::size_t b) { return slots_of_[b].contains(slot); };
    while (std::any_of(group.blocks.begin(), group.blocks.end(), is_taken)) ++slot;
    for (const std::size_t b : group.blocks) slots_of_[b].insert(slot);
    return slot;
  }
  void write_groups(int dimension, const char* keyword) {
    SolverNames names(name_limit_plain);
    const auto write_group = [&](const CellGroup& group) {
      const std::string name = names.give(group.full_name);
      out_ << keyword << " \"" << name << "\" SLOT " << free_slot(group) << "\n";
      std::size_t column = 0;
      constexpr std::size_t numbers_per_line = 20;
      for (const std::size_t b : group.blocks)
        for (std::size_t c = 0; c < mesh_.blocks[b].n_cells(); ++c)
          out_ << (column % numbers_per_line == 0 ? (column == 0 ? "" : "\n") : " ") << first_of_[b] + c, ++column;
      out_ << "\n";
      sidecar_.push_back({dimension == 3 ? "zgroup" : "fgroup", dimension, 0, name, group.full_name, group.members});
    };
    for (const CellGroup& group : mesh_.groups)
      if (group.dimension == dimension) write_group(group);
    if (dimension == 3)
      for (const CellGroup& group : mesh_.region_groups) write_group(group);
  }

  OutputText& out_;
  const SolverMesh& mesh_;
  std::vector<std::size_t> first_of_;  // number of the first cell of each block of cells
  std::map<std::size_t, std::set<std::size_t>> slots_of_;
  std::vector<SidecarGroup> sidecar_;
};

std::vector<std::filesystem::path> write_flac3d(const ModelMesh& model, const WriteOptions& options,
                                                const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, options);
  const std::filesystem::path file = stem.string() + ".f3grid";
  std::vector<SidecarGroup> sidecar;
  write_output_text(file, [&](OutputText& out) { sidecar = GridWriter(out, mesh).write(); });
  return {file, write_sidecar(model, sidecar, file)};
}

}  // namespace

Format flac3d_format() { return {"flac3d", {".f3grid"}, "FLAC3D", {.overlapping = true}, write_flac3d, nullptr}; }

}  // namespace geomesh::geomodel

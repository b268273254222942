// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a FEFLOW problem file (.fem, text) of an unstructured 3D mesh without physics: tetrahedra with an elemental
// set for each region, and a nodal set for each surface, curve and named point. Source: "FEFLOW ASCII file format" of
// the FEFLOW 7 documentation, and the reader of OpenGeoSys.
#include <algorithm>

#include "formats/codes/each_cell.hpp"
#include "formats/format_list.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/text_file.hpp"

namespace geomesh::geomodel {

namespace {

constexpr int feflow_tetrahedron = 6;  ///< FEFLOW's number for tetrahedral elements

/// Writes ascending numbers in FEFLOW's list format: single numbers and ranges `FIRST-LAST`. A continuation line begins
/// with a tab.
void write_numbers(OutputText& out, const std::vector<std::size_t>& numbers) {
  constexpr std::size_t entries_per_line = 10;
  std::size_t entries = 0;
  for (std::size_t i = 0, end = 0; i < numbers.size(); i = end) {
    for (end = i + 1; end < numbers.size() && numbers[end] == numbers[end - 1] + 1;) ++end;
    out << (entries > 0 && entries % entries_per_line == 0 ? "\n\t" : " ") << numbers[i];
    if (end - i > 1) out << "-" << numbers[end - 1];
    ++entries;
  }
  out << "\n";
}

class ProblemFile {
 public:
  ProblemFile(OutputText& out, const SolverMesh& mesh) : out_(out), mesh_(mesh) {}

  std::vector<SidecarGroup> write() {
    write_header();
    write_elements();
    out_ << "XYZCOOR\n";
    for (std::size_t v = 0; v < mesh_.n_nodes(); ++v) {
      const Vec3& p = mesh_.node(v);
      out_ << " " << p.x << ", " << p.y << ", " << p.z << "\n";
    }
    write_elemental_sets();
    write_nodal_sets();
    out_ << "END\n";
    return std::move(sidecar_);
  }

 private:
  void write_header() {
    // Writes the problem class of a FEFLOW file: saturated flow, steady, 3D (the fourth number), no layers, double
    // precision (8 bytes twice).
    out_ << "PROBLEM: " << transliterated(mesh_.source->name) << "\nCLASS (v.7.006.14742)\n"
         << "   0    0    0    3    0    0    8    8    0    0\n"
         // Writes FEFLOW's numbers of nodes and elements, 0 for "each element names its type", then default settings.
         << "DIMENS\n " << mesh_.n_nodes() << " " << mesh_.n_solids() << " 0 1 0 0 0 0 0 1 0 0 0 0 0 0 0\nSCALE\n\n";
  }
  void write_elements() {
    out_ << "VARNODE\n " << mesh_.n_solids() << " 4 4\n";
    for_each_cell(mesh_, 3, [&](const CellGroup&, const CellBlock&, std::size_t, auto nodes) {
      out_ << " " << feflow_tetrahedron;
      for (const VertexIndex v : nodes) out_ << " " << v + std::size_t{1};
      out_ << "\n";
    });
  }
  /// Groups of regions are written before regions, because readers that give an element one material use the last set
  /// that contains it.
  void write_elemental_sets() {
    SolverNames names(name_limit_plain);
    std::vector<std::size_t> first(mesh_.blocks.size() + 1, 1);
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b)
      first[b + 1] = first[b] + (dimension_of(mesh_.blocks[b].shape) == 3 ? mesh_.blocks[b].n_cells() : 0);
    out_ << "ELEMENTALSETS\n";
    const auto write_set = [&](const CellGroup& group) {
      std::vector<std::size_t> elements;
      for (const std::size_t b : group.blocks)
        for (std::size_t e = first[b]; e < first[b + 1]; ++e) elements.push_back(e);
      std::sort(elements.begin(), elements.end());
      const std::string name = names.give(group.full_name);
      out_ << " " << name;
      write_numbers(out_, elements);
      sidecar_.push_back({"elemental set", 3, 0, name, group.full_name, group.members});
    };
    for (const CellGroup& group : mesh_.region_groups) write_set(group);
    for (const CellGroup& group : mesh_.groups)
      if (group.dimension == 3) write_set(group);
  }
  void write_nodal_sets() {
    SolverNames names(name_limit_plain);
    out_ << "NODALSETS\n";
    for (const CellGroup& group : mesh_.groups) {
      if (group.dimension == 3) continue;
      std::vector<std::size_t> nodes;
      for (const VertexIndex v : nodes_of(mesh_, group)) nodes.push_back(v + std::size_t{1});
      const std::string name = names.give(group.full_name);
      out_ << " " << name;
      write_numbers(out_, nodes);
      sidecar_.push_back({"nodal set", group.dimension, 0, name, group.full_name, group.members});
    }
  }

  OutputText& out_;
  const SolverMesh& mesh_;
  std::vector<SidecarGroup> sidecar_;
};

std::vector<std::filesystem::path> write_feflow(const ModelMesh& model, const WriteOptions& options,
                                                const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, options);
  const std::filesystem::path file = stem.string() + ".fem";
  std::vector<SidecarGroup> sidecar;
  write_output_text(file, [&](OutputText& out) { sidecar = ProblemFile(out, mesh).write(); });
  return {file, write_sidecar(model, sidecar, file)};
}

}  // namespace

Format feflow_format() {
  return {"feflow", {".fem"}, "FEFLOW", {.curves = true, .overlapping = true}, write_feflow, nullptr};
}

}  // namespace geomesh::geomodel

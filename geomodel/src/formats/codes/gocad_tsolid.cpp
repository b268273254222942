// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a GOCAD TSolid (.so, text), for SKUA: a volume (TVOLUME) for each region, then the model: surfaces with their
// triangles, and for each region one surface that bounds it, with the side on which the region lies. Source: "GOCAD
// ASCII File Format" (GOCAD 2.5), and the reader of RINGMesh.
#include "formats/codes/each_cell.hpp"
#include "formats/format_list.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/gocad_header.hpp"
#include "writers/text_file.hpp"

namespace geomesh::geomodel {

namespace {

class SolidFile {
 public:
  SolidFile(OutputText& out, const SolverMesh& mesh) : out_(out), mesh_(mesh), number_(mesh.n_nodes(), 0) {}

  std::vector<SidecarGroup> write() {
    SolverNames volumes(name_limit_plain), surfaces(name_limit_plain);
    out_ << gocad_header("TSolid", transliterated(mesh_.source->name), mesh_.source->unit);
    for (const CellGroup& label : mesh_.labels)
      if (label.dimension == 3) write_volume(label, volumes.give(label.full_name));
    out_ << "MODEL\n";
    for (const CellGroup& label : mesh_.labels)
      if (label.dimension == 2) write_surface(label, surfaces.give(label.full_name));
    for (const SidecarGroup& group : sidecar_)
      if (group.dimension == 3) write_region(group);
    out_ << "END\n";
    return std::move(sidecar_);
  }

 private:
  /// Writes the GOCAD volume of a region. A node is written before the first volume with it; later ones refer to it.
  void write_volume(const CellGroup& label, const std::string& name) {
    out_ << "TVOLUME " << name << "\n";
    const auto each = [&](const auto& visit) {
      for (const std::size_t b : label.blocks)
        for (std::size_t i = 0; i < mesh_.blocks[b].nodes.size(); ++i) visit(i, mesh_.blocks[b].nodes[i]);
    };
    each([&](std::size_t, VertexIndex v) {
      if (number_[v] != 0) return;
      number_[v] = ++n_written_;
      out_ << "VRTX " << number_[v] << " " << mesh_.node(v) << "\n";
    });
    each([&](std::size_t i, VertexIndex v) {
      out_ << (i % 4 == 0 ? "TETRA " : " ") << number_[v] << (i % 4 == 3 ? "\n" : "");
    });
    sidecar_.push_back({"tvolume", 3, label.id, name, label.full_name, label.members});
  }
  /// Writes a surface with one part (TFACE) for each pair of regions between which its faces lie.
  void write_surface(const CellGroup& label, const std::string& name) {
    out_ << "SURFACE " << name << "\n";
    for (const std::size_t b : label.blocks) {
      const CellBlock& block = mesh_.blocks[b];
      parts_.push_back(&block);
      out_ << "TFACE " << parts_.size() << "\nKEYVERTICES";
      for (std::size_t i = 0; i < 3; ++i) out_ << " " << number_[block.nodes[i]];
      for (std::size_t i = 0; i < block.nodes.size(); ++i)
        out_ << (i % 3 == 0 ? "\nTRGL " : " ") << number_[block.nodes[i]];
      out_ << "\n";
    }
    sidecar_.push_back({"surface", 2, 0, name, label.full_name, label.members});
  }
  /// Writes a region of a GOCAD TSolid with one part of a surface that bounds it, and the side of this part on which
  /// the region lies. Normals of faces point from the minus to the plus side.
  void write_region(const SidecarGroup& group) {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const bool minus = parts_[p]->region_minus == group.id, plus = parts_[p]->region_plus == group.id;
      if (minus == plus) continue;
      out_ << "MODEL_REGION " << group.name << (plus ? " +" : " -") << p + 1 << "\n";
      return;
    }
  }

  OutputText& out_;
  const SolverMesh& mesh_;
  // Number of each node in the TSolid file, from 1; 0 if the node has not been written yet.
  std::vector<std::size_t> number_;
  std::size_t n_written_ = 0;
  std::vector<const CellBlock*> parts_;
  std::vector<SidecarGroup> sidecar_;
};

std::vector<std::filesystem::path> write_gocad_tsolid(const ModelMesh& model, const WriteOptions& options,
                                                      const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, with_one_number(options));
  const std::filesystem::path file = stem.string() + ".so";
  std::vector<SidecarGroup> sidecar;
  write_output_text(file, [&](OutputText& out) { sidecar = SolidFile(out, mesh).write(); });
  return {file, write_sidecar(model, sidecar, file)};
}

}  // namespace

Format gocad_tsolid_format() { return {"tsolid", {".so"}, "GOCAD TSolid (SKUA)", {}, write_gocad_tsolid, nullptr}; }

}  // namespace geomesh::geomodel

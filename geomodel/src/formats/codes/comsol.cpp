// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a COMSOL mesh (.mphtxt, text): one mesh object, and a selection for each region, surface, curve and named
// point. Domains are numbered from 1, boundaries, edges and points from 0. Faces of a surface between different pairs
// of regions are different boundaries, as COMSOL requires. Source: "The COMSOL File Formats", Programming Reference
// Manual 6.0.
#include <map>

#include "formats/codes/each_cell.hpp"
#include "formats/format_list.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/text_file.hpp"

namespace geomesh::geomodel {

namespace {

constexpr const char* tag_of_mesh = "mesh1";

/// COMSOL texts are written after their length.
void write_word(OutputText& out, const std::string& word) { out << word.size() << " " << word; }

class MeshFile {
 public:
  MeshFile(OutputText& out, const SolverMesh& mesh) : out_(out), mesh_(mesh) {
    std::array<std::size_t, 4> next{0, 0, 0, 1};
    for (const CellBlock& block : mesh.blocks)
      entity_of_.push_back(next[static_cast<std::size_t>(dimension_of(block.shape))]++);
  }

  std::vector<SidecarGroup> write() {
    for (const CellGroup& group : mesh_.groups) selections_.push_back(&group);
    for (const CellGroup& group : mesh_.region_groups) selections_.push_back(&group);
    write_header();
    write_mesh();
    for (std::size_t s = 0; s < selections_.size(); ++s) write_selection(s);
    return std::move(sidecar_);
  }

 private:
  void write_header() {
    const std::size_t n = selections_.size() + 1;
    out_ << "# Created by geomesh\n\n# Major & minor version\n0 1\n" << n << " # number of tags\n# Tags\n";
    write_word(out_, tag_of_mesh);
    out_ << "\n";
    for (std::size_t s = 0; s < selections_.size(); ++s) {
      write_word(out_, std::string(tag_of_mesh) + "_sel" + std::to_string(s + 1));
      out_ << "\n";
    }
    out_ << n << " # number of types\n# Types\n";
    for (std::size_t i = 0; i < n; ++i) out_ << "3 obj\n";
  }
  void write_mesh() {
    out_ << "\n# --------- Object 0 ----------\n\n0 0 1\n4 Mesh # class\n4 # version\n3 # sdim\n"
         << mesh_.n_nodes()
         << " # number of mesh vertices\n0 # lowest mesh vertex index\n\n# Mesh vertex coordinates\n";
    for (std::size_t v = 0; v < mesh_.n_nodes(); ++v) out_ << mesh_.node(v) << "\n";
    const std::array<const char*, 4> types{"3 vtx", "3 edg", "3 tri", "3 tet"};
    std::size_t n_types = 0;
    for (int dimension = 0; dimension < 4; ++dimension) n_types += mesh_.count(dimension) > 0 ? 1 : 0;
    out_ << "\n" << n_types << " # number of element types\n";
    std::size_t number = 0;
    for (int dimension = 0; dimension < 4; ++dimension)
      if (mesh_.count(dimension) > 0) write_type(number++, dimension, types[static_cast<std::size_t>(dimension)]);
  }
  void write_type(std::size_t number, int dimension, const char* type) {
    const std::size_t n = mesh_.count(dimension);
    out_ << "\n# Type #" << number << "\n\n"
         << type << " # type name\n\n"
         << dimension + 1 << " # number of vertices per element\n"
         << n << " # number of elements\n# Elements\n";
    for (const CellBlock& block : mesh_.blocks)
      if (dimension_of(block.shape) == dimension)
        for (std::size_t i = 0; i < block.nodes.size(); ++i)
          out_ << block.nodes[i] << ((i + 1) % block.nodes_per_cell == 0 ? "\n" : " ");
    out_ << "\n" << n << " # number of geometric entity indices\n# Geometric entity indices\n";
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b)
      if (dimension_of(mesh_.blocks[b].shape) == dimension)
        for (std::size_t c = 0; c < mesh_.blocks[b].n_cells(); ++c) out_ << entity_of_[b] << "\n";
  }
  void write_selection(std::size_t s) {
    const CellGroup& group = *selections_[s];
    SolverNames& names = names_.try_emplace(group.dimension, name_limit_plain).first->second;
    const std::string name = names.give(group.full_name);
    out_ << "\n# --------- Object " << s + 1 << " ----------\n\n0 0 1\n9 Selection # class\n0 # Version\n";
    write_word(out_, name);
    out_ << " # Label\n";
    write_word(out_, tag_of_mesh);
    out_ << " # Geometry/mesh tag\n"
         << group.dimension << " # Dimension\n"
         << group.blocks.size() << " # Number of entities\n# Entities\n";
    for (const std::size_t b : group.blocks) out_ << entity_of_[b] << "\n";
    sidecar_.push_back({"selection", group.dimension, 0, name, group.full_name, group.members});
  }

  OutputText& out_;
  const SolverMesh& mesh_;
  std::vector<std::size_t> entity_of_;  // by block
  std::vector<const CellGroup*> selections_;
  std::map<int, SolverNames> names_;  // by dimension
  std::vector<SidecarGroup> sidecar_;
};

std::vector<std::filesystem::path> write_comsol(const ModelMesh& model, const WriteOptions& options,
                                                const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, options);
  const std::filesystem::path file = stem.string() + ".mphtxt";
  std::vector<SidecarGroup> sidecar;
  write_output_text(file, [&](OutputText& out) { sidecar = MeshFile(out, mesh).write(); });
  return {file, write_sidecar(model, sidecar, file)};
}

}  // namespace

Format comsol_format() {
  return {"comsol", {".mphtxt"}, "COMSOL Multiphysics", {.curves = true, .overlapping = true}, write_comsol, nullptr};
}

}  // namespace geomesh::geomodel

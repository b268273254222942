// SPDX-License-Identifier: GPL-3.0-or-later
// Writes input of Abaqus and CalculiX: nodes, elements by region, node sets, surfaces on element faces. Source: the
// manuals of CalculiX 2.20 (*ELEMENT, *SURFACE) and of Abaqus 6.14 (COH3D6).
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>

#include "formats/format_list.hpp"
#include "mesh_readers/mesh_readers.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "solver_mesh/solver_mesh.hpp"
#include "starters/starters.hpp"
#include "writers/text_file.hpp"

namespace geomesh::geomodel {

namespace {

/// Number of the side of an Abaqus C3D4 element opposite each vertex: S1 = 1-2-3, S2 = 1-4-2, S3 = 2-4-3, S4 = 3-4-1.
constexpr int side_opposite[] = {3, 4, 2, 1};

/// Writes a number in at most 20 characters, because CalculiX reads only the first 20 characters of a number. 17 digits
/// with sign and point fit; if an exponent is needed too, the last digits are dropped.
std::string text_of_20(double value) {
  char buffer[400];
  std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  for (int precision = 16; text.size() > 20; --precision) {
    text.assign(buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, precision).ptr);
    const double read = std::strtod(text.c_str(), nullptr);
    if (text.size() <= 20 && read == value) break;
    text.assign(buffer,
                std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, precision).ptr);
  }
  return text;
}

struct ElementSide {
  std::size_t element;  ///< from 1
  int side;
  std::int32_t region;
};

/// Returns node `i` of an element in Abaqus' order, which equals VTK's for tetrahedra (C3D4, C3D10) and for the
/// midpoints of triangles.
std::size_t node_at(const CellBlock& block, std::size_t cell, std::size_t i) {
  return block.nodes[cell * block.nodes_per_cell + i] + std::size_t{1};
}

/// Writes an Abaqus input file. Element sets, node sets and surfaces have separate name spaces.
class InputDeck {
 public:
  InputDeck(OutputText& text, const SolverMesh& mesh, const WriteOptions& options)
      : text_(text), mesh_(mesh), options_(options) {}

  std::vector<SidecarGroup> write() {
    const ModelMesh& model = *mesh_.source;
    text_ << "*HEADING\n" << transliterated(model.name) << "\n*NODE\n";
    for (std::size_t v = 0; v < mesh_.n_nodes(); ++v) {
      const Vec3& p = mesh_.node(v);
      text_ << v + 1 << ", " << text_of_20(p.x) << ", " << text_of_20(p.y) << ", " << text_of_20(p.z) << "\n";
    }
    add_solids();
    add_surfaces();
    for (const CellGroup& group : mesh_.groups)
      if (group.dimension < 2) add_node_set(group.full_name, nodes_of(mesh_, group), group.dimension, group.members);
    for (const NodeSet& set : model.node_sets) add_node_set(set.name, set.nodes, 0, {set.id});
    return std::move(sidecar_);
  }

 private:
  const char* type_of(const CellBlock& block) const {
    if (block.shape == CellShape::prism) return "COH3D6";
    return mesh_.second_order() ? "C3D10" : "C3D4";
  }
  void add_solids() {
    std::map<std::size_t, std::string> names;  // by block
    std::size_t element = 0;
    region_of_.reserve(mesh_.n_solids());
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
      const CellBlock& block = mesh_.blocks[b];
      if (dimension_of(block.shape) != 3) continue;
      const std::string name = names[b] = element_sets_.give(block.full_name);
      text_ << "*ELEMENT, TYPE=" << type_of(block) << ", ELSET=" << name << "\n";
      for (std::size_t c = 0; c < block.n_cells(); ++c) {
        text_ << ++element;
        region_of_.push_back(block.id);
        for (std::size_t i = 0; i < block.nodes_per_cell; ++i) text_ << ", " << node_at(block, c, i);
        text_ << "\n";
      }
      sidecar_.push_back({"elset", 3, 0, name, block.full_name, block.members});
    }
    for (const CellGroup& group : mesh_.region_groups) {
      const std::string name = element_sets_.give(group.full_name);
      text_ << "*ELSET, ELSET=" << name << "\n";
      for (const std::size_t b : group.blocks) text_ << names[b] << "\n";
      sidecar_.push_back({"elset", 3, 0, name, group.full_name, {}});
    }
  }
  void add_node_set(const std::string& full_name, const std::vector<VertexIndex>& rows, int dimension,
                    const std::vector<std::int32_t>& members) {
    if (rows.empty()) return;
    const std::string name = node_sets_.give(full_name);
    text_ << "*NSET, NSET=" << name << "\n";
    for (std::size_t i = 0; i < rows.size(); ++i)
      text_ << rows[i] + 1 << (i % 8 == 7 || i + 1 == rows.size() ? "\n" : ", ");
    sidecar_.push_back({"nset", dimension, 0, name, full_name, members});
  }
  void add_surface(const std::string& full_name, const std::vector<ElementSide>& sides,
                   const std::vector<std::int32_t>& members) {
    if (sides.empty()) return;
    const std::string name = surfaces_.give(full_name);
    text_ << "*SURFACE, NAME=" << name << ", TYPE=ELEMENT\n";
    for (const ElementSide& s : sides) text_ << s.element << ", S" << s.side << "\n";
    sidecar_.push_back({"surface", 2, 0, name, full_name, members});
  }
  /// Divides a surface by the regions of the elements beside it, and adds a surface for each, if there are several: for
  /// a side of the box by unit, for a side of a fault by block.
  void add_surface_by_region(const std::string& full_name, const std::vector<ElementSide>& sides,
                             const std::vector<std::int32_t>& members) {
    std::map<std::int32_t, std::vector<ElementSide>> of_region;
    for (const ElementSide& side : sides) of_region[side.region].push_back(side);
    if (of_region.size() < 2) return;
    for (const auto& [region, part] : of_region)
      add_surface(full_name + "/" + mesh_.source->regions[static_cast<std::size_t>(region - 1)].name, part, members);
  }
  void add_surfaces() {
    for (const NamedSurface& surface : mesh_.source->surfaces) {
      CellGroup whole{surface.id, 2, surface.name, {}, {surface.id}};
      std::vector<ElementSide> minus, plus;
      for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
        const CellBlock& block = mesh_.blocks[b];
        if (block.shape != CellShape::triangle) continue;
        if (std::find(block.members.begin(), block.members.end(), surface.id) == block.members.end()) continue;
        whole.blocks.push_back(b);
        for (const auto& sides : block.sides) {
          add_side(sides[0], minus);
          add_side(sides[1], plus);
        }
      }
      add_node_set(surface.name, nodes_of(mesh_, whole), 2, whole.members);
      const std::string first = surface.name + (plus.empty() ? ".faces" : ".minus"), second = surface.name + ".plus";
      if (options_.groups != GroupChoice::pieces) {
        add_surface(first, minus, whole.members);
        add_surface(second, plus, whole.members);
      }
      if (options_.groups != GroupChoice::whole) {
        const std::size_t before = sidecar_.size();
        add_surface_by_region(plus.empty() ? surface.name : first, minus, whole.members);
        if (sidecar_.size() == before && options_.groups == GroupChoice::pieces)
          add_surface(first, minus, whole.members);
        const std::size_t middle = sidecar_.size();
        add_surface_by_region(second, plus, whole.members);
        if (sidecar_.size() == middle && options_.groups == GroupChoice::pieces)
          add_surface(second, plus, whole.members);
      }
    }
  }
  void add_side(const FaceSide& side, std::vector<ElementSide>& sides) const {
    if (side.solid == no_cell) return;
    sides.push_back({side.solid + std::size_t{1}, side_opposite[side.opposite], region_of_[side.solid]});
  }

  OutputText& text_;
  const SolverMesh& mesh_;
  const WriteOptions& options_;
  SolverNames element_sets_{name_limit_abaqus}, node_sets_{name_limit_abaqus}, surfaces_{name_limit_abaqus};
  std::vector<SidecarGroup> sidecar_;
  std::vector<std::int32_t> region_of_;  // by solid
};

std::vector<std::filesystem::path> write_abaqus_inp(const ModelMesh& model, const WriteOptions& options,
                                                    const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, options);
  const std::filesystem::path file = stem.string() + ".inp";
  std::vector<SidecarGroup> sidecar;
  write_output_text(file, [&](OutputText& out) { sidecar = InputDeck(out, mesh, options).write(); });
  return {file, write_sidecar(model, sidecar, file)};
}

}  // namespace

Format abaqus_format() {
  return {"inp",
          {".inp"},
          "Abaqus, CalculiX",
          {.second_order = true, .prisms = true, .curves = true, .overlapping = true},
          write_abaqus_inp,
          read_abaqus_mesh,
          write_calculix_starter,
          [](double coordinate) { return std::strtod(text_of_20(coordinate).c_str(), nullptr); }};
}

}  // namespace geomesh::geomodel

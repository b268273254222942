// SPDX-License-Identifier: GPL-3.0-or-later
// Writes MED for Code_Aster and SALOME with libmedc (built only if it is available). Each block of cells is a family,
// with the groups to which the block belongs; node families are combinations of node groups. Source: the documentation
// of MED 4.1. A MED tetrahedron has the opposite orientation to VTK's.
#include <med.h>

#include <algorithm>
#include <map>

#include "formats/modules/format_module.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "mesh_readers/mesh_readers.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "solver_mesh/solver_mesh.hpp"
#include "writers/hdf5_times.hpp"
#include "writers/room_on_disk.hpp"

namespace geomesh::geomodel {

namespace {

/// Returns the position in VTK's order of node `i` of a MED element.
std::size_t vtk_node(CellShape shape, std::size_t i) {
  constexpr std::array<std::size_t, 10> tetrahedron{0, 2, 1, 3, 6, 5, 4, 7, 9, 8};
  constexpr std::array<std::size_t, 6> prism{0, 2, 1, 3, 5, 4};
  return shape == CellShape::tetrahedron ? tetrahedron[i] : shape == CellShape::prism ? prism[i] : i;
}

med_geometry_type geometry_of(const SolverMesh& mesh, CellShape shape) {
  constexpr std::array<std::array<med_geometry_type, 2>, 5> types{{{MED_POINT1, MED_POINT1},
                                                                   {MED_SEG2, MED_SEG3},
                                                                   {MED_TRIA3, MED_TRIA6},
                                                                   {MED_TETRA4, MED_TETRA10},
                                                                   {MED_PENTA6, MED_PENTA6}}};
  return types[static_cast<std::size_t>(shape)][mesh.second_order() ? 1 : 0];
}

/// A MED file that is being written. Every failure of the library is reported as a failure to write the file.
class MedWriter {
 public:
  MedWriter(const std::filesystem::path& temporary, const std::filesystem::path& file, const SolverMesh& mesh)
      : temporary_(temporary), file_(file), mesh_(mesh) {
    collect_node_families();
    require_room(temporary, file, most_bytes());
    id_ = MEDfileOpen(temporary.string().c_str(), MED_ACC_CREAT);
    if (id_ < 0) refuse_to_write(file_);
    name_ = SolverNames(MED_NAME_SIZE).give(mesh.source->name);
  }
  ~MedWriter() {
    if (id_ >= 0) MEDfileClose(id_);
  }
  MedWriter(const MedWriter&) = delete;
  MedWriter& operator=(const MedWriter&) = delete;

  std::vector<SidecarGroup> write() {
    const std::string axes = padded("x") + padded("y") + padded("z"),
                      units = padded(mesh_.source->unit) + padded(mesh_.source->unit) + padded(mesh_.source->unit);
    require(MEDmeshCr(id_, name_.c_str(), 3, 3, MED_UNSTRUCTURED_MESH, "", "", MED_SORT_DTIT, MED_CARTESIAN,
                      axes.c_str(), units.c_str()));
    put_family("FAMILLE_ZERO", 0, {});
    put_nodes();
    put_cells();
    const med_err status = MEDfileClose(id_);
    id_ = -1;
    require(status);
    if (!clear_hdf5_times(temporary_)) refuse_to_write(file_);
    return std::move(sidecar_);
  }

 private:
  static std::string padded(std::string text) {
    text.resize(MED_SNAME_SIZE, ' ');
    return text;
  }
  void require(med_err status) const {
    if (status < 0) refuse_to_write(file_);
  }
  void put_family(const std::string& name, med_int number, const std::vector<std::string>& groups) {
    std::string names;
    for (const std::string& group : groups) {
      names += group;
      names.resize((names.size() + MED_LNAME_SIZE - 1) / MED_LNAME_SIZE * MED_LNAME_SIZE, '\0');
    }
    require(MEDfamilyCr(id_, name_.c_str(), name.c_str(), number, static_cast<med_int>(groups.size()), names.c_str()));
  }
  std::string give_name(const char* type, const CellGroup& group, SolverNames& names) {
    std::string name = names.give(group.full_name);
    sidecar_.push_back({type, group.dimension, 0, name, group.full_name, group.members});
    return name;
  }

  /// Collects the MED families of nodes: one for each combination of groups to which a node belongs.
  void collect_node_families() {
    // For each node, the MED groups to which it belongs; nodes in no group are not included.
    std::map<VertexIndex, std::vector<std::size_t>> sets_of;
    SolverNames give(name_limit_med);
    const auto add = [&](const CellGroup& group, const std::vector<VertexIndex>& nodes) {
      for (const VertexIndex v : nodes) sets_of[v].push_back(node_groups_.size());
      node_groups_.push_back(give_name("node group", group, give));
    };
    for (const CellGroup& group : mesh_.groups)
      if (group.dimension < 3) add(group, nodes_of(mesh_, group));
    for (const NodeSet& set : mesh_.source->node_sets) add({0, 0, set.name, {}, {set.id}}, set.nodes);
    node_families_[{}] = 0;
    family_of_node_.assign(mesh_.n_nodes(), 0);
    for (const auto& [node, sets] : sets_of)
      family_of_node_[node] =
          node_families_.try_emplace(sets, static_cast<med_int>(node_families_.size())).first->second;
  }
  /// Returns the number of bytes of all numbers in the file, plus the most that HDF5 adds for each family and group.
  std::size_t most_bytes() const {
    constexpr std::size_t of_file = 1 << 16, of_family = 1 << 12, of_group = 512;
    std::size_t bytes = of_file + mesh_.n_nodes() * (3 * sizeof(med_float) + sizeof(med_int));
    for (const CellBlock& block : mesh_.blocks)
      bytes += (block.nodes.size() + block.n_cells()) * sizeof(med_int) + of_family;
    for (const CellGroup& group : mesh_.groups) bytes += group.blocks.size() * of_group;
    for (const auto& [sets, number] : node_families_) bytes += of_family + sets.size() * of_group;
    return bytes;
  }

  /// Writes rows of `width` numbers to a MED file in portions, because a copy of all would be as large as the mesh.
  /// `add(row, list)` appends a row's numbers to `list`; `put(filter, list)` writes the rows selected by the filter.
  template <class Number, class Add, class Put>
  void put_rows(std::size_t n, std::size_t width, Add&& add, Put&& put) {
    constexpr std::size_t at_once = 1 << 16;
    std::vector<Number> list;
    for (std::size_t first = 0; first < n; first += at_once) {
      const std::size_t count = std::min(at_once, n - first);
      list.clear();
      for (std::size_t row = first; row < first + count; ++row) add(row, list);
      med_filter filter = MED_FILTER_INIT;
      require(MEDfilterBlockOfEntityCr(id_, static_cast<med_int>(n), 1, static_cast<med_int>(width),
                                       MED_ALL_CONSTITUENT, MED_FULL_INTERLACE, MED_COMPACT_STMODE, MED_NO_PROFILE,
                                       first + 1, count, 1, count, 0, &filter));
      const med_err status = put(&filter, list.data());
      require(MEDfilterClose(&filter));
      require(status);
    }
  }
  /// Writes the MED family number of each node or cell, which `family(row)` returns.
  template <class F>
  void put_families(med_entity_type entity, med_geometry_type type, std::size_t n, F&& family) {
    put_rows<med_int>(
        n, 1, [&](std::size_t row, std::vector<med_int>& list) { list.push_back(family(row)); },
        [&](const med_filter* filter, const med_int* list) {
          return MEDmeshEntityAttributeAdvancedWr(id_, name_.c_str(), MED_FAMILY_NUMBER, MED_NO_DT, MED_NO_IT, entity,
                                                  type, filter, list);
        });
  }
  void put_nodes() {
    put_rows<med_float>(
        mesh_.n_nodes(), 3,
        [&](std::size_t v, std::vector<med_float>& list) {
          for (std::size_t k = 0; k < 3; ++k) list.push_back(mesh_.node(v)[k]);
        },
        [&](const med_filter* filter, const med_float* list) {
          return MEDmeshNodeCoordinateAdvancedWr(id_, name_.c_str(), MED_NO_DT, MED_NO_IT, MED_NO_DT, filter, list);
        });
    for (const auto& [sets, number] : node_families_) {
      std::vector<std::string> groups;
      for (const std::size_t set : sets) groups.push_back(node_groups_[set]);
      if (number != 0) put_family("N" + std::to_string(number), number, groups);
    }
    put_families(MED_NODE, MED_NONE, mesh_.n_nodes(), [&](std::size_t v) { return family_of_node_[v]; });
  }

  /// Writes the cells of a MED file, sorted by shape. The family of block b has the number -1 - b.
  void put_cells() {
    std::vector<std::vector<std::string>> groups_of(mesh_.blocks.size());
    SolverNames give(name_limit_med);
    for (const auto* groups : {&mesh_.groups, &mesh_.region_groups})
      for (const CellGroup& group : *groups) {
        const std::string name = give_name("cell group", group, give);
        if (groups == &mesh_.region_groups) sidecar_.back().members.clear();
        for (const std::size_t b : group.blocks) groups_of[b].push_back(name);
      }
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b)
      put_family("E" + std::to_string(b + 1), -1 - static_cast<med_int>(b), groups_of[b]);
    for (const CellShape shape :
         {CellShape::vertex, CellShape::edge, CellShape::triangle, CellShape::tetrahedron, CellShape::prism})
      put_cells_of(shape);
  }
  void put_cells_of(CellShape shape) {
    // blocks of cells of this shape, and number of cells up to the end of each block
    std::vector<std::size_t> blocks, ends;
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
      if (mesh_.blocks[b].shape != shape || mesh_.blocks[b].n_cells() == 0) continue;
      blocks.push_back(b);
      ends.push_back((ends.empty() ? 0 : ends.back()) + mesh_.blocks[b].n_cells());
    }
    if (blocks.empty()) return;
    const auto place = [&](std::size_t cell) {
      return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), cell) - ends.begin());
    };
    const med_geometry_type type = geometry_of(mesh_, shape);
    const std::size_t width = mesh_.blocks[blocks.front()].nodes_per_cell;
    put_rows<med_int>(
        ends.back(), width,
        [&](std::size_t cell, std::vector<med_int>& list) {
          const std::size_t at = place(cell), row = cell - (at == 0 ? 0 : ends[at - 1]);
          for (std::size_t i = 0; i < width; ++i)
            list.push_back(static_cast<med_int>(mesh_.blocks[blocks[at]].nodes[row * width + vtk_node(shape, i)]) + 1);
        },
        [&](const med_filter* filter, const med_int* list) {
          return MEDmeshElementConnectivityAdvancedWr(id_, name_.c_str(), MED_NO_DT, MED_NO_IT, MED_NO_DT, MED_CELL,
                                                      type, MED_NODAL, filter, list);
        });
    put_families(MED_CELL, type, ends.back(),
                 [&](std::size_t cell) { return -1 - static_cast<med_int>(blocks[place(cell)]); });
  }

  const std::filesystem::path &temporary_, &file_;
  const SolverMesh& mesh_;
  std::string name_;
  med_idt id_ = -1;
  std::vector<std::string> node_groups_;
  // MED numbers of the families of nodes, by the groups to which their nodes belong.
  std::map<std::vector<std::size_t>, med_int> node_families_;
  std::vector<med_int> family_of_node_;
  std::vector<SidecarGroup> sidecar_;
};

std::vector<std::filesystem::path> write(const ModelMesh& model, const WriteOptions& options,
                                         const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, options);
  const std::filesystem::path file = stem.string() + ".med";
  std::vector<SidecarGroup> sidecar;
  write_complete_or_absent(
      file, [&](const std::filesystem::path& temporary) { sidecar = MedWriter(temporary, file, mesh).write(); });
  return {file, write_sidecar(model, sidecar, file)};
}

}  // namespace

}  // namespace geomesh::geomodel

GEOMESH_FORMAT_MODULE(geomesh::geomodel::write, geomesh::geomodel::read_med_mesh, nullptr)

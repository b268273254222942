// SPDX-License-Identifier: GPL-3.0-or-later
// Writes Exodus II: named element blocks, side sets and node sets, for MOOSE, libMesh, PyLith, Sierra. Exodus is a
// layout of netCDF, which is written here by netCDF's own library. Sources: Schoof and Yarberry, "EXODUS II: a finite
// element data model" (SAND92-2137), and files of the Exodus library of Sandia (version 8.11), whose layout is used
// here.
#include <algorithm>
#include <fstream>
#include <map>

#include "formats/exodus/exodus_fields.hpp"
#include "formats/exodus/exodus_part.hpp"
#include "formats/modules/format_module.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "mesh_readers/mesh_readers.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "solver_mesh/solver_mesh.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

/// An Exodus file that is being written. Every failure of the library is reported as a failure to write the file.
class ExodusWriter {
 public:
  /// Opens an Exodus file for writing. `part` is null if the whole mesh is written to one file.
  ExodusWriter(const std::filesystem::path& temporary, const std::filesystem::path& file, const SolverMesh& mesh,
               const ExodusPart* part = nullptr)
      : temporary_(temporary), file_(file), mesh_(mesh), part_(part) {}

  std::vector<SidecarGroup> write() {
    if (!std::ofstream(temporary_)) refuse_to_write(file_);
    collect_sets();
    name_blocks();
    add_dimensions();
    add_ids();
    add_coordinates();
    add_names();
    add_blocks();
    add_sets();
    const std::vector<std::string> fields = add_exodus_fields(out_, mesh_);
    note_names(fields);
    if (part_) add_exodus_part(out_, *part_, {side_sets_.size(), node_sets_.size()});
    has_time_ = !fields.empty();
    add_globals();
    if (!out_.write(temporary_)) refuse_to_write(file_);
    return std::move(sidecar_);
  }

 private:
  struct Set {
    std::int32_t id;
    std::string name;
    std::vector<int> entries, sides;  ///< Exodus node set: rows of nodes; side set: rows of elements, numbers of sides
  };

  std::string add_name(SolverNames& names, const char* type, const CellGroup& group) {
    const std::string name = names.give(group.full_name);
    sidecar_.push_back({type, group.dimension, group.id, name, group.full_name, group.members});
    return name;
  }
  /// Collects node sets and side sets. A side set has each face once, as a side of the element from which the normal
  /// points away.
  void collect_sets() {
    SolverNames side_names(name_limit_exodus), node_names(name_limit_exodus);
    for (const CellGroup& group : mesh_.groups) {
      if (group.dimension == 3) continue;
      if (group.dimension == 2) {
        Set sides{group.id, add_name(side_names, "side set", group), {}, {}};
        for (const std::size_t b : group.blocks) add_sides(b, sides);
        side_sets_.push_back(std::move(sides));
      }
      add_node_set(node_names, group, nodes_of(part_ ? part_->whole : mesh_, group));
    }
    for (const NodeSet& set : mesh_.source->node_sets)
      add_node_set(node_names, {set.id, 0, set.name, {}, {set.id}}, set.nodes);
  }
  /// Adds the faces of a block to a side set. In a mesh of parts, a face belongs to the element that its normal points
  /// away from, and therefore to one file only.
  void add_sides(std::size_t b, Set& sides) const {
    const CellBlock& block = mesh_.blocks[b];
    for (std::size_t c = 0; c < block.sides.size(); ++c) {
      if (part_ && part_->part.owner[b][c] != part_->part.part.number) continue;
      const auto& [minus, plus] = block.sides[c];
      const FaceSide& side = minus.solid != no_cell ? minus : plus;
      if (side.solid == no_cell) continue;
      sides.entries.push_back(static_cast<int>(side.solid + 1));
      sides.sides.push_back(exodus_side_opposite[side.opposite]);
    }
  }
  void add_node_set(SolverNames& names, const CellGroup& group, const std::vector<VertexIndex>& rows) {
    Set nodes{group.id, add_name(names, "node set", group), {}, {}};
    for (const VertexIndex v : part_ ? nodes_in_part(rows, part_->part.part) : rows)
      nodes.entries.push_back(static_cast<int>(v) + 1);
    node_sets_.push_back(std::move(nodes));
  }
  static bool is_solid(const CellBlock& block) { return dimension_of(block.shape) == 3; }
  void name_blocks() {
    SolverNames names(name_limit_exodus);
    for (const CellBlock& block : mesh_.blocks) {
      if (!is_solid(block)) continue;
      blocks_.push_back(&block);
      block_names_.push_back(add_name(names, "element block", {block.id, 3, block.full_name, {}, block.members}));
    }
  }

  /// Adds a dimension to the file unless its length is zero, because netCDF would treat it as the unlimited dimension.
  void add_dimension(const std::string& name, std::size_t n) {
    if (n > 0) out_.add_dimension(name, n);
  }
  void add_dimensions() {
    out_.add_dimension("len_name", exodus_name_room);
    out_.add_dimension("time_step", 0);
    out_.add_dimension("num_dim", 3);
    add_dimension("num_nodes", mesh_.n_nodes());
    add_dimension("num_elem", mesh_.n_solids());
    add_dimension("num_el_blk", blocks_.size());
    add_dimension("num_node_sets", node_sets_.size());
    add_dimension("num_side_sets", side_sets_.size());
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      add_dimension("num_el_in_blk" + std::to_string(b + 1), blocks_[b]->n_cells());
      if (blocks_[b]->n_cells() > 0)
        add_dimension("num_nod_per_el" + std::to_string(b + 1), blocks_[b]->nodes_per_cell);
    }
    for (std::size_t s = 0; s < side_sets_.size(); ++s)
      add_dimension("num_side_ss" + std::to_string(s + 1), side_sets_[s].entries.size());
    for (std::size_t s = 0; s < node_sets_.size(); ++s)
      add_dimension("num_nod_ns" + std::to_string(s + 1), node_sets_[s].entries.size());
  }

  /// Writes the status (1: not empty) and ids (first property) of element blocks, node sets and side sets.
  void add_ids() {
    out_.add_doubles("time_whole", {"time_step"}, [this] { return std::vector<double>(has_time_ ? 1 : 0, 0.0); });
    std::vector<int> status, ids;
    const auto add = [&](const std::string& kind, const std::string& dimension) {
      if (!ids.empty()) {
        out_.add_ints(kind + "_status", dimension, std::exchange(status, {}));
        out_.add_ints(kind + "_prop1", dimension, std::exchange(ids, {}));
        out_.add_attribute("name", "ID");
      }
    };
    for (const CellBlock* block : blocks_) {
      status.push_back(block->n_cells() > 0);
      ids.push_back(block->id);
    }
    add("eb", "num_el_blk");
    for (const auto& [kind, sets] : {std::pair{std::string("ns"), &node_sets_}, {std::string("ss"), &side_sets_}}) {
      for (const Set& set : *sets) {
        status.push_back(!set.entries.empty());
        ids.push_back(set.id);
      }
      add(kind, kind == "ns" ? "num_node_sets" : "num_side_sets");
    }
  }

  void add_coordinates() {
    for (std::size_t k = 0; mesh_.n_nodes() > 0 && k < 3; ++k)
      out_.add_doubles(
          std::string("coord") + "xyz" [k], { "num_nodes" },
          [this, k] {
            std::vector<double> axis;
            axis.reserve(mesh_.n_nodes());
            for (std::size_t v = 0; v < mesh_.n_nodes(); ++v) axis.push_back(mesh_.node(v)[k]);
            return axis;
          });
  }

  void note_names(const std::vector<std::string>& names) {
    for (const std::string& name : names) longest_name_ = std::max(longest_name_, name.size());
  }
  void add_list_of_names(const std::string& kind, const std::string& dimension, std::vector<std::string> names) {
    note_names(names);
    if (names.empty()) return;
    out_.add_texts(kind + "_names", dimension, std::move(names));
    out_.add_attribute("_FillValue", std::string(1, '\0'));
  }
  static std::vector<std::string> names_of(const std::vector<Set>& sets) {
    std::vector<std::string> names;
    for (const Set& set : sets) names.push_back(set.name);
    return names;
  }
  void add_names() {
    add_list_of_names("eb", "num_el_blk", block_names_);
    add_list_of_names("ns", "num_node_sets", names_of(node_sets_));
    add_list_of_names("ss", "num_side_sets", names_of(side_sets_));
    add_list_of_names("coor", "num_dim", {"x", "y", "z"});
  }

  /// Returns the Exodus name of an element type. Linear tetrahedra are TETRA, because one reader does not know TETRA4.
  const char* type_of(const CellBlock& block) const {
    return block.shape == CellShape::prism ? "WEDGE6" : mesh_.second_order() ? "TETRA10" : "TETRA";
  }
  void add_blocks() {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const CellBlock& block = *blocks_[b];
      if (block.n_cells() == 0) continue;
      const std::string number = std::to_string(b + 1);
      out_.add_ints("connect" + number, {"num_el_in_blk" + number, "num_nod_per_el" + number},
                    [&block](const NetcdfWriter::Put& put) { return put_nodes_of_cells(block, put); });
      out_.add_attribute("elem_type", type_of(block));
    }
  }
  /// Writes the nodes of some cells at a time, because a copy of all would be as large as the block.
  static bool put_nodes_of_cells(const CellBlock& block, const NetcdfWriter::Put& put) {
    constexpr std::size_t cells_at_once = 1 << 16;
    std::vector<int> nodes;
    for (std::size_t first = 0; first < block.n_cells(); first += cells_at_once) {
      const std::size_t n = std::min(cells_at_once, block.n_cells() - first);
      nodes.clear();
      for (std::size_t i = first * block.nodes_per_cell; i < (first + n) * block.nodes_per_cell; ++i)
        nodes.push_back(static_cast<int>(block.nodes[i]) + 1);
      if (!put(first, n, nodes.data())) return false;
    }
    return true;
  }
  void add_sets() {
    for (std::size_t s = 0; s < side_sets_.size(); ++s) {
      const std::string number = std::to_string(s + 1);
      if (side_sets_[s].entries.empty()) continue;
      out_.add_ints("elem_ss" + number, "num_side_ss" + number, std::move(side_sets_[s].entries));
      out_.add_ints("side_ss" + number, "num_side_ss" + number, std::move(side_sets_[s].sides));
    }
    for (std::size_t s = 0; s < node_sets_.size(); ++s)
      if (const std::string number = std::to_string(s + 1); !node_sets_[s].entries.empty())
        out_.add_ints("node_ns" + number, "num_nod_ns" + number, std::move(node_sets_[s].entries));
  }
  /// Writes the same global attributes as the Exodus library: its versions, doubles, 64-bit offsets and 32-bit numbers.
  void add_globals() {
    constexpr std::size_t least_name_length = 32, most_letters = 80;
    out_.add_global("api_version", 8.11f);
    out_.add_global("version", 8.11f);
    out_.add_global("floating_point_word_size", 8);
    out_.add_global("file_size", 1);
    out_.add_global("maximum_name_length", static_cast<int>(std::max(longest_name_, least_name_length)));
    out_.add_global("int64_status", 0);
    out_.add_global("title", transliterated(mesh_.source->name).substr(0, most_letters));
  }

  const std::filesystem::path& temporary_;
  const std::filesystem::path& file_;
  const SolverMesh& mesh_;
  const ExodusPart* part_;
  NetcdfWriter out_;
  bool has_time_ = false;
  std::size_t longest_name_ = 0;
  std::vector<const CellBlock*> blocks_;
  std::vector<std::string> block_names_;
  std::vector<Set> side_sets_, node_sets_;
  std::vector<SidecarGroup> sidecar_;
};

/// Returns NAME.e.N.K for part K of N, both with the same number of digits, as SEACAS and libMesh name such files.
std::filesystem::path file_of_part(const std::filesystem::path& whole, std::int32_t number, std::int32_t n) {
  const std::string all = std::to_string(n), own = std::to_string(number);
  return whole.string() + "." + all + "." + std::string(all.size() - own.size(), '0') + own;
}

/// Writes a mesh in parts. The JSON file with names is written together with the first part.
std::vector<std::filesystem::path> write_parts(const SolverMesh& mesh, const MeshParts& parts,
                                               const std::filesystem::path& file) {
  WrittenFiles written;
  std::vector<SidecarGroup> sidecar;
  bool has_first = false;
  for (const std::int32_t p : parts.parts_here()) {
    has_first = has_first || p == 0;
    const SolverPart part = part_of(mesh, parts, p, Ghosts::none);
    const ExodusPart all{mesh, parts, part};
    const std::filesystem::path name = file_of_part(file, p, parts.n_parts());
    write_complete_or_absent(name, [&](const std::filesystem::path& temporary) {
      sidecar = ExodusWriter(temporary, name, part.mesh, &all).write();
    });
    written.add(name);
  }
  if (has_first) written.add(write_sidecar(*mesh.source, sidecar, file));
  return written.keep();
}

std::vector<std::filesystem::path> write(const ModelMesh& model, const WriteOptions& options,
                                         const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, options);
  const std::filesystem::path file = stem.string() + ".e";
  if (options.partitions > 1)
    return write_parts(mesh, MeshParts(model, static_cast<std::int32_t>(options.partitions)), file);
  std::vector<SidecarGroup> sidecar;
  write_complete_or_absent(
      file, [&](const std::filesystem::path& temporary) { sidecar = ExodusWriter(temporary, file, mesh).write(); });
  return {file, write_sidecar(model, sidecar, file)};
}

std::vector<std::filesystem::path> write_given(const ModelMesh& mesh, const MeshParts& parts,
                                               const WriteOptions& options, const std::filesystem::path& stem) {
  return write_parts(make_solver_mesh(mesh, options), parts, stem.string() + ".e");
}

}  // namespace

}  // namespace geomesh::geomodel

GEOMESH_FORMAT_MODULE(geomesh::geomodel::write, geomesh::geomodel::read_exodus_mesh, geomesh::geomodel::write_given)

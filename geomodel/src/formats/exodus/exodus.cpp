// SPDX-License-Identifier: GPL-3.0-or-later
// Exodus II: named element blocks, side sets and node sets, for MOOSE, libMesh, PyLith, Sierra. Written and read by the
// Exodus library of Sandia (version 8, inside VTK as VTK::exodusII): the library of record knows the names' lengths,
// the 64-bit switches and the order of sides, and Debian's separate libexodusii is of 2013.
#include <vtk_exodusII.h>

#include <algorithm>
#include <fstream>

#include "formats/exodus/exodus_fields.hpp"
#include "formats/exodus/exodus_part.hpp"
#include "formats/format_list.hpp"
#include "formats/given_part.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "mesh_readers/mesh_readers.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "solver_mesh/solver_mesh.hpp"
#include "starters/starters.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

/// An Exodus file being written. Every failure of the library is a failure to write the file.
class ExodusWriter {
 public:
  /// `part`: null for a mesh in one file.
  ExodusWriter(const std::filesystem::path& temporary, const std::filesystem::path& file, const SolverMesh& mesh,
               const ExodusPart* part = nullptr)
      : file_(file), mesh_(mesh), part_(part) {
    if (!std::ofstream(temporary)) refuse_to_write(file_);  // before the library prints its own lines about it
    ex_opts(0);
    int word = 8, stored = 8;
    id_ = ex_create(temporary.c_str(), EX_CLOBBER | EX_64BIT_OFFSET, &word, &stored);
    if (id_ < 0) refuse_to_write(file_);
    ex_set_max_name_length(id_, static_cast<int>(name_limit_exodus));
  }
  ~ExodusWriter() {
    if (id_ >= 0) ex_close(id_);
  }
  ExodusWriter(const ExodusWriter&) = delete;
  ExodusWriter& operator=(const ExodusWriter&) = delete;

  std::vector<SidecarGroup> write() {
    collect_sets();
    put_sizes();
    define_blocks();
    put_sets();
    put_coordinates();
    put_blocks();
    require(put_exodus_fields(id_, mesh_));
    if (part_) require(put_exodus_part(id_, *part_, {side_sets_.size(), node_sets_.size()}));
    const int status = ex_close(id_);
    id_ = -1;
    require(status);
    return std::move(sidecar_);
  }

 private:
  struct Set {
    std::int32_t id;
    std::string name;
    std::vector<int> entries, sides;  ///< nodes; or elements with their sides
  };

  void require(int status) const {
    if (status < 0) refuse_to_write(file_);
  }
  std::string add_name(SolverNames& names, const char* type, const CellGroup& group) {
    const std::string name = names.give(group.full_name);
    sidecar_.push_back({type, group.dimension, group.id, name, group.full_name, group.members});
    return name;
  }
  /// A side set has the sides of the elements that the faces' normals point away from, so each face once.
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
  /// In parts a face is with the element that its normal points away from, so in one file alone.
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
  void put_sizes() {
    ex_init_params sizes{};
    const std::string title = transliterated(mesh_.source->name).substr(0, MAX_LINE_LENGTH);
    std::copy(title.begin(), title.end(), sizes.title);
    sizes.num_dim = 3;
    sizes.num_nodes = static_cast<int64_t>(mesh_.n_nodes());
    sizes.num_elem = static_cast<int64_t>(mesh_.n_solids());
    sizes.num_elem_blk =
        std::count_if(mesh_.blocks.begin(), mesh_.blocks.end(), [](const CellBlock& b) { return is_solid(b); });
    sizes.num_side_sets = static_cast<int64_t>(side_sets_.size());
    sizes.num_node_sets = static_cast<int64_t>(node_sets_.size());
    require(ex_put_init_ext(id_, &sizes));
  }
  static bool is_solid(const CellBlock& block) { return dimension_of(block.shape) == 3; }
  void put_coordinates() {
    std::vector<double> axis;
    axis.reserve(mesh_.n_nodes());
    for (std::size_t k = 0; k < 3; ++k) {
      axis.clear();
      for (std::size_t v = 0; v < mesh_.n_nodes(); ++v) axis.push_back(mesh_.node(v)[k]);
      const auto of = [&](std::size_t i) { return i == k ? axis.data() : nullptr; };
      require(ex_put_coord(id_, of(0), of(1), of(2)));
    }
  }
  /// All blocks at once, and before anything large is there: the library moves what is there for each definition.
  void define_blocks() {
    std::vector<ex_block> defined;
    for (const CellBlock& block : mesh_.blocks) {
      if (!is_solid(block)) continue;
      const std::string type = block.shape == CellShape::prism ? "WEDGE6" : mesh_.second_order() ? "TETRA10" : "TETRA4";
      ex_block& own = defined.emplace_back();
      own.id = block.id;
      own.type = EX_ELEM_BLOCK;
      std::copy(type.begin(), type.end(), own.topology);
      own.num_entry = static_cast<int64_t>(block.n_cells());
      own.num_nodes_per_entry = static_cast<int64_t>(block.nodes_per_cell);
    }
    require(ex_put_block_params(id_, defined.size(), defined.data()));
  }
  void put_blocks() {
    SolverNames names(name_limit_exodus);
    std::vector<std::string> given;
    for (const CellBlock& block : mesh_.blocks) {
      if (!is_solid(block)) continue;
      put_nodes_of_cells(block);
      given.push_back(add_name(names, "element block", {block.id, 3, block.full_name, {}, block.members}));
    }
    put_names(EX_ELEM_BLOCK, given);
  }
  /// Some at a time: a copy of all would be as large as the block.
  void put_nodes_of_cells(const CellBlock& block) {
    constexpr std::size_t cells_at_once = 1 << 16;
    std::vector<int> nodes;
    for (std::size_t first = 0; first < block.n_cells(); first += cells_at_once) {
      const std::size_t n = std::min(cells_at_once, block.n_cells() - first);
      nodes.clear();
      for (std::size_t i = first * block.nodes_per_cell; i < (first + n) * block.nodes_per_cell; ++i)
        nodes.push_back(static_cast<int>(block.nodes[i]) + 1);
      require(ex_put_partial_conn(id_, EX_ELEM_BLOCK, block.id, static_cast<int64_t>(first + 1),
                                  static_cast<int64_t>(n), nodes.data(), nullptr, nullptr));
    }
  }
  void put_sets() {
    std::vector<ex_set> all;
    for (const auto& [kind, sets] : {std::pair{EX_SIDE_SET, &side_sets_}, std::pair{EX_NODE_SET, &node_sets_}})
      for (Set& set : *sets)
        all.push_back({set.id, kind, static_cast<int64_t>(set.entries.size()), 0,
                       set.entries.empty() ? nullptr : set.entries.data(),
                       set.sides.empty() ? nullptr : set.sides.data(), nullptr});
    if (!all.empty()) require(ex_put_sets(id_, all.size(), all.data()));
    for (const auto& [kind, sets] : {std::pair{EX_SIDE_SET, &side_sets_}, std::pair{EX_NODE_SET, &node_sets_}}) {
      std::vector<std::string> names;
      for (const Set& set : *sets) names.push_back(set.name);
      put_names(kind, names);
    }
  }
  void put_names(ex_entity_type kind, std::vector<std::string>& names) {
    if (names.empty()) return;
    std::vector<char*> texts;
    for (std::string& name : names) texts.push_back(name.data());
    require(ex_put_names(id_, kind, texts.data()));
  }

  const std::filesystem::path& file_;
  const SolverMesh& mesh_;
  const ExodusPart* part_;
  int id_ = -1;
  std::vector<Set> side_sets_, node_sets_;
  std::vector<SidecarGroup> sidecar_;
};

/// NAME.e.N.K for part K of N, both with the same number of digits, as SEACAS and libMesh name them.
std::filesystem::path file_of_part(const std::filesystem::path& whole, std::int32_t number, std::int32_t n) {
  const std::string all = std::to_string(n), own = std::to_string(number);
  return whole.string() + "." + all + "." + std::string(all.size() - own.size(), '0') + own;
}

/// The names beside them come with the first part.
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

}  // namespace

std::vector<std::filesystem::path> write_exodus_part(const ModelMesh& mesh, const MeshParts& parts,
                                                     const WriteOptions& options, const std::filesystem::path& stem) {
  return write_parts(make_solver_mesh(mesh, options), parts, stem.string() + ".e");
}

Format exodus_format() {
  return {"exodus",
          {".e", ".exo", ".ex2", ".exii"},
          "Exodus II",
          {.second_order = true, .prisms = true, .curves = true, .overlapping = true, .partitions = true},
          write,
          read_exodus_mesh,
          write_pylith_starter};
}

}  // namespace geomesh::geomodel

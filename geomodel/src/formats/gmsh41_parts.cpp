// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gmsh41_parts.hpp"

#include <algorithm>
#include <map>

#include "solver_mesh/pieces.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

/// A Gmsh entity of one part of a mesh, with its dimension and number. Its cells are rows of a block of this part.
struct PartEntity {
  int dimension;
  std::int32_t tag;
  std::size_t block = 0;
  bool is_ghost = false;
  /// For each cell of the Gmsh entity: its block of cells, and its row in the block.
  std::vector<std::pair<std::size_t, std::size_t>> cells;
  std::vector<VertexIndex> owned;  ///< rows, in the mesh part, of the nodes that belong to this Gmsh entity
};

class PartWriter {
 public:
  PartWriter(const SolverMesh& whole, const MeshParts& parts, const SolverPart& part, const GmshGroups& groups)
      : whole_(whole), parts_(parts), part_(part), groups_(groups), own_(part.part.number) {
    first_tag_ = largest_id(*whole.source) + 1;
    for (const CellBlock& block : whole.blocks) first_tag_ = std::max(first_tag_, block.id + 1);
    std::size_t first = 1;
    for (const CellBlock& block : whole.blocks) {
      first_element_.push_back(first);
      first += n_cells(block);
    }
    last_element_ = first - 1;
    sort_cells();
    share_nodes();
  }

  void write(OutputText& out, Encoding encoding) const {
    write_gmsh_head(out, "4.1", encoding, groups_);
    GmshNumbers numbers(out, encoding);
    const auto section = [&](const char* name, auto&& body) {
      out << "$" << name << "\n";
      body(numbers);
      out << (encoding == Encoding::binary ? "\n$End" : "$End") << name << "\n";
    };
    section("Entities", [&](GmshNumbers& n) { write_parents(n); });
    section("PartitionedEntities", [&](GmshNumbers& n) { write_entities(n); });
    section("Nodes", [&](GmshNumbers& n) { write_nodes(n); });
    section("Elements", [&](GmshNumbers& n) { write_elements(n); });
    section("GhostElements", [&](GmshNumbers& n) { write_ghosts(n); });
  }

 private:
  std::size_t n_cells(const CellBlock& block) const {
    return block.shape == CellShape::tetrahedron ? parts_.n_cells_of_region(block.members.front()) : block.n_cells();
  }
  std::int32_t tag_of(std::size_t block, std::int32_t part) const {
    return first_tag_ + static_cast<std::int32_t>(block) * parts_.n_parts() + part;
  }
  std::int32_t ghost_tag() const { return tag_of(whole_.blocks.size(), own_); }

  /// Sorts the cells of the part into entities: points, edges, faces and solids, then ghosts. Only solids of other
  /// parts become ghosts.
  void sort_cells() {
    for (std::size_t b = 0; b < whole_.blocks.size(); ++b) {
      const int dimension = dimension_of(whole_.blocks[b].shape);
      PartEntity entity{dimension, tag_of(b, own_), b, false, {}, {}};
      for (std::size_t c = 0; c < part_.owner[b].size(); ++c)
        if (part_.owner[b][c] == own_)
          entity.cells.emplace_back(b, c);
        else if (dimension == 3)
          ghost_.cells.emplace_back(b, c);
      if (!entity.cells.empty()) entities_.push_back(std::move(entity));
    }
    std::stable_sort(entities_.begin(), entities_.end(),
                     [](const PartEntity& a, const PartEntity& b) { return a.dimension < b.dimension; });
    ghost_.tag = ghost_tag();
    if (!ghost_.cells.empty()) entities_.push_back(ghost_);
  }
  /// Assigns each node of the part to the first Gmsh entity that contains it; nodes in no entity are left out.
  void share_nodes() {
    std::vector<bool> taken(part_.mesh.n_nodes(), false);
    for (PartEntity& entity : entities_) {
      for (const auto& [b, c] : entity.cells) {
        const CellBlock& block = part_.mesh.blocks[b];
        for (std::size_t i = 0; i < block.nodes_per_cell; ++i)
          if (const VertexIndex v = block.nodes[c * block.nodes_per_cell + i]; !taken[v]) {
            taken[v] = true;
            entity.owned.push_back(v);
          }
      }
      std::sort(entity.owned.begin(), entity.owned.end());
    }
  }

  /// Writes the bounding box of a Gmsh entity of the whole mesh. For a region it is that of its faces, which every part
  /// has.
  void write_parent_box(GmshNumbers& numbers, const CellBlock& block) const {
    if (block.shape != CellShape::tetrahedron) return write_box(numbers, block, whole_);
    Box3 box;
    for (const ModelMesh::Face& face : whole_.source->faces)
      if (face.region_minus == block.id || face.region_plus == block.id)
        for (const VertexIndex v : face.vertices) box.add(whole_.source->points[v]);
    numbers.real(box.min);
    numbers.real(box.max);
  }
  void write_box(GmshNumbers& numbers, const CellBlock& block, const SolverMesh& mesh) const {
    Box3 box;
    for (const VertexIndex v : block.nodes) box.add(mesh.node(v));
    numbers.real(box.min);
    if (block.shape != CellShape::vertex) numbers.real(box.max);
  }
  void write_groups(GmshNumbers& numbers, std::size_t block) const {
    numbers.size(groups_.of_block[block].size());
    for (const std::int32_t tag : groups_.of_block[block]) numbers.integer(tag);
  }
  void write_parents(GmshNumbers& numbers) const {
    std::array<std::vector<std::size_t>, 4> of_dimension;
    for (std::size_t b = 0; b < whole_.blocks.size(); ++b)
      of_dimension[static_cast<std::size_t>(dimension_of(whole_.blocks[b].shape))].push_back(b);
    for (const auto& blocks : of_dimension) numbers.size(blocks.size());
    numbers.line();
    for (std::size_t d = 0; d < 4; ++d)
      for (const std::size_t b : of_dimension[d]) {
        numbers.integer(whole_.blocks[b].id);
        write_parent_box(numbers, whole_.blocks[b]);
        write_groups(numbers, b);
        if (d > 0) numbers.size(0);
        numbers.line();
      }
  }
  void write_entities(GmshNumbers& numbers) const {
    numbers.size(static_cast<std::size_t>(parts_.n_parts()));
    numbers.line();
    numbers.size(ghost_.cells.empty() ? 0 : 1);
    numbers.line();
    if (!ghost_.cells.empty()) {
      numbers.integer(ghost_.tag);
      numbers.integer(own_ + 1);
      numbers.line();
    }
    for (int d = 0; d < 4; ++d)
      numbers.size(static_cast<std::size_t>(std::count_if(
          entities_.begin(), entities_.end(), [&](const PartEntity& e) { return !e.is_ghost && e.dimension == d; })));
    numbers.line();
    for (const PartEntity& entity : entities_) {
      if (entity.is_ghost) continue;
      numbers.integer(entity.tag);
      numbers.integer(entity.dimension);
      numbers.integer(whole_.blocks[entity.block].id);
      numbers.size(1);
      numbers.integer(own_ + 1);
      write_box(numbers, part_.mesh.blocks[entity.block], part_.mesh);
      write_groups(numbers, entity.block);
      if (entity.dimension > 0) numbers.size(0);
      numbers.line();
    }
  }
  std::size_t number_of(VertexIndex v) const { return parts_.node_number(part_.part.nodes[v]) + 1; }
  void write_nodes(GmshNumbers& numbers) const {
    std::size_t n_blocks = 0, n = 0;
    for (const PartEntity& entity : entities_) {
      n_blocks += !entity.owned.empty();
      n += entity.owned.size();
    }
    numbers.size(n_blocks);
    numbers.size(n);
    numbers.size(1);
    numbers.size(parts_.n_nodes_of_whole());
    numbers.line();
    for (const PartEntity& entity : entities_) {
      if (entity.owned.empty()) continue;
      numbers.integer(entity.dimension);
      numbers.integer(entity.tag);
      numbers.integer(0);
      numbers.size(entity.owned.size());
      numbers.line();
      for (const VertexIndex v : entity.owned) {
        numbers.size(number_of(v));
        numbers.line();
      }
      for (const VertexIndex v : entity.owned) {
        numbers.real(part_.mesh.node(v));
        numbers.line();
      }
    }
  }
  std::size_t element(std::size_t block, std::size_t cell) const {
    const CellBlock& own = part_.mesh.blocks[block];
    const std::size_t row = part_.cells[block][cell];
    return first_element_[block] +
           (own.shape == CellShape::tetrahedron ? parts_.number_in_region(own.rows[cell], row) : row);
  }
  void write_elements(GmshNumbers& numbers) const {
    std::size_t n = 0;
    for (const PartEntity& entity : entities_) n += entity.cells.size();
    numbers.size(entities_.size());
    numbers.size(n);
    numbers.size(1);
    numbers.size(last_element_);
    numbers.line();
    for (const PartEntity& entity : entities_) {
      numbers.integer(entity.dimension);
      numbers.integer(entity.tag);
      numbers.integer(gmsh_type(part_.mesh, part_.mesh.blocks[entity.cells.front().first].shape));
      numbers.size(entity.cells.size());
      numbers.line();
      for (const auto& [b, c] : entity.cells) {
        const CellBlock& block = part_.mesh.blocks[b];
        numbers.size(element(b, c));
        for (std::size_t i = 0; i < block.nodes_per_cell; ++i)
          numbers.size(number_of(block.nodes[c * block.nodes_per_cell + gmsh_node(block, i)]));
        numbers.line();
      }
    }
  }
  void write_ghosts(GmshNumbers& numbers) const {
    numbers.size(ghost_.cells.size());
    numbers.line();
    for (const auto& [b, c] : ghost_.cells) {
      numbers.size(element(b, c));
      numbers.integer(part_.owner[b][c] + 1);
      numbers.size(1);
      numbers.integer(own_ + 1);
      numbers.line();
    }
  }

  const SolverMesh& whole_;
  const MeshParts& parts_;
  const SolverPart& part_;
  const GmshGroups& groups_;
  std::int32_t own_, first_tag_ = 0;
  std::size_t last_element_ = 0;
  std::vector<std::size_t> first_element_;  // for each block of cells: number, in the whole mesh, of its first cell
  std::vector<PartEntity> entities_;
  PartEntity ghost_{3, 0, 0, true, {}, {}};
};

}  // namespace

namespace {

std::vector<std::filesystem::path> write_parts_here(const SolverMesh& mesh, const MeshParts& parts,
                                                    const WriteOptions& options, const std::filesystem::path& stem,
                                                    const GmshPartBody& body) {
  const GmshGroups groups = gmsh_groups(mesh, options);
  WrittenFiles written;
  bool has_first = false;
  for (const std::int32_t p : parts.parts_here()) {
    has_first = has_first || p == 0;
    const SolverPart part = part_of(mesh, parts, p, Ghosts::one_layer);
    const std::filesystem::path file = stem.string() + "_" + std::to_string(p + 1) + ".msh";
    write_output_text(file, [&](OutputText& out) { body(out, parts, part, groups); });
    written.add(file);
  }
  if (has_first) written.add(write_sidecar(*mesh.source, groups.sidecar, stem.string() + ".msh"));
  return written.keep();
}

}  // namespace

std::vector<std::filesystem::path> write_gmsh_parts(const SolverMesh& mesh, const WriteOptions& options,
                                                    const std::filesystem::path& stem, const GmshPartBody& body) {
  return write_parts_here(mesh, MeshParts(*mesh.source, static_cast<std::int32_t>(options.partitions)), options, stem,
                          body);
}

std::vector<std::filesystem::path> write_gmsh41_parts(const SolverMesh& mesh, const WriteOptions& options,
                                                      const std::filesystem::path& stem, Encoding encoding) {
  return write_gmsh41_parts(mesh, MeshParts(*mesh.source, static_cast<std::int32_t>(options.partitions)), options, stem,
                            encoding);
}

std::vector<std::filesystem::path> write_gmsh41_parts(const SolverMesh& mesh, const MeshParts& parts,
                                                      const WriteOptions& options, const std::filesystem::path& stem,
                                                      Encoding encoding) {
  return write_parts_here(mesh, parts, options, stem,
                          [&](OutputText& out, const MeshParts& all, const SolverPart& part, const GmshGroups& groups) {
                            PartWriter(mesh, all, part, groups).write(out, encoding);
                          });
}

}  // namespace geomesh::geomodel

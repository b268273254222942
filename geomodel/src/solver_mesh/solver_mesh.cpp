// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/solver_mesh.hpp"

#include <algorithm>
#include <map>

#include "solver_mesh/face_sides.hpp"
#include "solver_mesh/pieces.hpp"

namespace geomesh::geomodel {

namespace {

class SolverMeshBuilder {
 public:
  SolverMeshBuilder(const ModelMesh& mesh, const WriteOptions& options, TetrahedronNodes nodes)
      : mesh_(mesh), options_(options), nodes_(nodes) {
    result_.source = &mesh;
  }

  SolverMesh build() {
    add_regions();
    add_layers();
    const SolverPieces pieces = make_pieces(mesh_);
    next_id_ = largest_id(mesh_) + 1;
    for (const FacePiece& piece : pieces.faces) next_id_ = std::max(next_id_, piece.id + 1);
    for (const CurvePiece& piece : pieces.curves) next_id_ = std::max(next_id_, piece.id + 1);
    add_faces(pieces.faces);
    if (options_.curves) {
      add_curves(pieces.curves);
      for (const auto& point : mesh_.marked_points)
        add_block({CellShape::vertex, point.id, point.name, {point.id}, 0, 0, 1, {point.v}, {}, {}});
    }
    group_wholes();
    label_blocks();
    for (const RegionGroup& group : mesh_.groups) {
      CellGroup named{0, 3, group.name, {}, group.regions};
      for (const std::int32_t id : group.regions) named.blocks.push_back(static_cast<std::size_t>(id - 1));
      if (!named.blocks.empty()) result_.region_groups.push_back(std::move(named));
    }
    return std::move(result_);
  }

 private:
  void add_block(CellBlock block) { result_.blocks.push_back(std::move(block)); }
  bool second() const { return !mesh_.midpoints.empty(); }

  void add_regions() {
    for (const Region& region : mesh_.regions)
      add_block({CellShape::tetrahedron, region.id, region.name, {region.id}, 0, 0, second() ? 10u : 4u, {}, {}, {}});
    std::vector<std::size_t> n_cells(mesh_.regions.size(), 0);
    for (const std::int32_t region : mesh_.tet_region) ++n_cells[static_cast<std::size_t>(region - 1)];
    for (std::size_t r = 0; r < n_cells.size(); ++r) {
      if (nodes_ == TetrahedronNodes::listed)
        result_.blocks[r].nodes.reserve(n_cells[r] * result_.blocks[r].nodes_per_cell);
      result_.blocks[r].rows.reserve(n_cells[r]);
    }
    for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
      CellBlock& block = result_.blocks[static_cast<std::size_t>(mesh_.tet_region[t] - 1)];
      block.rows.push_back(static_cast<VertexIndex>(t));
      if (nodes_ == TetrahedronNodes::by_rows) continue;
      block.nodes.insert(block.nodes.end(), mesh_.tetrahedra[t].begin(), mesh_.tetrahedra[t].end());
      if (second())
        block.nodes.insert(block.nodes.end(), mesh_.midpoints.of_tetrahedron[t].begin(),
                           mesh_.midpoints.of_tetrahedron[t].end());
    }
    if (mesh_.faces.empty()) return;
    solid_of_.resize(mesh_.tetrahedra.size());
    std::uint32_t solid = 0;
    for (const CellBlock& block : result_.blocks)
      for (const VertexIndex t : block.rows) solid_of_[t] = solid++;
  }
  void add_layers() {
    for (const CohesiveLayer& layer : mesh_.cohesive_layers) {
      CellBlock block{CellShape::prism, layer.id, layer.name, {layer.id}, 0, 0, 6, {}, {}, {}};
      for (const Prism& prism : mesh_.prisms)
        if (prism.layer == layer.id)
          block.nodes.insert(block.nodes.end(), prism.vertices.begin(), prism.vertices.end());
      add_block(std::move(block));
    }
  }
  void add_faces(const std::vector<FacePiece>& pieces) {
    std::vector<Triangle> faces;
    for (const auto& face : mesh_.faces) faces.push_back(face.vertices);
    const auto sides = tetrahedra_at_faces(mesh_.tetrahedra, faces);
    for (const FacePiece& piece : pieces) {
      if (piece.region_plus != 0 && !options_.inner_faces) continue;
      CellBlock block{CellShape::triangle,
                      piece.id,
                      piece.full_name,
                      mesh_.surface_sets[static_cast<std::size_t>(piece.surface_set)],
                      piece.region_minus,
                      piece.region_plus,
                      second() ? 6u : 3u,
                      {},
                      {},
                      {piece.faces.begin(), piece.faces.end()}};
      for (const std::size_t f : piece.faces) {
        block.nodes.insert(block.nodes.end(), mesh_.faces[f].vertices.begin(), mesh_.faces[f].vertices.end());
        if (second())
          block.nodes.insert(block.nodes.end(), mesh_.midpoints.of_face[f].begin(), mesh_.midpoints.of_face[f].end());
        std::array<FaceSide, 2> at{};
        for (std::size_t k = 0; k < 2; ++k)
          if (sides[f][k].tetrahedron != no_side) at[k] = {solid_of_[sides[f][k].tetrahedron], sides[f][k].opposite};
        block.sides.push_back(at);
      }
      add_block(std::move(block));
    }
  }
  void add_curves(const std::vector<CurvePiece>& pieces) {
    for (const CurvePiece& piece : pieces) {
      CellBlock block{CellShape::edge, piece.id, piece.full_name, piece.curves, 0, 0, second() ? 3u : 2u, {}, {}, {}};
      for (const std::size_t e : piece.edges) {
        block.nodes.push_back(mesh_.curve_edges[e].a);
        block.nodes.push_back(mesh_.curve_edges[e].b);
        if (second()) block.nodes.push_back(mesh_.midpoints.of_curve_edge[e]);
      }
      add_block(std::move(block));
    }
  }

  static CellGroup group_of_block(const CellBlock& block, std::size_t row) {
    return {block.id, dimension_of(block.shape), block.full_name, {row}, block.members};
  }
  /// Makes a group of cell blocks for each surface and each curve. Each block of solids and each named point is a
  /// group.
  void group_wholes() {
    const bool pieces = options_.groups != GroupChoice::whole, wholes = options_.groups != GroupChoice::pieces;
    std::map<std::int32_t, std::vector<std::size_t>> of_member;
    for (std::size_t b = 0; b < result_.blocks.size(); ++b)
      for (const std::int32_t id : result_.blocks[b].members) of_member[id].push_back(b);
    const auto add_whole = [&](std::int32_t id, int dimension, const std::string& name) {
      const auto found = of_member.find(id);
      if (found != of_member.end()) result_.groups.push_back({id, dimension, name, found->second, {id}});
    };
    for (std::size_t b = 0; b < result_.blocks.size(); ++b)
      if (dimension_of(result_.blocks[b].shape) == 3) result_.groups.push_back(group_of_block(result_.blocks[b], b));
    if (wholes) {
      for (const NamedSurface& surface : mesh_.surfaces) add_whole(surface.id, 2, surface.name);
      for (const NamedCurve& curve : mesh_.curves) add_whole(curve.id, 1, curve.name);
    }
    for (std::size_t b = 0; b < result_.blocks.size(); ++b) {
      const CellBlock& block = result_.blocks[b];
      const int dimension = dimension_of(block.shape);
      const bool is_whole = block.members.size() == 1 && of_member[block.members.front()].size() == 1;
      if (dimension == 3 || (dimension > 0 && (!pieces || (wholes && is_whole)))) continue;
      result_.groups.push_back(group_of_block(block, b));
    }
  }

  /// Gives each block of cells exactly one label, the only number of its cells in the file. Blocks on several surfaces
  /// or curves get a label of their own.
  void label_blocks() {
    if (options_.groups == GroupChoice::pieces) {
      result_.labels = result_.groups;
      return;
    }
    std::map<std::pair<int, std::vector<std::int32_t>>, std::size_t> label_of;
    for (std::size_t b = 0; b < result_.blocks.size(); ++b) {
      const CellBlock& block = result_.blocks[b];
      const int dimension = dimension_of(block.shape);
      const auto [entry, is_new] = label_of.try_emplace({dimension, block.members}, result_.labels.size());
      if (is_new) {
        const std::int32_t id = block.members.size() == 1 ? block.members.front() : next_id_++;
        result_.labels.push_back({id, dimension, name_of(block), {}, block.members});
      }
      result_.labels[entry->second].blocks.push_back(b);
    }
  }
  std::string name_of(const CellBlock& block) const {
    if (block.shape != CellShape::triangle && block.shape != CellShape::edge) return block.full_name;
    std::string name;
    const auto add = [&](std::int32_t id, const std::string& member) {
      if (std::find(block.members.begin(), block.members.end(), id) != block.members.end())
        name += (name.empty() ? "" : "+") + member;
    };
    for (const NamedSurface& surface : mesh_.surfaces) add(surface.id, surface.name);
    for (const NamedCurve& curve : mesh_.curves) add(curve.id, curve.name);
    return name;
  }

  const ModelMesh& mesh_;
  const WriteOptions& options_;
  TetrahedronNodes nodes_;
  SolverMesh result_;
  std::vector<std::uint32_t> solid_of_;
  std::int32_t next_id_ = 0;
};

}  // namespace

int dimension_of(CellShape shape) {
  switch (shape) {
    case CellShape::vertex:
      return 0;
    case CellShape::edge:
      return 1;
    case CellShape::triangle:
      return 2;
    case CellShape::tetrahedron:
    case CellShape::prism:
      break;
  }
  return 3;
}

std::size_t SolverMesh::count(int dimension) const {
  std::size_t n = 0;
  for (const CellBlock& block : blocks)
    if (dimension_of(block.shape) == dimension) n += block.n_cells();
  return n;
}

SolverMesh make_solver_mesh(const ModelMesh& mesh, const WriteOptions& options, TetrahedronNodes nodes) {
  return SolverMeshBuilder(mesh, options, nodes).build();
}

std::vector<VertexIndex> nodes_of(const SolverMesh& mesh, const CellGroup& group) {
  std::vector<VertexIndex> nodes;
  for (const std::size_t b : group.blocks)
    nodes.insert(nodes.end(), mesh.blocks[b].nodes.begin(), mesh.blocks[b].nodes.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace geomesh::geomodel

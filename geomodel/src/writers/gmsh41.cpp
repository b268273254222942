// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh MSH 4.1, ASCII: one physical group per entity.
#include <algorithm>

#include "geomesh/geomodel/writers.hpp"
#include "writers/sidecar.hpp"
#include "writers/solver_groups.hpp"
#include "writers/text_buffer.hpp"

namespace geomesh::geomodel {

namespace {

/// One entity with its physical group of the same number, its elements (rows of `n_vertices` point rows) and the points
/// it owns.
struct Entity {
  int dimension;
  std::int32_t tag;
  std::string name;
  std::vector<VertexIndex> connectivity;
  std::vector<std::int32_t> boundary;  ///< volumes: pieces, negative where their normal points inwards
  std::vector<VertexIndex> owned;

  std::size_t n_vertices() const { return static_cast<std::size_t>(dimension) + 1; }
  std::size_t n_elements() const { return connectivity.size() / n_vertices(); }
};

/// Points, curve pieces, face pieces, regions.
std::vector<Entity> make_entities(const ModelMesh& mesh, std::vector<SidecarGroup>& sidecar) {
  const SolverGroups groups = make_groups(mesh);
  SolverNames names;
  std::vector<Entity> entities;
  const auto add = [&](int dimension, std::int32_t tag, const std::string& full_name,
                       std::vector<std::int32_t> members) -> Entity& {
    entities.push_back({dimension, tag, names.give(full_name), {}, {}, {}});
    sidecar.push_back({"physical", dimension, tag, entities.back().name, full_name, std::move(members)});
    return entities.back();
  };
  // Regions first: where two names must differ, the region keeps the plain one.
  for (const Region& r : mesh.regions) {
    Entity& volume = add(3, r.id, r.name, {r.id});
    for (const FacePiece& piece : groups.faces) {
      if (piece.region_minus == piece.region_plus) continue;
      if (piece.region_minus == r.id) volume.boundary.push_back(piece.id);
      if (piece.region_plus == r.id) volume.boundary.push_back(-piece.id);
    }
  }
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    auto& connectivity = entities[static_cast<std::size_t>(mesh.tet_region[t] - 1)].connectivity;
    connectivity.insert(connectivity.end(), mesh.tetrahedra[t].begin(), mesh.tetrahedra[t].end());
  }
  for (const FacePiece& piece : groups.faces) {
    Entity& surface = add(2, piece.id, piece.full_name, mesh.surface_sets[static_cast<std::size_t>(piece.surface_set)]);
    for (std::size_t f : piece.faces)
      surface.connectivity.insert(surface.connectivity.end(), mesh.faces[f].vertices.begin(),
                                  mesh.faces[f].vertices.end());
  }
  for (const CurvePiece& piece : groups.curves) {
    Entity& curve = add(1, piece.id, piece.full_name, piece.curves);
    for (std::size_t e : piece.edges) {
      curve.connectivity.push_back(mesh.curve_edges[e].a);
      curve.connectivity.push_back(mesh.curve_edges[e].b);
    }
  }
  for (const auto& p : mesh.marked_points) add(0, p.id, p.name, {p.id}).connectivity.push_back(p.v);
  std::stable_sort(entities.begin(), entities.end(),
                   [](const Entity& a, const Entity& b) { return a.dimension < b.dimension; });
  return entities;
}

/// A point belongs to the entity of lowest dimension that has it.
void share_out_points(std::size_t n_points, std::vector<Entity>& entities) {
  std::vector<bool> taken(n_points, false);
  for (Entity& entity : entities) {
    for (VertexIndex v : entity.connectivity)
      if (!taken[v]) {
        taken[v] = true;
        entity.owned.push_back(v);
      }
    std::sort(entity.owned.begin(), entity.owned.end());
  }
}

std::size_t count_of(const std::vector<Entity>& entities, int dimension) {
  return static_cast<std::size_t>(
      std::count_if(entities.begin(), entities.end(), [&](const Entity& e) { return e.dimension == dimension; }));
}

void append_entities(TextBuffer& out, const ModelMesh& mesh, const std::vector<Entity>& entities) {
  out << "$Entities\n";
  for (int d = 0; d < 4; ++d) out << count_of(entities, d) << (d < 3 ? " " : "\n");
  for (const Entity& e : entities) {
    Box3 box;
    for (VertexIndex v : e.connectivity) box.add(mesh.points[v]);
    out << e.tag << " " << box.min;
    if (e.dimension > 0) out << " " << box.max;
    out << " 1 " << e.tag;
    if (e.dimension > 0) out << " " << e.boundary.size();
    for (std::int32_t b : e.boundary) out << " " << b;
    out << "\n";
  }
  out << "$EndEntities\n";
}

void append_nodes(TextBuffer& out, const ModelMesh& mesh, const std::vector<Entity>& entities) {
  const std::size_t n = mesh.points.size();
  const auto n_blocks =
      std::count_if(entities.begin(), entities.end(), [](const Entity& e) { return !e.owned.empty(); });
  out << "$Nodes\n" << n_blocks << " " << n << " 1 " << n << "\n";
  for (const Entity& e : entities) {
    if (e.owned.empty()) continue;
    out << e.dimension << " " << e.tag << " 0 " << e.owned.size() << "\n";
    for (VertexIndex v : e.owned) out << v + 1 << "\n";
    for (VertexIndex v : e.owned) out << mesh.points[v] << "\n";
  }
  out << "$EndNodes\n";
}

void append_elements(TextBuffer& out, const std::vector<Entity>& entities) {
  constexpr int gmsh_type[] = {15, 1, 2, 4};  // point, line, triangle, tetrahedron
  std::size_t n = 0, tag = 0;
  for (const Entity& e : entities) n += e.n_elements();
  out << "$Elements\n" << entities.size() << " " << n << " 1 " << n << "\n";
  for (const Entity& e : entities) {
    out << e.dimension << " " << e.tag << " " << gmsh_type[e.dimension] << " " << e.n_elements() << "\n";
    for (std::size_t i = 0; i < e.n_elements(); ++i) {
      out << ++tag;
      for (std::size_t k = 0; k < e.n_vertices(); ++k) out << " " << e.connectivity[i * e.n_vertices() + k] + 1;
      out << "\n";
    }
  }
  out << "$EndElements\n";
}

}  // namespace

void write_gmsh41(const ModelMesh& mesh, const std::filesystem::path& file) {
  std::vector<SidecarGroup> sidecar;
  std::vector<Entity> entities = make_entities(mesh, sidecar);
  share_out_points(mesh.points.size(), entities);
  TextBuffer out;
  out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  out << "$PhysicalNames\n" << entities.size() << "\n";
  for (const Entity& e : entities) out << e.dimension << " " << e.tag << " \"" << e.name << "\"\n";
  out << "$EndPhysicalNames\n";
  append_entities(out, mesh, entities);
  append_nodes(out, mesh, entities);
  append_elements(out, entities);
  write_text_file(file, out.text());
  write_sidecar(mesh, sidecar, file);
}

}  // namespace geomesh::geomodel

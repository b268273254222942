// SPDX-License-Identifier: MIT
// A mesh exchanged for the constrained Delaunay one of its own points, faces and edges.
#include <catch2/catch.hpp>
#include <set>

#include "refine_models.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/operations/operations.hpp"
#include "remesh/start/mesh_anew.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using namespace refine_models;

namespace {

/// Faces and edges by their places, with what they stand for: the same whatever the rows are.
using Place = std::array<double, 3>;
Place place_of(const Vec3& p) { return {p.x, p.y, p.z}; }

std::multiset<Place> places(const ConstrainedTetrahedralization& mesh) {
  std::multiset<Place> out;
  for (const Vec3& p : mesh.points) out.insert(place_of(p));
  return out;
}

std::set<std::pair<std::set<Place>, Index>> faces_of(const ConstrainedTetrahedralization& mesh) {
  std::set<std::pair<std::set<Place>, Index>> out;
  for (const auto& f : mesh.faces) {
    std::set<Place> corners;
    for (const VertexIndex v : f.vertices) corners.insert(place_of(mesh.points[v]));
    out.insert({corners, f.facet});
  }
  return out;
}

std::set<std::pair<std::set<Place>, Index>> edges_of(const ConstrainedTetrahedralization& mesh) {
  std::set<std::pair<std::set<Place>, Index>> out;
  for (const auto& e : mesh.edges) out.insert({{place_of(mesh.points[e.a]), place_of(mesh.points[e.b])}, e.segment});
  return out;
}

/// Unconstrained faces whose two cells are clearly not Delaunay.
std::size_t n_far_from_delaunay(const DomainMesh& mesh) {
  std::size_t n = 0;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
    if (!mesh.is_live(c)) continue;
    const Sphere s = circumsphere(mesh, c);
    for (unsigned i = 0; i < 4; ++i) {
      if (mesh.tag(c, i).constrained()) continue;
      const FaceRef beyond = mesh.cells().neighbor(c, i);
      const Vec3 d = mesh.point(mesh.vertices(beyond.cell())[beyond.face()]) - s.centre;
      n += dot(d, d) < 0.999 * s.radius * s.radius;
    }
  }
  return n;
}

/// The box about the ball, the ball itself left out.
Model shell() {
  Model model = ball_in_box(4);
  auto& mesh = model.mesh;
  std::vector<Index> row(mesh.tetrahedra.size(), no_index);
  std::vector<Tetrahedron> kept;
  for (Index t = 0; t < mesh.tetrahedra.size(); ++t)
    if (mesh.component[t] == 1) row[t] = static_cast<Index>(kept.size()), kept.push_back(mesh.tetrahedra[t]);
  for (auto& f : mesh.faces)
    for (Index* t : {&f.tetrahedron_below, &f.tetrahedron_above})
      if (*t != no_index) *t = row[*t];
  mesh.tetrahedra = kept;
  mesh.component.assign(kept.size(), 0);
  mesh.n_components = 1;
  mesh.component_seed = {no_index};
  return model;
}

}  // namespace

TEST_CASE("A mesh made anew has the same points, faces, edges and components", "[refine]") {
  for (Model& model : std::vector<Model>{two_boxes(3), ball_in_box(4), box_with_well(4)}) {
    disturb_inside(model, 3);
    ConstrainedTetrahedralization fresh = model.mesh;
    REQUIRE(mesh_anew(fresh, {}));
    require_valid(fresh);
    CHECK(places(fresh) == places(model.mesh));
    CHECK(faces_of(fresh) == faces_of(model.mesh));
    CHECK(edges_of(fresh) == edges_of(model.mesh));
    const std::vector<double> before = component_volumes(model.mesh), after = component_volumes(fresh);
    REQUIRE(before.size() == after.size());
    for (std::size_t c = 0; c < before.size(); ++c) CHECK(after[c] == Approx(before[c]).epsilon(1e-12));
    for (VertexIndex v = 0; v < fresh.points.size(); ++v) {
      const VertexIndex row = fresh.input_vertex[v];
      if (row != no_vertex) CHECK(fresh.points[v] == model.plc.points[row]);
    }
    CHECK(import_domain(model.plc, fresh, {}).validate() == "");
  }
}

TEST_CASE("A mesh far from Delaunay is near it when made anew", "[refine]") {
  Model model = two_boxes(3);
  disturb_inside(model, 8);
  const DomainMesh before = import_domain(model.plc, model.mesh, {});
  ConstrainedTetrahedralization fresh = model.mesh;
  REQUIRE(mesh_anew(fresh, {}));
  const DomainMesh after = import_domain(model.plc, fresh, {});
  CAPTURE(n_far_from_delaunay(before), n_far_from_delaunay(after));
  CHECK(n_far_from_delaunay(before) > 50);
  CHECK(n_far_from_delaunay(after) * 20 < n_far_from_delaunay(before));
}

TEST_CASE("A mesh made anew leaves out what was left out", "[refine]") {
  Model model = shell();
  // Points of the ball's inside are in no cell: they are not part of such a mesh.
  const DomainMesh domain = import_domain(ball_in_box(4).plc, ball_in_box(4).mesh, {});
  const double ball = component_volumes(export_domain(domain, ball_in_box(4).mesh))[0];
  std::vector<VertexIndex> row(model.mesh.points.size(), no_vertex);
  ConstrainedTetrahedralization& mesh = model.mesh;
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (const VertexIndex v : t) row[v] = 0;
  ConstrainedTetrahedralization packed = mesh;
  packed.points.clear(), packed.input_vertex.clear(), packed.origin.clear();
  for (VertexIndex v = 0; v < mesh.points.size(); ++v) {
    if (row[v] == no_vertex) continue;
    row[v] = static_cast<VertexIndex>(packed.points.size());
    packed.points.push_back(mesh.points[v]);
    packed.input_vertex.push_back(mesh.input_vertex[v]);
    packed.origin.push_back(mesh.origin[v]);
  }
  for (Tetrahedron& t : packed.tetrahedra)
    for (VertexIndex& v : t) v = row[v];
  for (auto& f : packed.faces)
    for (VertexIndex& v : f.vertices) v = row[v];
  ConstrainedTetrahedralization fresh = packed;
  REQUIRE(mesh_anew(fresh, {}));
  require_valid(fresh);
  REQUIRE(fresh.n_components == 1);
  CHECK(component_volumes(fresh)[0] == Approx(64 - ball).epsilon(1e-9));
}

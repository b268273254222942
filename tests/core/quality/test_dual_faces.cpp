// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of the Voronoi dual: of a lattice they are known, and of any mesh the volumes that they make add up to it.
#include <catch2/catch.hpp>
#include <cmath>

#include "geomesh/core/dual_faces.hpp"
#include "refine_models.hpp"

using namespace geomesh;
using namespace refine_models;

namespace {

double length_of(const std::vector<Vec3>& points, const DualFace& face) {
  const Vec3 d = points[face.b] - points[face.a];
  return std::sqrt(dot(d, d));
}

}  // namespace

TEST_CASE("Dual cells fill the mesh, whatever its elements are", "[quality]") {
  for (Model model : {two_boxes(3), ball_in_box(4)}) {
    disturb_inside(model, 2);
    double whole = 0, due = 0;
    VertexIndex last_a = 0, last_b = 0;
    for_each_dual_face(model.mesh.points, model.mesh.tetrahedra, [&](const DualFace& face) {
      CHECK(face.a < face.b);
      CHECK(std::pair(last_a, last_b) < std::pair(face.a, face.b));
      last_a = face.a, last_b = face.b;
      whole += 2 * face.area * length_of(model.mesh.points, face) / 6;
    });
    for (const double volume : component_volumes(model.mesh)) due += volume;
    CHECK(whole == Approx(due).epsilon(1e-12));
  }
}

TEST_CASE("Of a lattice the dual's faces are squares, and edges across cubes have none", "[quality]") {
  const Model model = two_boxes(4);
  std::size_t n_squares = 0;
  double side = 1e9;
  for (const Tetrahedron& t : model.mesh.tetrahedra)
    for (const auto& e : edge_vertices) {
      const Vec3 d = model.mesh.points[t[e[1]]] - model.mesh.points[t[e[0]]];
      side = std::min(side, std::sqrt(dot(d, d)));
    }
  for_each_dual_face(model.mesh.points, model.mesh.tetrahedra, [&](const DualFace& face) {
    const double l = length_of(model.mesh.points, face);
    if (l > 1.1 * side) CHECK(std::abs(face.area) < 1e-12);
    n_squares += std::abs(face.area - side * side) < 1e-12;
  });
  CHECK(n_squares > 10);
}

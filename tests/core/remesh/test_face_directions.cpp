// SPDX-License-Identifier: MIT
// Where faces look to, those of no width included: a crossing that met the side of a triangle leaves three points on
// one line but for rounding.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "geomesh/core/quality.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "quality/measure/shape.hpp"
#include "refine_models.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/domain/face_directions.hpp"

using namespace geomesh;
using namespace geomesh::remesh;

namespace {

std::vector<EdgeUse> uses_of(const std::vector<Triangle>& faces) {
  std::vector<EdgeUse> uses;
  for (Index f = 0; f < faces.size(); ++f)
    for (unsigned k = 0; k < 3; ++k)
      uses.push_back({{std::min(faces[f][k], faces[f][(k + 1) % 3]), std::max(faces[f][k], faces[f][(k + 1) % 3])}, f});
  std::sort(uses.begin(), uses.end(),
            [](const EdgeUse& a, const EdgeUse& b) { return a.edge != b.edge ? a.edge < b.edge : a.face < b.face; });
  return uses;
}

/// A square of four triangles: two left of its diagonal from 0 to 2, and right of it a narrow one to a point (3) that
/// is off the diagonal by `width`, and two beyond.
struct SquareWithNeedle {
  std::vector<Vec3> points{{0, 0, 0}, {0, 4, 0}, {4, 4, 0}, {2, 2, 0}, {4, 0, 0}};
  std::vector<Triangle> faces{{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {3, 4, 2}};
  explicit SquareWithNeedle(const Vec3& off) { points[3] = points[3] + off; }
  std::vector<Vec3> directions(double narrow, std::vector<Index> patches = {0, 0, 0, 0}) const {
    return face_directions(points, faces, patches, uses_of(faces), narrow);
  }
};

}  // namespace

TEST_CASE("a face of no width looks where the face beyond its longest edge does, whatever its own normal says",
          "[refine]") {
  const Vec3 up{0, 0, 1};
  for (const Vec3& off : {Vec3{}, Vec3{1e-15, 0, 0}, Vec3{-1e-15, 0, 0}, Vec3{0, 0, 1e-15}}) {
    SquareWithNeedle square(off);
    for (const Vec3& d : square.directions(1e-9)) CHECK(distance(d, up) < 1e-12);
    std::swap(square.faces[1][0], square.faces[1][2]);  // given the other way round
    const std::vector<Vec3> turned = square.directions(1e-9);
    CHECK(distance(turned[1], -1.0 * up) < 1e-12);
    CHECK(distance(turned[2], up) < 1e-12);
  }
}

TEST_CASE("A step lower than half of the tolerance makes no crease, a higher one stays", "[refine]") {
  constexpr double wide = 0.01, high = 0.03;  // faces of the step are 0.032 high
  const auto step = [](const Vec3& p) {
    return p.x == 0.5 ? Vec3{0.25 + wide, p.y, p.z == 0.5 ? 0.5 + high : p.z} : p;
  };
  const refine_models::Model model = refine_models::GridModel(
                                         4, {1, 1, 1}, [](const Vec3& p) { return p.z < 0.5 ? 0u : 1u; },
                                         [](const Vec3& p) { return refine_models::side_of_cube(p, 6); }, step)
                                         .model();
  for (const double tolerance : {0.1, 0.04}) {
    RefineOptions options;
    options.honour = Honour::tolerance;
    options.tolerance = tolerance;
    const DomainMesh mesh = import_domain(model.plc, model.mesh, options);
    std::size_t n_free = 0, n_on_step = 0;
    for (VertexIndex v = 0; v < mesh.n_vertices(); ++v) {
      const Vec3& p = mesh.point(v);
      if (p.y == 0 || p.y == 1 || (p != step({0.5, p.y, 0.5}) && p != Vec3{0.25, p.y, 0.5})) continue;
      ++n_on_step;
      n_free += mesh.kind(v) == VertexKind::surface;
    }
    CHECK(n_on_step == 6);
    CHECK(n_free == (tolerance == 0.1 ? n_on_step : 0));
  }
}

TEST_CASE("a face wider than narrow looks where its normal says, and one beside none of its patch nowhere",
          "[refine]") {
  const SquareWithNeedle lifted({0, 0, 0.1});
  const std::vector<Vec3> own = lifted.directions(0.05);
  CHECK(std::abs(dot(own[1], Vec3{0, 0, 1})) < 1e-12);  // upright
  CHECK(distance(lifted.directions(0.2)[1], {0, 0, 1}) < 1e-12);
  CHECK(SquareWithNeedle({}).directions(1e-9, {7, 0, 0, 0})[1] == Vec3{});
}

namespace {

/// A box whose top is cut along its diagonal, where the middle is off the line by an ulp to the side and two up:
/// between them is a facet of no width that is turned by more than 60 degrees.
refine_models::Model box_with_needle() {
  constexpr double ulp = 2 * std::numeric_limits<double>::epsilon();  // of 2
  refine_models::Model m;
  m.plc.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0},
                  {0, 4, 0}, {0, 0, 4}, {4, 0, 4},
                  {4, 4, 4}, {0, 4, 4}, {2 + ulp, 2, 4 + 2 * ulp}};
  Index surface = 0;
  for (const std::vector<VertexIndex>& side :
       std::vector<std::vector<VertexIndex>>{{0, 3, 2, 1}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
    m.plc.add_polygon({&side, 1}, surface++);
  for (const Triangle& t : {Triangle{4, 6, 7}, Triangle{4, 8, 6}, Triangle{4, 5, 8}, Triangle{8, 5, 6}})
    m.plc.add_triangle(t, surface);
  m.mesh = tetrahedralize(m.plc);
  return m;
}

}  // namespace

TEST_CASE("points of faces of no width may move and go where surfaces are remeshed", "[refine]") {
  const refine_models::Model model = box_with_needle();
  RefineOptions options;
  options.honour = Honour::tolerance;
  options.tolerance = 0.01;
  const DomainMesh mesh = import_domain(model.plc, model.mesh, options);
  CHECK(mesh.kind(8) == VertexKind::surface);
  CHECK(mesh.curve_of(4, 6) == no_index);
  options.size.global = 1;
  options.size.from_input_edges = false;
  const RefineResult result = refine_and_improve(model.plc, model.mesh, options);
  CHECK(measure_shapes(result.mesh.points, result.mesh.tetrahedra).min_dihedral.min > 20);
}

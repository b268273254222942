// SPDX-License-Identifier: MIT
// Refinement in conforming mode: the mesh is Delaunay, as a search over all faces finds, has the sizes asked, and keeps
// the model.
#include <catch2/catch.hpp>
#include <cmath>

#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/core/quality.hpp"
#include "geomesh/core/refine_conforming.hpp"
#include "geomesh/core/voronoi_dual.hpp"
#include "refine_models.hpp"

using namespace geomesh;
using namespace refine_models;

namespace {

TetrahedralizeOptions conforming() {
  TetrahedralizeOptions options;
  options.recover.mode = MeshMode::conforming;
  return options;
}

RefineOptions with_size(double global) {
  RefineOptions options;
  options.size.global = global;
  return options;
}

/// Faces across which the vertex opposite lies strictly inside the circumsphere. Exact.
std::size_t faces_not_delaunay(const ConstrainedTetrahedralization& mesh) {
  std::map<Triangle, std::pair<Index, VertexIndex>> open;
  std::size_t n = 0;
  const auto& p = mesh.points;
  for (Index c = 0; c < mesh.tetrahedra.size(); ++c)
    for (unsigned i = 0; i < 4; ++i) {
      const Tetrahedron& t = mesh.tetrahedra[c];
      const auto& f = face_vertices[i];
      const auto [it, is_first] = open.try_emplace(sorted({t[f[0]], t[f[1]], t[f[2]]}), c, t[i]);
      if (is_first) continue;
      const Tetrahedron& o = mesh.tetrahedra[it->second.first];
      n += in_sphere(p[o[0]], p[o[1]], p[o[2]], p[o[3]], p[t[i]]) == Sign::positive;
    }
  return n;
}

struct Run {
  ConstrainedTetrahedralization start;
  RefineResult refined;
};

Run run(const PiecewiseLinearComplex& plc, const RefineOptions& options) {
  Run r;
  r.start = tetrahedralize(plc, conforming());
  r.refined = refine_conforming(plc, r.start, conforming(), options);
  return r;
}

void require_right(const PiecewiseLinearComplex& plc, const Run& r) {
  const ConstrainedTetrahedralization& mesh = r.refined.mesh;
  require_valid(mesh);
  CHECK(mesh.delaunay);
  CHECK(mesh.recovery.facets_not_recovered.empty());
  CHECK(faces_not_delaunay(mesh) == 0);
  const auto before = component_volumes(r.start), after = component_volumes(mesh);
  REQUIRE(before.size() == after.size());
  for (std::size_t c = 0; c < before.size(); ++c) CHECK(after[c] == Approx(before[c]).epsilon(1e-9));
  const auto areas = facet_areas(plc, r.start), now = facet_areas(plc, mesh);
  for (std::size_t f = 0; f < areas.size(); ++f) CHECK(now[f] == Approx(areas[f]).epsilon(1e-9));
  const VoronoiDual dual = measure_voronoi_dual(mesh.points, mesh.tetrahedra);
  CHECK(dual.negative == dual.negative_on_border);
}

/// The unit cube in polygons, with a pane across it at height 1/2 whose border is part of the sides' polygons.
PiecewiseLinearComplex cube_with_pane() {
  PiecewiseLinearComplex plc;
  for (const double z : {0.0, 0.5, 1.0})
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
      plc.points.push_back({x, y, z});
  const auto add = [&](const std::vector<VertexIndex>& loop, Index surface) {
    const std::vector<std::vector<VertexIndex>> loops{loop};
    plc.add_polygon(loops, surface);
  };
  for (VertexIndex level = 0; level < 3; ++level) add({4 * level, 4 * level + 1, 4 * level + 2, 4 * level + 3}, level);
  for (VertexIndex level = 0; level < 2; ++level)
    for (VertexIndex k = 0; k < 4; ++k) {
      const VertexIndex a = 4 * level + k, b = 4 * level + (k + 1) % 4;
      add({a, b, b + 4, a + 4}, 3 + k);
    }
  return plc;
}

/// A wedge of the given angle (degrees) between two of its faces along the y axis.
PiecewiseLinearComplex wedge(double degrees) {
  const double a = degrees * std::acos(-1.0) / 180;
  PiecewiseLinearComplex plc;
  for (const double y : {0.0, 1.0})
    for (const Vec3& p : {Vec3{0, y, 0}, Vec3{2, y, 0}, Vec3{2 * std::cos(a), y, 2 * std::sin(a)}})
      plc.points.push_back(p);
  for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{3, 5, 4}, Triangle{0, 3, 4}, Triangle{0, 4, 1},
                            Triangle{0, 2, 5}, Triangle{0, 5, 3}, Triangle{1, 4, 5}, Triangle{1, 5, 2}})
    plc.add_triangle(t, 0);
  return plc;
}

}  // namespace

TEST_CASE("Conforming refinement of polygons to one size is Delaunay", "[refine][conforming]") {
  const PiecewiseLinearComplex plc = cube_with_pane();
  std::size_t coarser = 0;
  for (const double size : {0.3, 0.15, 0.08}) {
    const Run r = run(plc, with_size(size));
    require_right(plc, r);
    CHECK(r.refined.mesh.tetrahedra.size() > 3 * coarser);
    QualityOptions measuring;
    measuring.size = &r.refined.size_field;
    CHECK(measure_quality(plc, r.refined.mesh, measuring).whole.share_within_size() > 0.95);
    coarser = r.refined.mesh.tetrahedra.size();
    const double ratio = static_cast<double>(coarser) / r.refined.statistics.estimated_elements;
    CHECK(ratio > 0.3);
    CHECK(ratio < 3);
  }
}

TEST_CASE("Conforming refinement keeps triangles, regions and wells", "[refine][conforming]") {
  for (const Model& model : {two_boxes(2), ball_in_box(2), box_with_well(4)}) {
    const Run r = run(model.plc, with_size(0.12 * (model.plc.points.size() > 80 ? 2 : 1)));
    require_right(model.plc, r);
    CHECK(r.refined.mesh.n_components == r.start.n_components);
    CHECK(r.refined.mesh.edges.size() >= r.start.edges.size());
    double length = 0;
    for (const auto& e : r.refined.mesh.edges) {
      const Vec3 d = r.refined.mesh.points[e.b] - r.refined.mesh.points[e.a];
      length += std::sqrt(dot(d, d));
    }
    if (!model.plc.segments.empty()) CHECK(length == Approx(0.5));
  }
}

TEST_CASE("Conforming refinement takes sizes by component", "[refine][conforming]") {
  const PiecewiseLinearComplex plc = cube_with_pane();
  RefineOptions options = with_size(0.4);
  const ConstrainedTetrahedralization start = tetrahedralize(plc, conforming());
  options.size.component_size = {0, 0};
  options.size.component_size[start.component[0]] = 0.1;
  const RefineResult r = refine_conforming(plc, start, conforming(), options);
  std::array<std::size_t, 2> n{};
  for (const Index c : r.mesh.component) ++n[c];
  CHECK(n[start.component[0]] > 4 * n[1 - start.component[0]]);
}

TEST_CASE("Conforming refinement ends at small angles", "[refine][conforming]") {
  for (const double degrees : {20.0, 5.0, 1.0}) {
    const PiecewiseLinearComplex plc = wedge(degrees);
    const Run r = run(plc, with_size(0.1));
    require_valid(r.refined.mesh);
    CHECK(r.refined.mesh.delaunay == (faces_not_delaunay(r.refined.mesh) == 0));
    CHECK(component_volumes(r.refined.mesh)[0] == Approx(2 * std::sin(degrees * std::acos(-1.0) / 180)));
    CHECK(r.refined.mesh.tetrahedra.size() > 100);
    CHECK(r.refined.mesh.tetrahedra.size() < 100000);
  }
}

TEST_CASE("Conforming refinement is the same from run to run", "[refine][conforming]") {
  const PiecewiseLinearComplex plc = cube_with_pane();
  const Run a = run(plc, with_size(0.15)), b = run(plc, with_size(0.15));
  CHECK(a.refined.mesh.points == b.refined.mesh.points);
  CHECK(a.refined.mesh.tetrahedra == b.refined.mesh.tetrahedra);
}

TEST_CASE("Conforming refinement refuses what it cannot do", "[refine][conforming]") {
  const PiecewiseLinearComplex plc = cube_with_pane();
  const ConstrainedTetrahedralization start = tetrahedralize(plc, conforming());
  const auto kind_of = [&](const RefineOptions& options) {
    try {
      refine_conforming(plc, start, conforming(), options);
    } catch (const Error& e) {
      return static_cast<int>(e.kind());
    }
    return -1;
  };
  RefineOptions options = with_size(0.01);
  options.max_elements = 10000;
  CHECK(kind_of(options) == static_cast<int>(ErrorKind::cannot_mesh));
  options = with_size(0.3);
  options.honour = Honour::tolerance;
  options.tolerance = 0.1;
  CHECK(kind_of(options) == static_cast<int>(ErrorKind::usage));
}

TEST_CASE("The Voronoi dual of a regular pair is positive, of a flipped one is not", "[refine][conforming]") {
  // Two tetrahedra over one face: with the apexes near the face it is not Delaunay, and its edges' dual areas turn.
  std::vector<Vec3> points{{1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}, {0, 0, 1}, {0, 0, -1}};
  const std::vector<Tetrahedron> two{{0, 1, 2, 3}, {0, 2, 1, 4}};
  VoronoiDual dual = measure_voronoi_dual(points, two);
  CHECK(dual.edges == 9);
  CHECK(dual.negative == 0);
  points[3].z = 0.3;
  points[4].z = -0.3;
  dual = measure_voronoi_dual(points, two);
  CHECK(dual.negative >= 3);
  CHECK(dual.least < 0);
}

// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <algorithm>
#include <cmath>

#include "models.hpp"
#include "random_models.hpp"
#include "recovered_mesh_checks.hpp"

using namespace geomesh;

namespace {

double surface_area(const PiecewiseLinearComplex& plc) {
  double area = 0;
  for (Index f = 0; f < plc.n_facets(); ++f) {
    const auto loop = plc.outer_loop(f);
    Vec3 n;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      n = n + cross(plc.points[loop[i]] - plc.points[loop[0]], plc.points[loop[i + 1]] - plc.points[loop[0]]);
    area += 0.5 * std::sqrt(dot(n, n));
  }
  return area;
}

/// Two ulps of the largest coordinate times the area, plus what rounding the model's own vertices may do.
double volume_tolerance(const corpus::Model& model) {
  double largest = 0;
  for (const Vec3& p : model.plc.points)
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::fabs(p[i]));
  return 4 * std::ldexp(largest, -52) * surface_area(model.plc) + 1e-12 * model.volume;
}

void check(const corpus::Model& model, const TetrahedralizeOptions& options) {
  INFO(model.name);
  ConstrainedTetrahedralization mesh;
  const std::string faults = test::mesh_and_check(model.plc, options, &mesh);
  CHECK(faults == "");
  if (!faults.empty()) return;
  if (model.volume > 0) CHECK(std::fabs(static_cast<double>(test::volume_of(mesh)) - model.volume) <= volume_tolerance(model));
  if (model.n_components > 0) CHECK(mesh.n_components == model.n_components);
  CHECK(mesh.edges.size() >= model.plc.segments.size());
  CHECK(mesh.isolated_points.size() == model.plc.isolated_points.size());
}

}  // namespace

TEST_CASE("every model of the corpus is meshed as generated", "[recover][corpus]") {
  for (const corpus::Model& model : corpus::all_models()) check(model, {});
}

TEST_CASE("every model of the corpus is meshed turned, moved and flattened", "[recover][corpus]") {
  for (const corpus::Placement& placement : corpus::placements())
    for (const corpus::Model& model : corpus::all_models()) check(corpus::placed(model, placement), {});
}

TEST_CASE("every model of the corpus is meshed in conforming mode", "[recover][corpus]") {
  TetrahedralizeOptions options;
  options.recover.mode = MeshMode::conforming;
  options.recover.max_steiner_per_facet = 100;
  for (const corpus::Model& model : corpus::all_models()) check(model, options);
}

TEST_CASE("conforming mode leaves nothing out where angles are right", "[recover][corpus]") {
  TetrahedralizeOptions options;
  options.recover.mode = MeshMode::conforming;
  for (const corpus::Model& model : {corpus::lattice(3), corpus::placed(corpus::lattice(3), corpus::placements()[2])}) {
    INFO(model.name);
    const auto mesh = tetrahedralize(model.plc, options);
    CHECK(mesh.recovery.facets_not_recovered.empty());
    CHECK(mesh.delaunay);
  }
}

TEST_CASE("larger slit boxes are meshed", "[recover][corpus][nightly]") {
  for (const unsigned n : {8u, 16u, 32u}) check(corpus::chazelle(n), {});
}

TEST_CASE("random models are meshed", "[recover][fuzz]") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    INFO("seed " << seed);
    CHECK(test::mesh_and_check(fuzz::random_plc(seed)) == "");
  }
}

TEST_CASE("many random models are meshed in both modes", "[recover][fuzz][nightly]") {
  for (std::uint64_t seed = 1001; seed <= 11000; ++seed) {
    INFO("seed " << seed);
    TetrahedralizeOptions options;
    if (seed % 5 == 0) options.recover.mode = MeshMode::conforming;
    CHECK(test::mesh_and_check(fuzz::random_plc(seed), options) == "");
  }
}

TEST_CASE("the mesh does not depend on exact changes of the frame", "[recover][metamorphic]") {
  for (const corpus::Model& model : {corpus::schonhardt(30, true), corpus::fan_of_segments(30), corpus::pinching_layers(12)}) {
    INFO(model.name);
    const auto reference = tetrahedralize(model.plc);
    const auto same_counts = [&](const char* name, auto place) {
      INFO(name);
      corpus::Model moved = model;
      for (Vec3& p : moved.plc.points) p = place(p);
      ConstrainedTetrahedralization mesh;
      CHECK(test::mesh_and_check(moved.plc, {}, &mesh) == "");
      CHECK(mesh.n_components == reference.n_components);
    };
    same_counts("scaled", [](const Vec3& p) { return 1024.0 * p; });
    same_counts("mirrored", [](const Vec3& p) { return Vec3{-p.x, p.y, p.z}; });
    same_counts("axes permuted", [](const Vec3& p) { return Vec3{p.y, p.z, p.x}; });
  }
}

TEST_CASE("what is missing at first is the same in every exact frame", "[recover][metamorphic]") {
  // Warped, so that no five points are cospherical.
  for (std::uint64_t seed = 301; seed < 321; ++seed) {
    INFO("seed " << seed);
    const PiecewiseLinearComplex model = fuzz::random_plc(seed);
    PiecewiseLinearComplex scaled = model, permuted = model;
    for (Vec3& p : scaled.points) p = 4096.0 * p;
    for (Vec3& p : permuted.points) p = {p.z, p.x, p.y};
    const auto reference = tetrahedralize(model), a = tetrahedralize(scaled), b = tetrahedralize(permuted);
    CHECK(a.recovery.missing_edges_initial == reference.recovery.missing_edges_initial);
    CHECK(a.recovery.tetrahedra_unconstrained == reference.recovery.tetrahedra_unconstrained);
    CHECK(a.n_components == reference.n_components);
    CHECK(b.n_components == reference.n_components);
  }
}

TEST_CASE("the mesh does not depend on the order of the facets' vertices", "[recover][metamorphic]") {
  const corpus::Model model = corpus::pinching_layers(10);
  PiecewiseLinearComplex permuted;
  const std::size_t n = model.plc.points.size();
  std::vector<VertexIndex> row(n);
  for (std::size_t i = 0; i < n; ++i) row[i] = static_cast<VertexIndex>((i * 7919) % n);
  permuted.points.resize(n);
  for (std::size_t i = 0; i < n; ++i) permuted.points[row[i]] = model.plc.points[i];
  for (Index f = 0; f < model.plc.n_facets(); ++f) {
    const auto loop = model.plc.outer_loop(f);
    permuted.add_triangle({row[loop[0]], row[loop[1]], row[loop[2]]});
  }
  ConstrainedTetrahedralization a, b;
  CHECK(test::mesh_and_check(model.plc, {}, &a) == "");
  CHECK(test::mesh_and_check(permuted, {}, &b) == "");
  CHECK(a.n_components == b.n_components);
  CHECK(a.recovery.missing_edges_initial == b.recovery.missing_edges_initial);
  CHECK(a.recovery.tetrahedra_unconstrained == b.recovery.tetrahedra_unconstrained);
}

TEST_CASE("the same input gives the same mesh", "[recover]") {
  const corpus::Model model = corpus::placed(corpus::pinching_layers(12), corpus::placements()[2]);
  const auto a = tetrahedralize(model.plc), b = tetrahedralize(model.plc);
  CHECK(a.points == b.points);
  CHECK(a.tetrahedra == b.tetrahedra);
  CHECK(a.component == b.component);
}

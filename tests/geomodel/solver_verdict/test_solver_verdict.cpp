// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geomesh/geomodel/refinement.hpp"
#include "geomesh/geomodel/solver_verdict.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

const std::vector<Tetrahedron> one{{0, 1, 2, 3}};

SolverVerdict verdict_of(const std::vector<Vec3>& points, double velocity = 0) {
  MeshForSolver mesh{points, one, {}, {}};
  if (velocity > 0) mesh.velocity = [=](std::size_t) { return velocity; };
  return judge_for_solvers(mesh);
}

std::vector<Vec3> with_height(double height, double shift = 0) {
  return {{shift, 0, 0}, {shift + 1, 0, 0}, {shift, 1, 0}, {shift + 0.3, 0.3, height}};
}

}  // namespace

TEST_CASE("A good tetrahedron is fit for solvers, and its time step is its least height over the velocity",
          "[solver_verdict]") {
  const SolverVerdict v = verdict_of(with_height(1));
  CHECK(v.passes());
  CHECK(v.least_volume > 0.01);
  CHECK_FALSE(v.has_velocities);
  const SolverVerdict with_velocity = verdict_of(with_height(1), 2000);
  CHECK(with_velocity.has_velocities);
  CHECK(with_velocity.time_step == Approx(v.time_step / 2000));
  CHECK(to_lines(v).front().find("elements are fit for solvers") == 0);
}

TEST_CASE("A tetrahedron that 16 digits flatten is not fit, whatever its exact volume", "[solver_verdict]") {
  // 17 digits tell x of the last point from 4/3; with 16 the four points may be in one plane or inverted.
  const SolverVerdict flat = verdict_of(with_height(1e-18));
  CHECK_FALSE(flat.passes());
  CHECK(flat.n_implicit == 1);
  CHECK(to_lines(flat).front().find("elements are not fit for solvers") == 0);
  const SolverVerdict far = verdict_of({{1e6, 0, 0}, {1e6 + 1, 0, 0}, {1e6, 1, 0}, {1e6 + 0.3, 0.3, 1e-17}});
  CHECK_FALSE(far.passes());
  const SolverVerdict inverted = verdict_of(with_height(-1));
  CHECK(inverted.n_not_positive == 1);
  CHECK(inverted.least_volume < 0);
}

TEST_CASE("Limits count elements by the kind of solver", "[solver_verdict]") {
  const SolverVerdict slow = verdict_of(with_height(0.02));
  CHECK(slow.passes());
  CHECK(slow.n_iterative == 1);
  CHECK(slow.n_flux == 1);
  CHECK(slow.n_implicit == 0);
  const nlohmann::json json = nlohmann::json::parse(to_json(slow));
  CHECK(json["passes"] == true);
  CHECK(json["fail_iterative"] == 1);
  CHECK_FALSE(json.contains("least_edge_over_size"));
}

TEST_CASE("A size is derived from the bounds, with two digits", "[refinement]") {
  const Box3 box{{0, 0, -5000}, {10000, 8000, 0}};
  CHECK(derived_size(box) == 360);
  CHECK(derived_size({{0, 0, 0}, {10, 10, 10}}) == Approx(0.48));
  CHECK(derived_size(box, 1e4) == 770);
  RefinementSettings settings;
  settings.derive_size = true;
  settings.tolerance = ToleranceLedger::of_sizes(default_tolerance_share);
  settle_sizes(settings, box, {}, {});
  CHECK(settings.size.base.global == 360);
  CHECK(settings.tolerance.left() == 18);
}

TEST_CASE("A frequency asks for a share of the wavelength of the slower wave", "[refinement]") {
  NamedSizes sizes;
  sizes.frequency = 5;
  sizes.points_per_wavelength = 4;
  CHECK(wavelength_size(sizes, {{"vp", 3000}}) == 150);
  CHECK(wavelength_size(sizes, {{"vp", 3000}, {"vs", 1500}}) == 75);
  CHECK(wavelength_size(sizes, {{"vp", 1500}, {"vs", 0}}) == 75);
  CHECK(wavelength_size(sizes, {{"density", 2000}}) == 0);
  RefinementSettings settings;
  settings.size = sizes;
  settings.derive_size = true;
  settle_sizes(settings, {{0, 0, 0}, {1, 1, 1}}, {{"a", {{"vp", 3000}}}, {"b", {{"vp", 6000}}}}, {});
  CHECK(settings.size.base.global == 300);
  CHECK_THROWS(settle_sizes(settings, {{0, 0, 0}, {1, 1, 1}}, {}, {}));
}

TEST_CASE("Sizes by depth are linear between their rows, and counted from zero whatever the origin", "[refinement]") {
  RefinementSettings settings;
  settings.size.by_depth = {{0, 50}, {1000, 150}};
  settle_sizes(settings, {{0, 0, 0}, {1, 1, 1}}, {}, {0, 0, 100});
  const auto& size = settings.size.base.background;
  CHECK(size({0, 0, -100}) == 50);
  CHECK(size({0, 0, 500}) == 50);
  CHECK(size({0, 0, -600}) == Approx(100));
  CHECK(size({0, 0, -5000}) == 150);
}

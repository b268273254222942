// SPDX-License-Identifier: MIT
// Refinement and improvement: whatever is asked, the result is a valid mesh of the same domain with the same
// constraints.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "common/geometry.hpp"
#include "geomesh/core/element_estimate.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/core/quality.hpp"
#include "geomesh/core/refine.hpp"
#include "refine_models.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/sizes/sizes.hpp"
#include "search/closest_point.hpp"
#include "search/proven_distance.hpp"

using namespace geomesh;
using namespace refine_models;

namespace {

void require_same_domain(const Model& model, const RefineResult& r) {
  require_valid(r.mesh);
  const std::vector<double> before = component_volumes(model.mesh), after = component_volumes(r.mesh);
  REQUIRE(before.size() == after.size());
  for (std::size_t c = 0; c < before.size(); ++c) CHECK(after[c] == Approx(before[c]).epsilon(1e-9));
  const std::vector<double> areas = facet_areas(model.plc, model.mesh), now = facet_areas(model.plc, r.mesh);
  for (std::size_t f = 0; f < areas.size(); ++f) CHECK(now[f] == Approx(areas[f]).epsilon(1e-9));
}

}  // namespace

TEST_CASE("Refinement of two regions keeps domain, facets and input points", "[refine]") {
  const Model model = two_boxes(2);
  for (const QualityLevel quality : {QualityLevel::fast, QualityLevel::standard}) {
    RefineOptions options;
    options.size.global = 0.1;
    options.quality = quality;
    const RefineResult r = refine_and_improve(model.plc, model.mesh, options);
    require_same_domain(model, r);
    CHECK(r.mesh.tetrahedra.size() > 4 * model.mesh.tetrahedra.size());
    for (std::size_t v = 0; v < model.plc.points.size(); ++v) {
      REQUIRE(r.mesh.input_vertex[v] == v);
      CHECK(r.mesh.points[v] == model.plc.points[v]);
    }
    CHECK(r.statistics.deviation_result_to_input < 1e-14);
    QualityOptions measuring;
    measuring.size = &r.size_field;
    CHECK(measure_quality(model.plc, r.mesh, measuring).whole.share_within_size() > 0.9);
    CHECK(r.statistics.worst_shape_after >= std::min(r.statistics.worst_shape_before, 0.5));
  }
}

TEST_CASE("Where surfaces are not sized only the inside gets points for sizes", "[refine]") {
  const Model model = two_boxes(4);
  RefineOptions options;
  options.size.global = 0.05;
  const std::size_t on_surfaces = refine_and_improve(model.plc, model.mesh, options).mesh.faces.size();
  options.size_surfaces = false;
  const RefineResult r = refine_and_improve(model.plc, model.mesh, options);
  require_same_domain(model, r);
  CHECK(r.statistics.points_on_curves + r.statistics.points_on_surfaces == 0);
  CHECK(r.statistics.points_inside > 100);
  CHECK(r.mesh.faces.size() < model.mesh.faces.size() + model.mesh.faces.size() / 5);  // a few for the worst elements
  CHECK(on_surfaces > 3 * r.mesh.faces.size());
  CHECK(r.statistics.deviation_result_to_input < 1e-14);
  options.size.global = 0;  // by the longest edges about each vertex, growing inwards
  const RefineResult coarse = refine_and_improve(model.plc, model.mesh, options);
  require_same_domain(model, coarse);
  CHECK(coarse.mesh.tetrahedra.size() < r.mesh.tetrahedra.size() / 2);
}

namespace {

/// The unit cube, and through it a segment in n pieces.
PiecewiseLinearComplex cube_with_short_pieces(VertexIndex n) {
  PiecewiseLinearComplex plc;
  for (unsigned v = 0; v < 8; ++v) plc.points.push_back({double(v & 1), double((v >> 1) & 1), double(v >> 2)});
  for (const std::array<VertexIndex, 4>& q :
       {std::array<VertexIndex, 4>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    plc.add_triangle({q[0], q[1], q[2]}, 0);
    plc.add_triangle({q[0], q[2], q[3]}, 0);
  }
  for (VertexIndex k = 0; k <= n; ++k) {
    plc.points.push_back({0.5, 0.5, 0.1 + 0.8 * k / n});
    if (k > 0) plc.segments.push_back({7 + k, 8 + k, no_index});
  }
  return plc;
}

}  // namespace

TEST_CASE("Sizes of input edges grow fast up to the size asked of the whole model", "[refine]") {
  const PiecewiseLinearComplex plc = cube_with_short_pieces(20);
  const ConstrainedTetrahedralization mesh = tetrahedralize(plc);
  const Vec3 vertex{0.5, 0.5, 0.5}, beside{0.6, 0.5, 0.5};
  const auto sizes = [&](double global, double gradation) {
    RefineOptions options;
    options.size.global = global;
    options.size.gradation = gradation;
    const SizeField field = refine_and_improve(plc, mesh, options).size_field;
    CHECK(field.at(vertex) == Approx(0.04));
    return field.at(beside);
  };
  CHECK(sizes(0, 0.3) == Approx(0.07));
  CHECK(sizes(0.5, 0.3) == Approx(0.09));
  CHECK(sizes(0.5, 1) == Approx(0.14));
}

TEST_CASE("Improvement alone adds no size and never lowers the worst shape", "[refine]") {
  Model model = two_boxes(3);
  disturb_inside(model, 7);
  RefineOptions options;
  options.refine = false;
  const RefineResult r = refine_and_improve(model.plc, model.mesh, options);
  require_same_domain(model, r);
  CHECK(r.statistics.worst_shape_after > r.statistics.worst_shape_before);
}

TEST_CASE("A listed segment inside a region stays, whole and in place", "[refine]") {
  const Model model = box_with_well(4);
  RefineOptions options;
  options.size.segment_size = {{0.05, 0}};
  const RefineResult r = refine_and_improve(model.plc, model.mesh, options);
  require_same_domain(model, r);
  double length = 0;
  for (const auto& e : r.mesh.edges) {
    CHECK(e.segment == 0);
    const Vec3 d = r.mesh.points[e.b] - r.mesh.points[e.a];
    CHECK(d.x == 0.0);
    CHECK(d.y == 0.0);
    length += std::abs(d.z);
  }
  CHECK(length == Approx(0.5));
  CHECK(r.mesh.edges.size() >= 8);
}

namespace {

std::vector<search::Corners> faces_as_corners(const ConstrainedTetrahedralization& mesh) {
  std::vector<search::Corners> faces;
  for (const auto& f : mesh.faces)
    faces.push_back({mesh.points[f.vertices[0]], mesh.points[f.vertices[1]], mesh.points[f.vertices[2]]});
  return faces;
}

/// Over a lattice of 91 points of each triangle: a good deal more than refinement looks at.
double largest_distance(const std::vector<search::Corners>& from, const std::vector<search::Corners>& to) {
  constexpr int n = 12;
  std::vector<search::ClosestPointTrees::Item> items;
  for (const search::Corners& t : to) items.push_back({t, 0, 0});
  const search::ClosestPointTrees tree(std::move(items), 1);
  double largest = 0;
  for (const search::Corners& t : from)
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
        largest = std::max(largest, tree.closest((1 - u - v) * t[0] + u * t[1] + v * t[2], 0).distance);
      }
  return largest;
}

}  // namespace

TEST_CASE("Surfaces remeshed within a tolerance stay within it, both ways", "[refine]") {
  const Model model = ball_in_box(6);
  RefineOptions options;
  options.honour = Honour::tolerance;
  options.tolerance = 0.02;
  options.size.from_input_edges = false;
  options.size.global = 0.5;
  options.size.gap_layers = 0;
  const RefineResult r = refine_and_improve(model.plc, model.mesh, options);
  require_valid(r.mesh);
  CHECK(r.statistics.deviation_result_to_input <= options.tolerance);
  CHECK(r.statistics.deviation_input_to_result <= options.tolerance);
  CHECK(r.statistics.collapses > 0);
  const std::vector<search::Corners> input = faces_as_corners(model.mesh), result = faces_as_corners(r.mesh);
  CHECK(largest_distance(result, input) <= options.tolerance);
  CHECK(largest_distance(input, result) <= options.tolerance);
  const std::vector<double> before = component_volumes(model.mesh), after = component_volumes(r.mesh);
  double area = 0;
  for (const double a : facet_areas(model.plc, model.mesh)) area += a;
  for (std::size_t c = 0; c < before.size(); ++c) CHECK(std::abs(after[c] - before[c]) <= options.tolerance * area);
}

TEST_CASE("The result does not depend on the number of threads and is repeatable", "[refine]") {
  const Model model = ball_in_box(4);
  RefineOptions options;
  options.size.global = 0.25;
  RunContext one, two;
  one.threads = 1;
  two.threads = 2;
  const RefineResult a = refine_and_improve(model.plc, model.mesh, options, one);
  const RefineResult b = refine_and_improve(model.plc, model.mesh, options, two);
  CHECK(a.mesh.points == b.mesh.points);
  CHECK(a.mesh.tetrahedra == b.mesh.tetrahedra);
}

TEST_CASE("Too many elements are refused before the work starts", "[refine]") {
  const Model model = two_boxes(2);
  RefineOptions options;
  options.size.global = 0.001;
  options.max_elements = 10000;
  try {
    refine_and_improve(model.plc, model.mesh, options);
    FAIL("not refused");
  } catch (const Error& e) {
    CHECK(e.kind() == ErrorKind::cannot_mesh);
    CHECK(std::string(e.what()).find("limit of 10,000") != std::string::npos);
  }
  options.size.gradation = 0;
  CHECK_THROWS_AS(refine_and_improve(model.plc, model.mesh, options), Error);
}

TEST_CASE("The estimate is within a factor of 1.3 of what comes out, for fine sizes and for coarse ones", "[refine]") {
  const Model model = two_boxes(1);
  RefineOptions options;
  options.size.global = GENERATE(0.24, 0.12, 0.06);
  const double estimate = estimate_elements(model.plc, model.mesh, options);
  const RefineResult r = refine_and_improve(model.plc, model.mesh, options);
  CHECK(estimate == Approx(r.statistics.estimated_elements));
  CHECK(static_cast<double>(r.mesh.tetrahedra.size()) < 1.3 * estimate);
  CHECK(static_cast<double>(r.mesh.tetrahedra.size()) > estimate / 1.3);
}

TEST_CASE("The estimate does not depend on the cells that sizes are looked at in", "[refine]") {
  RefineOptions options;
  options.honour = Honour::tolerance;  // cells that are given ask for nothing
  options.tolerance = 1e-3;
  SizeField::Limits limits;
  limits.global = 0.2;
  const SizeField size({{{0.31, 0.47, 0.13}, 1e-4, 0, 0.5}, {{1, 0.6, 0.2}, 1e-3, 0, 0.3}}, limits);
  const auto estimate = [&](unsigned n) {
    const Model model = two_boxes(n);
    return remesh::estimate_elements(remesh::import_domain(model.plc, model.mesh, options), size, options);
  };
  const double coarse = estimate(1), fine = estimate(6);
  CHECK(fine > 5000);
  CHECK(coarse == Approx(fine).epsilon(0.03));
}

TEST_CASE("Sizes found from one that is known are those found from nothing", "[refine]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto place = [&] { return Vec3{unit(random), unit(random), unit(random)}; };
  std::vector<SizeSource> sources;
  for (int k = 0; k < 400; ++k)
    sources.push_back({place(), 0.01 + 0.1 * unit(random), 0.02 * unit(random), 0.3 + 0.4 * unit(random)});
  SizeField::Limits limits;
  limits.global = 0.2;
  limits.min_size = 0.02;
  limits.component_size = GENERATE(std::vector<double>{}, std::vector<double>{0, 0.03});
  const SizeField size(sources, limits);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p = place(), q = p + 0.1 * place();
    const Index component = k % 2;
    const double all = size.at(p, component), at_most = 0.1 * unit(random), known = size.at(q, component);
    CHECK(size.at_beside(p, component, q, known) == all);
    const double found = size.at_beside(p, component, q, known, at_most);
    CHECK((found < at_most ? found == all : all >= at_most));
    const double enough = 0.1 * unit(random), above = size.at_unless_below(enough, p, component);
    CHECK((above > enough ? above == all : all <= above));
  }
}

TEST_CASE("The estimate is right however many elements that are", "[refine]") {
  // Counting ended soon after the limit before: its number was told as that of the elements.
  RefineOptions options;
  options.honour = Honour::tolerance;  // cells that are given ask for nothing
  const Model model = two_boxes(1);
  const remesh::DomainMesh mesh = remesh::import_domain(model.plc, model.mesh, options);
  double volume = 0;
  for (const CellIndex c : mesh.live_cells()) {
    const auto p = mesh.places(mesh.vertices(c));
    volume += std::abs(dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0]))) / 6;
  }
  SizeField::Limits limits;
  limits.global = 1e-7;
  CHECK(remesh::estimate_elements(mesh, SizeField({}, limits), options) == Approx(10 * volume * 1e21).epsilon(1e-3));
  // Sizes that hold within a hundredth of a line through the boxes, and grow from there.
  constexpr double radius = 1e-2, least = 1e-6, growth = 0.5;
  std::vector<SizeSource> sources;
  for (int k = 0; k <= 1000; ++k) sources.push_back({{0.001 * k, 0.5, 0.5}, least, radius, growth});
  const double within = pi * radius * radius, beside = 2 * pi * radius / (2 * growth);
  const double expected = 10 * (within / (least * least * least) + beside / (least * least));
  const double estimate = remesh::estimate_elements(mesh, SizeField(sources, {}), options);
  CHECK(estimate > 0.7 * expected);
  CHECK(estimate < 1.3 * expected);
}

TEST_CASE("The estimate by cause adds up to the estimate, and names who asks", "[refine]") {
  const Model model = two_boxes(1);
  RefineOptions options;
  options.size.global = 0.2;
  options.size.gap_layers = 0;
  const RefineOptions even_options = options;
  const ElementEstimate even = ElementEstimator(model.plc, model.mesh, options).by_cause(options);
  CHECK(even.total() == Approx(estimate_elements(model.plc, model.mesh, options)));
  options.size.from_input_edges = false;
  options.size.sources = {{{0.3, 0.3, 0.3}, 0.02, 0.1, 0}, {{0.7, 0.7, 0.7}, 0.02, 0.1, 0}};
  const ElementEstimate all = ElementEstimator(model.plc, model.mesh, options).by_cause(options, 1);
  CHECK(all.total() == Approx(estimate_elements(model.plc, model.mesh, options)));
  CHECK(all.by_volume == Approx(even.by_volume));
  const ElementEstimator estimator(model.plc, model.mesh, even_options);
  CHECK(estimator.total(options) == Approx(all.total()));
  CHECK(estimator.is_above(0.9 * all.total(), options));
  CHECK_FALSE(estimator.is_above(1.1 * all.total(), options));
  CHECK(all.by_sizes > 1000);
  CHECK(all.by_thin_units == Approx(all.by_sizes).epsilon(0.1));
  CHECK(all.by_gaps == Approx(0).margin(1e-6));
}

TEST_CASE("A cancelled refinement ends with interrupted", "[refine]") {
  const Model model = two_boxes(2);
  std::atomic<bool> cancel{true};
  RunContext context;
  context.cancel = &cancel;
  try {
    refine_and_improve(model.plc, model.mesh, {}, context);
    FAIL("not interrupted");
  } catch (const Error& e) {
    CHECK(e.kind() == ErrorKind::interrupted);
  }
}

TEST_CASE("More than twice as many elements as were estimated are told before they are improved", "[refine]") {
  const Model model = two_boxes(20);  // its points on surfaces make 60,000 cells
  RefineOptions options;
  options.honour = Honour::tolerance;  // the estimate counts no given cells
  options.tolerance = 1e-6;
  options.size.from_input_edges = false;
  options.quality = QualityLevel::fast;
  options.fixed_points.emplace(model.plc.points.size());
  std::iota(options.fixed_points->begin(), options.fixed_points->end(), 0);
  const auto warnings = [&](double size) {
    options.size.global = size;
    std::vector<std::string> told;
    RunContext context;
    context.log = [&](LogLevel level, std::string_view text) {
      if (level == LogLevel::warning) told.emplace_back(text);
    };
    const RefineResult r = refine_and_improve(model.plc, model.mesh, options, context);
    CHECK(r.warnings == told);
    return told;
  };
  CHECK(warnings(0.05).empty());
  const std::vector<std::string> told = warnings(1);
  REQUIRE(told.size() == 1);
  CHECK(told[0].find("were estimated; improvement takes as much longer") != std::string::npos);
}

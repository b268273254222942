// SPDX-License-Identifier: MIT
// A tolerance that follows the sizes: what is allowed where, and that the result keeps it there.
#include <algorithm>
#include <catch2/catch.hpp>

#include "geomesh/core/short_edges.hpp"
#include "refine_models.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/driver/hold_surfaces.hpp"
#include "remesh/sizes/sizes.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using namespace refine_models;

namespace {

RefineOptions following(double size) {
  RefineOptions o;
  o.honour = Honour::tolerance;
  o.tolerance_share = 1.0 / 40;
  o.tolerance = size / 40;
  o.size.from_input_edges = false;
  o.size.global = size;
  o.size.gap_layers = 0;
  return o;
}

/// The unit cube in three regions along x, the one in the middle a quarter or `thickness` wide, from x = 1/4 on.
Model box_with_layer(double thickness = 0.25) {
  const auto squeeze = [=](const Vec3& p) {
    const double end = 0.25 + thickness;
    const double x = p.x <= 0.25  ? p.x
                     : p.x <= 0.5 ? 0.25 + thickness * (p.x - 0.25) / 0.25
                                  : end + (1 - end) * (p.x - 0.5) / 0.5;
    return Vec3{x, p.y, p.z};
  };
  return GridModel(
             4, {1, 1, 1}, [](const Vec3& p) { return p.x < 0.25  ? 0u
                                                      : p.x < 0.5 ? 1u
                                                                  : 2u; },
             [](const Vec3& p) { return side_of_cube(p, p.x < 0.3 ? 6 : 7); }, squeeze)
      .model();
}

/// The unit cube, sheared, in four regions about two planes that cross at 45 degrees, with edges of both `beside` the
/// curve where they do.
Model crossing_planes(double beside) {
  const auto squeezed = [=](double x) {
    return x <= 0.25   ? x / 0.25 * (0.5 - beside)
           : x <= 0.75 ? 0.5 + (x - 0.5) / 0.25 * beside
                       : 0.5 + beside + (x - 0.75) / 0.25 * (0.5 - beside);
  };
  return GridModel(
             4, {1, 1, 1}, [](const Vec3& p) { return (p.x < 0.5 ? 0u : 1u) + (p.z < 0.5 ? 0u : 2u); },
             [](const Vec3& p) { return side_of_cube(p, 6 + (p.z == 0.5)); },
             [=](const Vec3& p) {
               return Vec3{squeezed(p.x) + squeezed(p.z), p.y, squeezed(p.z)};
             })
      .model();
}

double allowed_at(const LocalTolerance& tolerance, const Vec3& p) { return tolerance.least_at({&p, 1}); }

}  // namespace

TEST_CASE("A tolerance is a share of the size that is asked at the place", "[remesh][tolerance]") {
  const Model model = box_with_layer();
  RefineOptions options = following(0.4);
  options.size.sources = {{{0, 0, 0}, 0.04, 0.1, 0}};
  const LocalTolerance tolerance = allowed_tolerance(model.plc, import_domain(model.plc, model.mesh, options), options);
  CHECK(tolerance.greatest() == Approx(0.01));
  CHECK(allowed_at(tolerance, {0, 0, 0}) == Approx(0.001));
  CHECK(allowed_at(tolerance, {0.2, 0, 0}) == Approx(0.001 + 0.1 * 0.3 / 40));
  CHECK(tolerance.most_on({Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) <= tolerance.greatest());
}

TEST_CASE("A tolerance is at most half of the gap to the surface that is faced", "[remesh][tolerance]") {
  const double gap = 0.004;
  const Model model = box_with_layer(gap);
  const RefineOptions options = following(0.4);
  const LocalTolerance tolerance = allowed_tolerance(model.plc, import_domain(model.plc, model.mesh, options), options);
  CHECK(allowed_at(tolerance, {0.25, 0.5, 0.5}) <= 0.5 * gap * (1 + 1e-9));
  CHECK(allowed_at(tolerance, {0.25, 0.5, 0.5}) >= 0.4 * gap);
}

TEST_CASE("Needles beside the curve where surfaces meet are no gap", "[remesh][tolerance]") {
  const Model model = crossing_planes(1e-4);
  const RefineOptions options = following(0.4);
  const LocalTolerance tolerance = allowed_tolerance(model.plc, import_domain(model.plc, model.mesh, options), options);
  for (const double off : {0.0, 5e-5, 1e-4, 1e-3}) {
    CAPTURE(off);
    CHECK(allowed_at(tolerance, {1 + off, 0.5, 0.5}) == 0.01);
    CHECK(allowed_at(tolerance, {1 + off, 0.5, 0.5 + off}) == 0.01);
  }
}

TEST_CASE("Surfaces that meet farther away than the tolerance have a gap between them", "[remesh][tolerance]") {
  const Model model = crossing_planes(0.015);
  const RefineOptions options = following(0.4);
  const LocalTolerance tolerance = allowed_tolerance(model.plc, import_domain(model.plc, model.mesh, options), options);
  CHECK(allowed_at(tolerance, {1, 0.5, 0.5}) < 0.009);
}

TEST_CASE("Without a share the tolerance is the same everywhere", "[remesh][tolerance]") {
  const Model model = box_with_layer(0.004);
  RefineOptions options = following(0.4);
  options.tolerance_share = 0;
  const LocalTolerance tolerance = allowed_tolerance(model.plc, import_domain(model.plc, model.mesh, options), options);
  CHECK(allowed_at(tolerance, {0.25, 0.5, 0.5}) == 0.01);
}

TEST_CASE("Facets about a place that does not hold become patches of their own", "[remesh][tolerance]") {
  const Model model = box_with_layer();
  RefineOptions options = following(0.4);
  options.facet_patch = named_patches(model.plc, options);
  Attempt attempt;
  attempt.breaches.push_back({.place = {0.5, 0.5, 1}, .distance = 1});
  const std::vector<Index> before = options.facet_patch;
  const std::vector<KeptPlace> kept = keep_there(model.plc, attempt, options);
  for (const KeptPlace& k : kept) {
    CHECK(options.facet_patch[k.facet] != before[k.facet]);
    CHECK(std::count(options.facet_patch.begin(), options.facet_patch.end(), options.facet_patch[k.facet]) == 1);
  }
  CHECK(keep_there(model.plc, attempt, options).size() <= kept.size());
}

TEST_CASE("A model refined within a tolerance that follows the sizes has no short edge that nothing forces",
          "[remesh][tolerance][quality]") {
  const Model model = ball_in_box(6);
  const RefineOptions options = following(0.5);
  const RefineResult r = refine_and_improve(model.plc, model.mesh, options);
  require_valid(r.mesh);
  CHECK(r.statistics.deviation_result_to_input <= options.tolerance);
  CHECK(r.kept.empty());
  CHECK_FALSE(r.all_kept);
  QualityOptions judging;
  judging.size = &r.size_field;
  judging.asked = &r.asked;
  judging.tolerance = options.tolerance;
  judging.tolerance_share = options.tolerance_share;
  judging.facet_patch = r.kept_patch;
  const ShortEdges edges = find_short_edges(model.plc, r.mesh, judging);
  CHECK(edges.n == edges.n_forced);
}

namespace {

/// The unit cube in cubes of a quarter.
Model plain_box(const GridModel::Map& map) {
  return GridModel(
             4, {1, 1, 1}, [](const Vec3&) { return 0u; }, [](const Vec3& p) { return side_of_cube(p, 6); }, map)
      .model();
}

/// Surfaces are what was drawn, sizes are asked everywhere alike.
ShortEdges short_edges_of(const Model& model, double size, double gradation = 0.3, double tolerance = 1e-3) {
  const SizeField field({}, {size, 0, 10, gradation, {}, {}});
  QualityOptions judging;
  judging.size = &field;
  judging.facet_patch = model.plc.facet_provenance;
  judging.tolerance = tolerance;
  return find_short_edges(model.plc, model.mesh, judging, 1.0 / 3, 10000);
}

std::ptrdiff_t count_of(const ShortEdges& edges, EdgeCause cause) {
  return std::count_if(edges.worst.begin(), edges.worst.end(), [=](const ShortEdge& e) { return e.cause == cause; });
}

Vec3 as_it_is(const Vec3& p) { return p; }
Vec3 bent(const Vec3& p) { return {p.x, p.y + p.x * p.x, p.z}; }

}  // namespace

TEST_CASE("An edge is short by the size that is asked, and nothing forces those of a plain box", "[quality]") {
  const ShortEdges edges = short_edges_of(plain_box(as_it_is), 2);
  CHECK(edges.n > 100);  // edges of a quarter where two are asked
  CHECK(edges.n_forced == 0);
  CHECK(edges.worst.size() == edges.n);
  CHECK(edges.worst.front().cause == EdgeCause::free);
  CHECK(edges.worst.front().size == 2);
  CHECK(short_edges_of(plain_box(as_it_is), 0.3).n == 0);
}

TEST_CASE("Where sizes jump, an edge is held against the least of those that its cells are asked for", "[quality]") {
  const Model model = two_boxes(4);  // edges of a quarter, and their diagonals
  for (const double fine : {0.3, 2.0}) {
    SizeField::Limits limits;
    limits.component_size = {2, fine};
    const SizeField field({}, limits);
    QualityOptions judging;
    judging.size = &field;
    judging.facet_patch = model.plc.facet_provenance;
    const ShortEdges edges = find_short_edges(model.plc, model.mesh, judging, 1.0 / 3, 10000);
    std::size_t n_of_coarse = 0, n_of_both = 0;
    for (const ShortEdge& e : edges.worst) {
      bool coarse = false, other = false;
      for (Index c = 0; c < model.mesh.tetrahedra.size(); ++c) {
        const Tetrahedron& t = model.mesh.tetrahedra[c];
        if (std::find(t.begin(), t.end(), e.a) == t.end() || std::find(t.begin(), t.end(), e.b) == t.end()) continue;
        (model.mesh.component[c] == 0 ? coarse : other) = true;
      }
      n_of_coarse += coarse && !other;
      n_of_both += coarse && other;
      CHECK(e.size == 2);
    }
    CHECK(n_of_coarse > 50);
    CHECK((n_of_both > 0) == (fine == 2));
  }
}

TEST_CASE("Sizes grow from edges that a layer forces: edges that follow them are forced too", "[quality]") {
  const Model model = box_with_layer(0.02);
  const ShortEdges slow = short_edges_of(model, 2, 0.3), steep = short_edges_of(model, 2, 10);
  CHECK(count_of(slow, EdgeCause::near_forced) > 100);
  CHECK(slow.n_forced == slow.n);
  CHECK(count_of(steep, EdgeCause::free) > 100);
  CHECK(steep.n == slow.n);
}

TEST_CASE("Bends that the tolerance needs force edges of a curve, others do not", "[quality]") {
  const Model model = plain_box(bent);  // curves are off the chord of their neighbours by a sixteenth at most
  const ShortEdges needed = short_edges_of(model, 2, 0.3, 0.01), straight = short_edges_of(model, 2, 0.3, 0.1);
  CHECK(count_of(needed, EdgeCause::bends) == 4 * 4);
  CHECK(count_of(straight, EdgeCause::bends) == 0);
}

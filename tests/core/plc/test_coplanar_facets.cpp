// SPDX-License-Identifier: GPL-3.0-or-later
// Coplanar triangles as polygons: what is merged, what is kept, and where a point lies among them.
#include <catch2/catch.hpp>
#include <numeric>

#include "corpus_builder.hpp"
#include "plc/coplanar_facets.hpp"
#include "plc/flat_patch.hpp"
#include "plc/patch_crossings.hpp"
#include "recovery_families.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

MergedFacets merged(const PiecewiseLinearComplex& plc, double most_crossings = 0) {
  return merge_coplanar_facets(plc, plc.facet_provenance, most_crossings);
}

/// A strip of squares in z = 0, in long triangles from its ends: crosses its Delaunay triangulation.
PiecewiseLinearComplex fans_in_plane() {
  PlcBuilder b;
  for (int i = 0; i < 8; ++i) {
    b.triangle({0, 0, 0}, {double(i + 1), 1, 0}, {double(i), 1, 0});
    b.triangle({8, 1, 0}, {double(i), 0, 0}, {double(i + 1), 0, 0});
  }
  return std::move(b.plc);
}

}  // namespace

TEST_CASE("coplanar facets: a patch far from Delaunay becomes one polygon, oriented as its first triangle",
          "[plc][coplanar]") {
  const PiecewiseLinearComplex plc = fans_in_plane();
  const MergedFacets out = merged(plc);
  REQUIRE(out.has_merged());
  CHECK(out.plc.n_facets() == 1);
  CHECK(out.members_of(0).size() == plc.n_facets());
  CHECK(out.plc.outer_loop(0).size() == 18);
  Vec3 normal;
  const auto loop = out.plc.outer_loop(0);
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    normal = normal + cross(plc.points[loop[i]] - plc.points[loop[0]], plc.points[loop[i + 1]] - plc.points[loop[0]]);
  CHECK(normal.z == 16);
}

TEST_CASE("coplanar facets: what lies at an edge keeps it, and another surface is not merged", "[plc][coplanar]") {
  PiecewiseLinearComplex plc = fans_in_plane();
  plc.segments.push_back({plc.outer_loop(0)[0], plc.outer_loop(0)[1]});
  const MergedFacets with_curve = merged(plc);
  REQUIRE(with_curve.has_merged());
  CHECK(with_curve.plc.facet_segments.size() + with_curve.plc.n_facets() > 1);
  plc.segments.clear();
  std::iota(plc.facet_provenance.begin(), plc.facet_provenance.end(), Index{0});
  CHECK(!merged(plc).has_merged());
}

TEST_CASE("coplanar facets: a triangulation near to Delaunay is kept", "[plc][coplanar]") {
  CHECK(!merged(fans_in_plane(), 100).has_merged());
  CHECK(!merged(flat_sheets(2, 4, 0.1).plc, 1).has_merged());
}

TEST_CASE("patch crossings: on average over all patches, which few vertices bound", "[plc][coplanar]") {
  // A rhombus with its long diagonal, and one with its short one.
  std::vector<Vec3> points;
  for (const double x : {0.0, 10.0})
    for (const Vec3& p : {Vec3{x - 2, 0, 0}, Vec3{x, -1, 0}, Vec3{x + 2, 0, 0}, Vec3{x, 1, 0}}) points.push_back(p);
  const std::vector<InnerEdge> edges{{0, 2, 1, 3}, {5, 7, 4, 6}};
  const std::vector<Index> first{0, 1, 2};
  CHECK(are_far_from_delaunay(points, edges, first, 0));
  CHECK(!are_far_from_delaunay(points, edges, first, 0.5));
  CHECK(are_far_from_delaunay(points, {edges.data(), 1}, {first.data(), 2}, 0.5));
  CHECK(!are_far_from_delaunay(points, {edges.data() + 1, 1}, {first.data(), 2}, 0));
  CHECK(!are_far_from_delaunay(points, {}, {first.data(), 1}, 0));
  CHECK(most_crossed(3) == 0);
  CHECK(most_crossed(4) == 1);
  CHECK(most_crossed(6) == 4);
}

TEST_CASE("coplanar facets: the walls of a plate are merged with a cap that is far from Delaunay", "[plc][coplanar]") {
  PlateOptions options;
  options.n = 40;
  const MergedFacets out = merged(plate_of_needles(options).plc, 2);
  CHECK(out.plc.n_facets() == 2 + options.n);
}

TEST_CASE("coplanar facets: a polygon with a hole has two loops", "[plc][coplanar]") {
  PlateOptions options;
  options.n = 40;
  options.has_hole = true;
  const FamilyModel model = plate_of_needles(options);
  const MergedFacets out = merged(model.plc);
  bool has_hole = false;
  for (Index m = 0; m < out.plc.n_facets(); ++m) has_hole = has_hole || out.plc.n_loops(m) == 2;
  CHECK(has_hole);
}

TEST_CASE("flat patch: each triangle is found from its centroid", "[plc][coplanar]") {
  const PiecewiseLinearComplex plc = fans_in_plane();
  std::vector<Triangle> triangles;
  for (Index f = 0; f < plc.n_facets(); ++f)
    triangles.push_back({plc.outer_loop(f)[0], plc.outer_loop(f)[1], plc.outer_loop(f)[2]});
  const auto patch = FlatPatch::of(plc.points, triangles);
  REQUIRE(patch);
  for (Index t = 0; t < triangles.size(); ++t) {
    const std::array<Vec3, 3> corners{plc.points[triangles[t][0]], plc.points[triangles[t][1]],
                                      plc.points[triangles[t][2]]};
    CHECK(patch->triangle_at_centroid(corners, triangles[t]) == t);
    const std::array<VertexIndex, 1> far{static_cast<VertexIndex>((triangles[t][0] + 5) % plc.points.size())};
    CHECK(patch->triangle_at_centroid(corners, {}) == t);
    CHECK(patch->triangle_at_centroid(corners, far) == t);
  }
}

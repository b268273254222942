// SPDX-License-Identifier: GPL-3.0-or-later
// Coplanar triangles as polygons: what is merged, what is kept, and where a point lies among them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <numeric>
#include <random>

#include "corpus_builder.hpp"
#include "delaunay/constrained_triangulation.hpp"
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

/// A square of points, none of them where a grid would have it but those of its border.
struct JitteredSquare {
  static constexpr unsigned n = 8;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::mt19937 random{7};

  JitteredSquare() {
    const auto jitter = [this](unsigned i) { return i == 0 || i == n - 1 ? 0.0 : random() % 1000 / 3000.0; };
    for (unsigned j = 0; j < n; ++j)
      for (unsigned i = 0; i < n; ++i) points.push_back({i + jitter(i), j + jitter(j), 0});
  }
  std::vector<InnerEdge> inner_edges() const {
    std::map<std::pair<VertexIndex, VertexIndex>, std::vector<VertexIndex>> apexes;
    for (const Triangle& t : triangles)
      for (unsigned k = 0; k < 3; ++k) apexes[std::minmax(t[k], t[(k + 1) % 3])].push_back(t[(k + 2) % 3]);
    std::vector<InnerEdge> out;
    for (const auto& [edge, v] : apexes)
      if (v.size() == 2) out.push_back({edge.first, edge.second, v[0], v[1]});
    return out;
  }
  /// Whether the edge's quadrilateral is convex, so that the flip was made.
  bool flip(const InnerEdge& e) {
    const auto turn = [this](VertexIndex a, VertexIndex b, VertexIndex c) {
      return orient2d({points[a].x, points[a].y}, {points[b].x, points[b].y}, {points[c].x, points[c].y});
    };
    const Sign of_a = turn(e.apex, e.other_apex, e.a), of_b = turn(e.apex, e.other_apex, e.b);
    if (of_a == Sign::zero || of_b != -of_a) return false;
    std::erase_if(triangles, [&](const Triangle& t) {
      return std::count(t.begin(), t.end(), e.a) + std::count(t.begin(), t.end(), e.b) == 2;
    });
    triangles.push_back({e.apex, e.other_apex, e.a});
    triangles.push_back({e.apex, e.other_apex, e.b});
    return true;
  }
};

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

TEST_CASE("patch crossings: as many as a Delaunay triangulation of the patch shows, after any number of flips",
          "[plc][coplanar]") {
  JitteredSquare square;
  ConstrainedTriangulation delaunay(square.points, {});
  REQUIRE(delaunay.triangulate());
  square.triangles = delaunay.triangles_left_of({{0, 1}}, {});
  REQUIRE(square.triangles.size() == 2 * (JitteredSquare::n - 1) * (JitteredSquare::n - 1));
  for (unsigned n_flips = 0; n_flips < 40; ++n_flips) {
    const std::vector<InnerEdge> edges = square.inner_edges();
    std::size_t n = 0;
    for (const InnerEdge& e : edges) n += delaunay.n_crossed(e.a, e.b, 1000);
    CHECK((n_flips == 0) == (n == 0));
    const std::vector<Index> first{0, static_cast<Index>(edges.size())};
    const auto per_edge = [&](double crossings) { return crossings / static_cast<double>(edges.size()); };
    CHECK(!are_far_from_delaunay(square.points, edges, first, per_edge(static_cast<double>(n) + 0.5)));
    if (n > 0) CHECK(are_far_from_delaunay(square.points, edges, first, per_edge(static_cast<double>(n) - 0.5)));
    while (!square.flip(edges[square.random() % edges.size()])) continue;
  }
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

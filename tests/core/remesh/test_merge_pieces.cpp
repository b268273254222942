// SPDX-License-Identifier: MIT
// Pieces of one input triangle as one facet: what joins, what keeps apart, what stays inside.
#include <algorithm>
#include <catch2/catch.hpp>

#include "geomesh/core/quality.hpp"
#include "geomesh/core/refine.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "remesh/domain/merge_pieces.hpp"

using namespace geomesh;
using remesh::merge_pieces;
using remesh::MergedFacets;

namespace {

/// A square cut in four by its diagonals, the middle at height `bump`; then a triangle apart.
PiecewiseLinearComplex square(double bump = 0) {
  PiecewiseLinearComplex plc;
  plc.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 2, bump}, {9, 9, 9}, {9, 8, 9}, {8, 9, 8}};
  for (const Triangle& t :
       {Triangle{0, 1, 4}, Triangle{1, 2, 4}, Triangle{2, 3, 4}, Triangle{3, 0, 4}, Triangle{5, 6, 7}})
    plc.add_triangle(t, 0);
  return plc;
}

std::vector<VertexIndex> sorted_loop(const PiecewiseLinearComplex& plc, Index f) {
  std::vector<VertexIndex> loop(plc.outer_loop(f).begin(), plc.outer_loop(f).end());
  std::sort(loop.begin(), loop.end());
  return loop;
}

}  // namespace

TEST_CASE("Pieces of one triangle in one plane become one facet", "[refine]") {
  const std::vector<Index> parent{7, 7, 7, 7, no_index};
  const MergedFacets merged = merge_pieces(square(), parent);
  REQUIRE(merged.plc.n_facets() == 2);
  CHECK(merged.row_of_facet == std::vector<Index>{0, 0, 0, 0, 1});
  CHECK(sorted_loop(merged.plc, 0) == std::vector<VertexIndex>{0, 1, 2, 3});
  CHECK(merged.plc.facet_points.empty());  // nothing else uses the middle
  CHECK(merged.plc.points.size() == square().points.size());
  const auto loop = merged.plc.outer_loop(0);
  const auto at = std::find(loop.begin(), loop.end(), 0) - loop.begin();
  CHECK(loop[static_cast<std::size_t>(at + 1) % 4] == 1);  // oriented as its pieces

  CHECK(merge_pieces(square(), {}).plc.n_facets() == 5);
  CHECK(merge_pieces(square(), std::vector<Index>{7, 7, 8, 8, 8}).plc.n_facets() == 3);
  CHECK(merge_pieces(square(1e-3), parent).plc.n_facets() == 5);
  CHECK(merge_pieces(square(1e-15), parent).plc.n_facets() == 2);  // off the plane by rounding
}

TEST_CASE("What others hold on to stays inside a merged facet", "[refine]") {
  const std::vector<Index> parent{7, 7, 7, 7, no_index};
  PiecewiseLinearComplex plc = square();
  plc.isolated_points = {4};
  MergedFacets merged = merge_pieces(plc, parent);
  REQUIRE(merged.plc.n_facets() == 2);
  REQUIRE(merged.plc.facet_points.size() == 1);
  CHECK(merged.plc.facet_points[0].facet == 0);
  CHECK(merged.plc.facet_points[0].v == 4);

  plc = square();
  plc.segments.push_back({0, 4, 0});  // a curve that ends in the middle
  merged = merge_pieces(plc, parent);
  REQUIRE(merged.plc.n_facets() == 2);
  REQUIRE(merged.plc.facet_segments.size() == 1);
  CHECK(merged.plc.facet_segments[0].a + merged.plc.facet_segments[0].b == 4);
  CHECK(merged.plc.facet_points.empty());
  CHECK(merged.plc.segments.size() == 1);

  plc.segments.push_back({4, 2, 0});  // a curve from side to side
  merged = merge_pieces(plc, parent);
  CHECK(merged.plc.n_facets() == 3);
  CHECK(merged.plc.facet_segments.empty());
}

TEST_CASE("A facet with a hole, and a border that passes a point twice", "[refine]") {
  PiecewiseLinearComplex plc;
  plc.points = {{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}, {2, 2, 0}, {4, 2, 0}, {4, 4, 0}, {2, 4, 0}};
  for (const Triangle& t : {Triangle{0, 1, 5}, Triangle{0, 5, 4}, Triangle{1, 2, 6}, Triangle{1, 6, 5},
                            Triangle{2, 3, 7}, Triangle{2, 7, 6}, Triangle{3, 0, 4}, Triangle{3, 4, 7}})
    plc.add_triangle(t, 0);
  const MergedFacets ring = merge_pieces(plc, std::vector<Index>(8, 0));
  REQUIRE(ring.plc.n_facets() == 1);
  REQUIRE(ring.plc.n_loops(0) == 2);
  CHECK(sorted_loop(ring.plc, 0) == std::vector<VertexIndex>{0, 1, 2, 3});

  // Five of six sectors about a point, and the sixth of another triangle: joined all the way round, the point is passed
  // once. Two missing sectors apart from each other: what is left touches itself in the point.
  PiecewiseLinearComplex fan;
  fan.points = {{0, 0, 0},   {2, 0, 0},  {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0},
                {-1, -2, 0}, {1, -2, 0}, {0, 5, 0}, {0, -5, 0}, {-9, 0, 0}};
  for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{0, 3, 4}, Triangle{1, 7, 2}, Triangle{2, 7, 3},
                            Triangle{7, 9, 3}, Triangle{3, 9, 4}})
    fan.add_triangle(t, 0);
  const MergedFacets touching = merge_pieces(fan, std::vector<Index>(6, 0));
  CHECK(touching.plc.n_facets() == 6);
  CHECK(touching.row_of_facet == std::vector<Index>{0, 1, 2, 3, 4, 5});
}

TEST_CASE("Needles between pieces of one side force nothing", "[refine]") {
  // A box whose top is one square for the user and six pieces for the arrangement, some of them needles.
  PiecewiseLinearComplex plc;
  plc.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},     {0, 0, 1},
                {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 1}, {0.501, 0.5, 1}};
  for (const auto& q : {std::array<VertexIndex, 4>{3, 2, 1, 0}, std::array<VertexIndex, 4>{0, 1, 5, 4},
                        std::array<VertexIndex, 4>{1, 2, 6, 5}, std::array<VertexIndex, 4>{2, 3, 7, 6},
                        std::array<VertexIndex, 4>{3, 0, 4, 7}}) {
    plc.add_triangle({q[0], q[1], q[2]}, 0);
    plc.add_triangle({q[0], q[2], q[3]}, 0);
  }
  for (const Triangle& t : {Triangle{4, 5, 8}, Triangle{5, 9, 8}, Triangle{5, 6, 9}, Triangle{6, 8, 9},
                            Triangle{6, 7, 8}, Triangle{7, 4, 8}})
    plc.add_triangle(t, 0);
  RefineOptions options;
  options.size.global = 0.2;
  const RefineResult kept = refine_and_improve(plc, tetrahedralize(plc), options);
  options.facet_parent.assign(plc.n_facets(), no_index);
  std::fill(options.facet_parent.begin() + 10, options.facet_parent.end(), 0);
  const RefineResult merged = refine_and_improve(plc, tetrahedralize(plc), options);
  CHECK(measure_quality(plc, kept.mesh).whole.min_dihedral.min < 10);
  QualityOptions quality;
  quality.facet_patch = merged.kept_patch;
  const MeshQuality q = measure_quality(plc, merged.mesh, quality);
  CHECK(q.whole.min_dihedral.min > 15);
  CHECK(merged.mesh.tetrahedra.size() < kept.mesh.tetrahedra.size());
  CHECK(merged.statistics.deviation_result_to_input == 0);
  double top = 0;
  std::vector<bool> named(plc.n_facets(), false);
  for (const auto& f : merged.mesh.faces) {
    named[f.facet] = true;
    if (f.facet < 10) continue;
    const Vec3 &a = merged.mesh.points[f.vertices[0]],
               n = cross(merged.mesh.points[f.vertices[1]] - a, merged.mesh.points[f.vertices[2]] - a);
    top += 0.5 * n.z;
    CHECK(a.z == 1);
  }
  CHECK(top == Approx(1).epsilon(1e-12));
  CHECK(std::count(named.begin() + 10, named.end(), true) >= 4);  // faces bear the piece under them
}

TEST_CASE("What is taken apart is not merged again", "[refine]") {
  PiecewiseLinearComplex plc;
  plc.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0}};
  for (const Triangle& t : {Triangle{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}) plc.add_triangle(t);
  std::vector<Index> parent{7, 7, 8, 8};
  const remesh::MergedFacets merged = remesh::merge_pieces(plc, parent);
  REQUIRE(merged.plc.n_facets() == 2);
  CHECK(remesh::take_apart(merged, {merged.row_of_facet[2]}, parent));
  CHECK(parent == std::vector<Index>{7, 7, no_index, no_index});
  const remesh::MergedFacets apart = remesh::merge_pieces(plc, parent);
  CHECK(apart.plc.n_facets() == 3);
  CHECK_FALSE(remesh::take_apart(apart, {apart.row_of_facet[2]}, parent));
}

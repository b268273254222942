// SPDX-License-Identifier: GPL-3.0-or-later
// The form in which a model is meshed, and the way back from it.
#include <algorithm>
#include <catch2/catch.hpp>

#include "corpus_builder.hpp"
#include "corpus_random.hpp"
#include "corpus_transform.hpp"
#include "tetrahedralize/canonical_form.hpp"
#include "tetrahedralize/canonical_frame.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

void check_same_form(const CanonicalForm& a, const CanonicalForm& b) {
  CHECK((a.plc.points == b.plc.points));
  CHECK(a.plc.loop_vertices == b.plc.loop_vertices);
  CHECK(a.plc.loop_offsets == b.plc.loop_offsets);
  CHECK(a.plc.facet_loops == b.plc.facet_loops);
  CHECK(a.plc.isolated_points == b.plc.isolated_points);
  REQUIRE(a.plc.segments.size() == b.plc.segments.size());
  for (std::size_t s = 0; s < a.plc.segments.size(); ++s) {
    CHECK(a.plc.segments[s].a == b.plc.segments[s].a);
    CHECK(a.plc.segments[s].b == b.plc.segments[s].b);
  }
}

std::vector<PointMap> all_frames() {
  std::vector<PointMap> maps;
  std::array<std::size_t, 3> axes{0, 1, 2};
  do {
    for (unsigned turned = 0; turned < 8; ++turned)
      maps.push_back([axes, turned](const Vec3& p) {
        Vec3 out;
        for (std::size_t i = 0; i < 3; ++i) out[i] = (turned >> i & 1u ? -1.0 : 1.0) * p[axes[i]];
        return out;
      });
  } while (std::next_permutation(axes.begin(), axes.end()));
  return maps;
}

/// A cube that is symmetric as a set of points, with one diagonal of one side as a segment.
PiecewiseLinearComplex cube_with_diagonal() {
  PlcBuilder b;
  b.box({-1, -1, -1}, {1, 1, 1});
  PiecewiseLinearComplex plc = b.plc;
  const auto row = [&](const Vec3& p) {
    return static_cast<VertexIndex>(std::find(plc.points.begin(), plc.points.end(), p) - plc.points.begin());
  };
  plc.segments.push_back({row({-1, -1, 1}), row({1, 1, 1}), 7});
  return plc;
}

}  // namespace

TEST_CASE("a model has one form in all 48 frames, whatever its numbers", "[canonical][metamorphic]") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    const PiecewiseLinearComplex plc = random_generic_plc(seed);
    const CanonicalForm form = canonical_form(plc);
    for (const PointMap& map : all_frames()) check_same_form(canonical_form(shuffled(mapped(plc, map), seed)), form);
  }
}

TEST_CASE("where points are symmetric, facets and segments choose the frame", "[canonical][metamorphic]") {
  const PiecewiseLinearComplex plc = cube_with_diagonal();
  const CanonicalForm form = canonical_form(plc);
  for (const PointMap& map : all_frames()) check_same_form(canonical_form(mapped(plc, map)), form);
}

TEST_CASE("the form names each item of the model once, with its vertices", "[canonical]") {
  const PiecewiseLinearComplex plc = random_generic_plc(3);
  const CanonicalForm form = canonical_form(plc);
  const ModelNames& names = form.names;
  REQUIRE(names.vertex.size() == form.plc.points.size());
  for (VertexIndex v = 0; v < names.vertex.size(); ++v) {
    CHECK(names.frame.leave(form.plc.points[v]) == plc.points[names.vertex[v]]);
    CHECK(names.frame.enter(plc.points[names.vertex[v]]) == form.plc.points[v]);
  }
  std::vector<std::uint8_t> is_named(plc.n_facets(), 0);
  for (Index f = 0; f < form.plc.n_facets(); ++f) {
    CHECK(!std::exchange(is_named[names.facet[f]], 1));
    std::vector<VertexIndex> here;
    for (const VertexIndex v : form.plc.outer_loop(f)) here.push_back(names.vertex[v]);
    if (names.facet_is_reversed[f]) std::reverse(here.begin(), here.end());
    const auto there = plc.outer_loop(names.facet[f]);
    std::rotate(here.begin(), std::find(here.begin(), here.end(), there[0]), here.end());
    CHECK(std::equal(here.begin(), here.end(), there.begin(), there.end()));
  }
  for (Index s = 0; s < form.plc.segments.size(); ++s) {
    auto [a, b, curve] = form.plc.segments[s];
    if (names.segment_is_reversed[s]) std::swap(a, b);
    CHECK(names.vertex[a] == plc.segments[names.segment[s]].a);
    CHECK(names.vertex[b] == plc.segments[names.segment[s]].b);
  }
}

TEST_CASE("a frame mirrors where an odd number of axes is turned or two are exchanged", "[canonical]") {
  CHECK_FALSE(AxisFrame{}.mirrors());
  CHECK_FALSE((AxisFrame{{1, 2, 0}, {1, 1, 1}}.mirrors()));
  CHECK((AxisFrame{{1, 0, 2}, {1, 1, 1}}.mirrors()));
  CHECK((AxisFrame{{0, 1, 2}, {1, -1, 1}}.mirrors()));
  CHECK_FALSE((AxisFrame{{2, 1, 0}, {1, -1, 1}}.mirrors()));
}

TEST_CASE("vertices that nothing names, and negative zeros, do not matter to the form", "[canonical]") {
  PiecewiseLinearComplex plc = cube_with_diagonal();
  const CanonicalForm form = canonical_form(plc);
  plc.points.push_back({3.5, -0.0, 12});
  check_same_form(canonical_form(plc), form);
  const PiecewiseLinearComplex at_zero = mapped(cube_with_diagonal(), moved({1, 1, 1}));
  const PointMap with_negative_zeros = [](const Vec3& p) { return Vec3{p.x == 0 ? -0.0 : p.x, p.y, p.z}; };
  check_same_form(canonical_form(mapped(at_zero, with_negative_zeros)), canonical_form(at_zero));
}

TEST_CASE("edges, isolated points and names of regions come back as they were asked for", "[canonical]") {
  PlcBuilder builder;
  builder.box({0, 0, 0}, {4, 5, 6});
  PiecewiseLinearComplex plc = builder.plc;
  const auto first = static_cast<VertexIndex>(plc.points.size());
  plc.points.insert(plc.points.end(), {{3, 3, 3}, {1, 1, 1}, {2, 1, 3}, {1, 3, 4.5}});
  plc.segments = {{first, first + 1, 10}, {first + 2, first + 3, 11}, {first + 1, first, 12}};
  plc.isolated_points = {first + 3, first};
  plc.region_seeds = {{{0.5, 0.5, 0.5}, 42}, {{3, 4, 5}, 43}};
  for (const PiecewiseLinearComplex& image : {plc, mapped(plc, mirrored(), -1), mapped(plc, axes_permuted())}) {
    const ConstrainedTetrahedralization mesh = tetrahedralize(image);
    REQUIRE(mesh.edges.size() == 3);
    for (Index row = 0; row < 3; ++row) {
      CHECK(mesh.edges[row].segment == row);
      CHECK(mesh.points[mesh.edges[row].a] == image.points[image.segments[row].a]);
      CHECK(mesh.points[mesh.edges[row].b] == image.points[image.segments[row].b]);
    }
    REQUIRE(mesh.isolated_points.size() == 2);
    CHECK(mesh.points[mesh.isolated_points[0]] == image.points[first + 3]);
    CHECK(mesh.points[mesh.isolated_points[1]] == image.points[first]);
    CHECK(mesh.component_seed == std::vector<Index>{42});
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Where features are of a few ulps no doubles are left for the points that recovery needs: it ends with the place, and
// what is there.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "corpus_run.hpp"
#include "corpus_transform.hpp"
#include "geomesh/core/predicates.hpp"
#include "thin_models.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

void check_excerpt(const MeshExcerpt& e) {
  CHECK(!e.culprits.empty());
  CHECK(!e.tetrahedra.empty());
  CHECK(e.triangles.size() == e.facet.size());
  const auto is_row = [&](VertexIndex v) { return v < e.points.size(); };
  for (Tetrahedron t : e.tetrahedra) {  // positive at their exact places; those are rounded in an excerpt
    CHECK(std::all_of(t.begin(), t.end(), is_row));
    std::sort(t.begin(), t.end());
    CHECK(std::adjacent_find(t.begin(), t.end()) == t.end());
  }
  CHECK(std::all_of(e.culprits.begin(), e.culprits.end(), is_row));
  for (const Triangle& t : e.triangles) CHECK(std::all_of(t.begin(), t.end(), is_row));
  for (const auto& s : e.segments) CHECK(std::all_of(s.begin(), s.end(), is_row));
}

void check_failure(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options, ErrorKind kind) {
  try {
    tetrahedralize(plc, options);
    FAIL("what has no room was meshed");
  } catch (const Error& e) {
    CHECK(e.kind() == kind);
    CHECK(!e.context().places.empty());
    REQUIRE(e.context().excerpt);
    check_excerpt(*e.context().excerpt);
  }
}

}  // namespace

TEST_CASE("where doubles leave no room recovery ends with the place and the cells there", "[recover]") {
  check_failure(in_ulps("chazelle_8", 64), constrained_mode(), ErrorKind::cannot_mesh);
}

TEST_CASE("where the boundary cannot be kept recovery ends with the place and the cells there", "[recover]") {
  check_failure(in_ulps("chazelle_4", 64), preserving_mode(), ErrorKind::cannot_mesh);
}

TEST_CASE("where segments cross recovery ends with the place and the cells there", "[recover]") {
  check_failure(in_ulps("hanging_plates_2", 16), constrained_mode(), ErrorKind::invalid_input);
}
namespace {

/// What an error about crossing segments names is part of the model as it was given, in its numbers and its frame.
void check_terms(const PiecewiseLinearComplex& plc, const Error& e) {
  const ErrorContext& c = e.context();
  const std::string words = e.what();
  REQUIRE(c.vertices.size() == c.places.size());
  for (std::size_t i = 0; i < c.vertices.size(); ++i) {
    CHECK(plc.points[c.vertices[i]] == c.places[i]);
    CHECK(words.find("vertex " + std::to_string(c.vertices[i]) + " at ") != std::string::npos);
  }
  CHECK(!c.facets.empty());
  for (const Index f : c.facets) {
    CHECK(std::any_of(c.vertices.begin(), c.vertices.end(),
                      [&](VertexIndex v) { return std::ranges::count(plc.outer_loop(f), v) > 0; }));
    CHECK(words.find(std::to_string(f)) != std::string::npos);
  }
  REQUIRE(c.excerpt);
  check_excerpt(*c.excerpt);
  for (std::size_t i = 0; i < c.excerpt->triangles.size(); ++i) {
    std::array<Vec3, 3> triangle, facet;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle[k] = c.excerpt->points[c.excerpt->triangles[i][k]];
      facet[k] = plc.points[plc.outer_loop(c.excerpt->facet[i])[k]];
    }
    const auto start = std::find(facet.begin(), facet.end(), triangle[0]);
    REQUIRE(start != facet.end());
    std::rotate(facet.begin(), start, facet.end());
    CHECK(triangle == facet);
  }
}

}  // namespace

TEST_CASE("errors and what they show are in the model's own numbers and frame", "[recover][metamorphic]") {
  const PiecewiseLinearComplex plc = in_ulps("hanging_plates_2", 16);
  for (const PiecewiseLinearComplex& image :
       {plc, mapped(plc, mirrored(), -1), mapped(plc, axes_permuted()), shuffled(plc, 3)}) {
    try {
      tetrahedralize(image);
      FAIL("crossing segments were meshed");
    } catch (const Error& e) {
      check_terms(image, e);
    }
  }
}

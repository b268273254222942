// SPDX-License-Identifier: GPL-3.0-or-later
// Where features are of a few ulps no doubles are left for the points that recovery needs: it ends with the place, and what is there.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "corpus_run.hpp"
#include "corpus_transform.hpp"
#include "geomesh/core/predicates.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

/// The model with `size` ulps for a unit.
PiecewiseLinearComplex in_ulps(const char* name, double size) {
  const double far = 0x1p52;  // where doubles are one apart
  return mapped(as_triangles(corpus_model(name).make()), [=](const Vec3& p) {
    return Vec3{far + std::round(size * p.x), far + std::round(size * p.y), far + std::round(size * p.z)};
  });
}

void check_excerpt(const MeshExcerpt& e) {
  CHECK(!e.culprits.empty());
  CHECK(!e.tetrahedra.empty());
  CHECK(e.triangles.size() == e.facet.size());
  for (const Tetrahedron& t : e.tetrahedra)
    CHECK(orient3d(e.points[t[0]], e.points[t[1]], e.points[t[2]], e.points[t[3]]) == Sign::positive);
  const auto is_row = [&](VertexIndex v) { return v < e.points.size(); };
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
  check_failure(in_ulps("chazelle_4", 64), constrained_mode(), ErrorKind::cannot_mesh);
}

TEST_CASE("where the boundary cannot be kept recovery ends with the place and the cells there", "[recover]") {
  check_failure(in_ulps("chazelle_2", 64), preserving_mode(), ErrorKind::cannot_mesh);
}

TEST_CASE("where segments cross recovery ends with the place and the cells there", "[recover]") {
  check_failure(in_ulps("hanging_plates_2", 16), constrained_mode(), ErrorKind::invalid_input);
}

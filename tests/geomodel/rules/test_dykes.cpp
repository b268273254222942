// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets with a thickness: walls, volume, rows, and what is refused.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "naming/sheets.hpp"
#include "naming/sums.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

constexpr unsigned n = 20;

TriangulatedSurface empty_body() {
  TriangulatedSurface s;
  s.name = "dyke";
  s.kind = SurfaceKind::body;
  s.cuts_all = true;
  return s;
}

/// A sheet over a square of side 20 in the plane of y and z, x by `height`; every other triangle is turned.
template <class F>
TriangulatedSurface sheet_over(F&& height) {
  TriangulatedSurface s = empty_body();
  for (unsigned j = 0; j <= n; ++j)
    for (unsigned i = 0; i <= n; ++i) s.points.push_back({height(i, j), double(i), double(j)});
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      s.triangles.push_back({a, a + 1, a + n + 2});
      s.triangles.push_back({a, a + n + 1, a + n + 2});
    }
  return s;
}

double volume_of(const TriangulatedSurface& s) {
  double volume = 0;
  for (const Triangle& t : s.triangles) volume += dot(s.points[t[0]], cross(s.points[t[1]], s.points[t[2]])) / 6;
  return volume;
}

BuiltSurfaces thickened(const TriangulatedSurface& sheet, double thickness) {
  ModelRules rules;
  rules.surfaces.resize(1);
  rules.surfaces[0].thickness = thickness;
  return build_surfaces({sheet}, rules);
}

std::string refusal(const TriangulatedSurface& sheet, double thickness) {
  try {
    thickened(sheet, thickness);
  } catch (const Error& e) {
    CHECK(e.kind() == ErrorKind::invalid_input);
    return e.what();
  }
  return {};
}

}  // namespace

TEST_CASE("A plane sheet with a thickness becomes a box, whichever way its triangles are stored", "[rules]") {
  const TriangulatedSurface given = sheet_over([](unsigned i, unsigned) { return 0.5 * i; });
  const BuiltSurfaces built = thickened(given, 2);
  const TriangulatedSurface& body = built.surfaces[0];
  CHECK(is_closed(body));
  CHECK(volume_of(body) == Approx(2 * 20 * 20 * std::sqrt(1.25)));
  CHECK(built.rows.n_given_triangles[0] == given.triangles.size());
  CHECK(body.triangles.size() == 2 * given.triangles.size() + 2 * 4 * n);
  for (std::size_t v = 0; v < body.points.size(); ++v) {
    const Vec3 d = body.points[v] - given.points[v % given.points.size()];
    CHECK(dot(d, d) == Approx(1));
  }
  REQUIRE(built.notes.size() == 1);
  CHECK(built.notes[0].find("thickness 2") != std::string::npos);
}

TEST_CASE("Walls of a bent sheet lie at half of the thickness from its triangles, and equal points stay together",
          "[rules]") {
  const auto bent = [](unsigned i, unsigned j) { return 3 * std::sin(0.3 * i) + 2 * std::cos(0.2 * j); };
  TriangulatedSurface given = sheet_over(bent);
  TriangulatedSurface apart = given;  // as from STL: each triangle with points of its own
  apart.points.clear();
  for (Triangle& t : apart.triangles)
    for (VertexIndex& v : t) {
      apart.points.push_back(given.points[v]);
      v = static_cast<VertexIndex>(apart.points.size() - 1);
    }
  const TriangulatedSurface body = thickened(given, 1).surfaces[0], other = thickened(apart, 1).surfaces[0];
  CHECK(is_closed(body));
  CHECK(is_closed(other));
  CHECK(volume_of(other) == Approx(volume_of(body)));
  double least = 1, most = 0;
  for (std::size_t t = 0; t < given.triangles.size(); ++t) {
    const Triangle& g = given.triangles[t];
    const Vec3 area = cross(given.points[g[1]] - given.points[g[0]], given.points[g[2]] - given.points[g[0]]);
    for (const VertexIndex v : g) {
      const double height = std::abs(dot(area, body.points[v] - given.points[v])) / std::sqrt(dot(area, area));
      least = std::min(least, height), most = std::max(most, height);
    }
  }
  CHECK(least > 0.46);
  CHECK(most < 0.54);
}

TEST_CASE("What is no sheet, or bends more tightly than its thickness, is refused with the place", "[rules]") {
  const TriangulatedSurface pleats = sheet_over([](unsigned i, unsigned) { return i % 2 ? 4.0 : 0.0; });
  CHECK(refusal(pleats, 3).find("bends too sharply") != std::string::npos);
  const TriangulatedSurface folds = sheet_over([](unsigned i, unsigned) { return 3 * std::sin(0.6 * i); });
  CHECK(refusal(folds, 0.5).empty());
  CHECK(refusal(folds, 6).find("bends more tightly") != std::string::npos);
  TriangulatedSurface three = sheet_over([](unsigned, unsigned) { return 0.0; });
  three.points.push_back({5, 0.5, 0});
  three.triangles.push_back({0, n + 2, static_cast<VertexIndex>(three.points.size() - 1)});
  CHECK(refusal(three, 1).find("more than two triangles") != std::string::npos);
  TriangulatedSurface moebius = empty_body();
  for (unsigned k = 0; k < 12; ++k)
    for (const double r : {-1.0, 1.0}) {
      const double a = k * std::numbers::pi / 6, half = a / 2;
      moebius.points.push_back(
          {(9 + r * std::cos(half)) * std::cos(a), (9 + r * std::cos(half)) * std::sin(a), r * std::sin(half)});
    }
  for (Index k = 0; k < 12; ++k) {
    const Index a = 2 * k, b = 2 * k + 1, c = k == 11 ? 1 : a + 2, d = k == 11 ? 0 : b + 2;
    moebius.triangles.push_back({a, b, c});
    moebius.triangles.push_back({b, d, c});
  }
  CHECK(refusal(moebius, 0.1).find("one side alone") != std::string::npos);
}

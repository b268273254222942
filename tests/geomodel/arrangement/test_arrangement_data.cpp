// SPDX-License-Identifier: GPL-3.0-or-later
// The sets of outside data, and metamorphic runs.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "arrangement_inputs.hpp"
#include "corpus_run.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/build_model.hpp"
#include "require_sound.hpp"
#include "soup_models.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

const std::filesystem::path data = GEOMESH_SHARED_DATA;

bool is_there(const char* part) {
  if (std::filesystem::exists(data / part)) return true;
  WARN("skipped: " << (data / part).string() << " is not there");
  return false;
}

std::vector<TriangulatedSurface> folder(const char* name, const char* extension) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(data / name))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<TriangulatedSurface> surfaces;
  for (const auto& f : files) surfaces.push_back(f.extension() == ".ts" ? load_ts(f) : load_obj(f));
  return surfaces;
}

/// Sound; no point moved by more than a few ulps of the largest coordinate; areas are kept.
ArrangementResult require_good(const std::vector<TriangulatedSurface>& surfaces, const std::optional<Box3>& box) {
  ArrangementOptions options;
  options.box = box;
  ArrangementResult result = arrange(surfaces, {}, {}, options);
  require_sound(result.soup);
  CHECK(ulps_of_largest(result.soup, result.rounding.largest) <= 4);
  for (Index s = 0; s < surfaces.size(); ++s) {
    INFO(surfaces[s].name);
    CHECK(area_of(result.soup, s) + result.area_clipped_by_box[s] == Approx(area_of(surfaces[s])).epsilon(1e-9));
  }
  return result;
}

/// Good, and meshed in constrained mode with the boundary kept, which is judged exactly.
ArrangementResult require_good_and_meshed(const std::vector<TriangulatedSurface>& surfaces,
                                          const std::optional<Box3>& box) {
  constexpr double time_limit = 120;
  ArrangementResult result = require_good(surfaces, box);
  CHECK(test::run_and_judge(complex_of(result.soup), test::preserving_mode(), time_limit).trouble == "");
  return result;
}

TriangulatedSurface moved(TriangulatedSurface s, const std::function<Vec3(const Vec3&)>& move) {
  for (Vec3& p : s.points) p = move(p);
  return s;
}

/// Volumes of the regions that a soup encloses, least first.
std::vector<double> region_volumes(const PolygonSoup& soup) {
  const ConstrainedTetrahedralization mesh = tetrahedralize(complex_of(soup), {}, {});
  std::map<Index, double> volume;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const Tetrahedron& v = mesh.tetrahedra[t];
    const Vec3 &a = mesh.points[v[0]], &b = mesh.points[v[1]], &c = mesh.points[v[2]], &d = mesh.points[v[3]];
    volume[mesh.component[t]] += std::fabs(dot(cross(b - a, c - a), d - a)) / 6;
  }
  std::vector<double> sorted;
  for (const auto& [component, sum] : volume) sorted.push_back(sum);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

/// As many regions, and of volumes `factor` times as large within `tolerance`.
void require_same_regions(const std::vector<double>& volumes, const std::vector<double>& plain, double factor,
                          double tolerance) {
  REQUIRE(volumes.size() == plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) CHECK(std::fabs(volumes[i] - factor * plain[i]) <= tolerance);
}

}  // namespace

TEST_CASE("arrange: the fault sets in boxes", "[arrangement][data]") {
  if (!is_there("faults")) return;
  for (const char* set : {"faults/SALT", "faults/SNFA", "faults/MJVA"}) {
    INFO(set);
    const auto surfaces = folder(set, ".ts");
    const auto result = require_good(surfaces, wide_box(surfaces));
    CHECK(result.n_crossing_pairs >= 80);
  }
}

TEST_CASE("arrange: Claudius in its boxes", "[arrangement][data]") {
  if (!is_there("claudius")) return;
  const auto horizons = load_all_ts(data / "claudius/claudius_delaunay.ts");
  REQUIRE(horizons.size() == 4);
  require_good_and_meshed(horizons, Box3{{549500, 7820100, -11010}, {550850, 7821750, -8400}});
  require_good_and_meshed(horizons, Box3{{548800, 7816600, -11010}, {552500, 7822000, -8400}});
}

TEST_CASE("arrange: solids", "[arrangement][data]") {
  if (!is_there("solids")) return;
  require_good({load_obj(data / "solids/Gravgen.obj")}, std::nullopt);  // meshed by test_recover_soups.cpp
  require_good_and_meshed({load_obj(data / "solids/two_spheres.obj")}, std::nullopt);
  require_good_and_meshed({load_obj(data / "solids/sphere1.obj"), load_obj(data / "solids/sphere2.obj")}, std::nullopt);
  const auto soup = load_stl(data / "solids/soup.stl");
  REQUIRE(soup.triangles.size() == 100);
  require_good_and_meshed({soup}, wide_box({soup}));
  const auto bunny = load_obj(data / "solids/bunny25k.obj");
  const auto cow = moved(load_obj(data / "solids/cow25k.obj"), [&, box = wide_box({bunny})](const Vec3& p) {
    const double c = std::cos(0.7), s = std::sin(0.7), scale = 0.8 * (box.max.x - box.min.x);
    return 0.5 * (box.min + box.max) + scale * Vec3{c * p.x - s * p.z, p.y, s * p.x + c * p.z};
  });
  CHECK(require_good_and_meshed({bunny, cow}, std::nullopt).n_crossing_pairs > 100);
}

TEST_CASE("arrange: a hundred grains in a box", "[arrangement][data]") {
  if (!is_there("grains")) return;
  const auto grains = folder("grains", ".obj");
  REQUIRE(grains.size() == 100);
  const auto result = require_good_and_meshed(grains, wide_box(grains));
  CHECK(result.soup.facets.size() == 100 * 320 + 12);
}

TEST_CASE("arrange: mirrored, permuted and scaled input gives the same counts", "[arrangement]") {
  const std::vector<TriangulatedSurface> surfaces{
      grid_surface("a", SurfaceKind::horizon, 12, 0, 10, 0, 10,
                   [](double x, double y) { return std::sin(x) + 0.1 * y; }),
      grid_surface("b", SurfaceKind::horizon, 9, 0, 10, 0, 10,
                   [](double x, double y) { return std::cos(y) + 0.1 * x; }),
      ellipsoid("c", {5.1, 4.9, 0.2}, {2, 3, 2.5}, 3)};
  const auto plain = arrange(surfaces, {}, {}, {});
  require_sound(plain.soup);
  const std::vector<double> volumes = region_volumes(plain.soup);
  REQUIRE(volumes.size() >= 4);  // two sheets that cross divide the body into four or more
  struct Move {
    std::function<Vec3(const Vec3&)> of;
    double volume_factor;
  };
  const std::vector<Move> moves{{[](const Vec3& p) {
                                   return Vec3{-p.x, p.y, p.z};
                                 },
                                 1},
                                {[](const Vec3& p) {
                                   return Vec3{p.y, p.z, p.x};
                                 },
                                 1},
                                {[](const Vec3& p) {
                                   return Vec3{p.z, p.y, p.x};
                                 },
                                 1},
                                {[](const Vec3& p) { return std::ldexp(1.0, 17) * p; }, std::ldexp(1.0, 51)},
                                {[](const Vec3& p) { return std::ldexp(1.0, -31) * p; }, std::ldexp(1.0, -93)}};
  for (const auto& [move, volume_factor] : moves) {
    std::vector<TriangulatedSurface> other;
    for (const auto& s : surfaces) other.push_back(moved(s, move));
    const auto result = arrange(other, {}, {}, {});
    require_sound(result.soup);
    CHECK(result.soup.facets.size() == plain.soup.facets.size());
    CHECK(result.soup.points.size() == plain.soup.points.size());
    CHECK(result.n_crossing_pairs == plain.n_crossing_pairs);
    CHECK(result.spots.size() == plain.spots.size());
    CHECK(make_plc(result.soup, other, {}).curves.size() == make_plc(plain.soup, surfaces, {}).curves.size());
    require_same_regions(region_volumes(result.soup), volumes, volume_factor, 1e-11 * volume_factor * volumes.back());
  }
  std::vector<TriangulatedSurface> far;
  for (const auto& s : surfaces)
    far.push_back(moved(s, [](const Vec3& p) {
      const double c = std::cos(0.3), d = std::sin(0.3);
      return Vec3{549500 + c * p.x - d * p.y, 7820100 + d * p.x + c * p.y, p.z - 9000};
    }));
  const auto utm = arrange(far, {}, {}, {});
  require_sound(utm.soup);
  CHECK(ulps_of_largest(utm.soup, utm.rounding.largest) <= 4);
  // Input points move by up to half an ulp when they are turned, intersections once more.
  double area = 0;
  for (const auto& s : surfaces) area += area_of(s);
  require_same_regions(region_volumes(utm.soup), volumes, 1, 2 * std::ldexp(1.0, 22 - 52) * area);
}

TEST_CASE("arrange: the same soup whatever the number of threads", "[arrangement]") {
  const std::vector<TriangulatedSurface> surfaces{
      grid_surface("a", SurfaceKind::horizon, 40, 0, 10, 0, 10,
                   [](double x, double y) { return std::sin(x) + 0.1 * y; }),
      grid_surface("b", SurfaceKind::horizon, 40, 0, 10, 0, 10,
                   [](double x, double y) { return std::cos(y) + 0.1 * x; }),
      ellipsoid("c", {5.1, 4.9, 0.2}, {2, 3, 2.5}, 4)};
  RunContext one, many;
  one.threads = 1;
  many.threads = 4;
  const auto a = arrange(surfaces, {}, {}, {}, one).soup, b = arrange(surfaces, {}, {}, {}, many).soup;
  CHECK(a.points == b.points);
  CHECK(a.facets == b.facets);
  CHECK(a.origins == b.origins);
  CHECK(a.origin_offsets == b.origin_offsets);
}

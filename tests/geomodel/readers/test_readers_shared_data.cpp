// SPDX-License-Identifier: GPL-3.0-or-later
// Real files: counts and sums that are known from elsewhere.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>

#include "geomesh/geomodel/readers.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

const std::filesystem::path data = GEOMESH_SHARED_DATA;

bool have_data() {
  if (std::filesystem::exists(data)) return true;
  WARN("skipped: no folder of outside test data at " << data.string());
  return false;
}

std::size_t n_triangles(const FileContents& contents) {
  std::size_t n = 0;
  for (const TriangulatedSurface& s : contents.surfaces) n += s.triangles.size();
  return n;
}

/// By the divergence theorem about a point near the model.
double enclosed_volume(const RegionHint& region, const FileContents& contents) {
  const Vec3 origin = contents.surfaces.front().points.front();
  long double sum = 0;
  for (const RegionHint::OrientedTriangle& side : region.boundary) {
    const TriangulatedSurface& s = contents.surfaces[side.surface];
    const Triangle& t = s.triangles[side.triangle];
    const Vec3 a = s.points[t[0]] - origin, b = s.points[t[1]] - origin, c = s.points[t[2]] - origin;
    const double six = dot(a, cross(b, c));
    sum += side.as_stored ? six : -six;
  }
  return static_cast<double>(sum / 6);
}

}  // namespace

TEST_CASE("solids have the triangles that are known", "[readers][shared]") {
  if (!have_data()) return;
  const std::map<std::string, std::pair<std::size_t, std::size_t>> known{{"bunny25k.obj", {12500, 24996}},
                                                                         {"res.obj", {1572, 3140}},
                                                                         {"Gravgen.obj", {11803, 17692}},
                                                                         {"humanoid.off", {10050, 20096}},
                                                                         {"1002_tray_bottom.STL", {2216, 4520}},
                                                                         {"7_8ths_cube.stl", {14, 24}},
                                                                         {"plate_holes.STL", {618, 1252}},
                                                                         {"round.stl", {560, 1120}},
                                                                         {"soup.stl", {300, 100}},
                                                                         {"shared.STL", {14, 24}},
                                                                         {"multibody.stl", {20, 32}},
                                                                         {"ballA.off", {1900, 3796}},
                                                                         {"fixed_top.ply", {2374, 4772}}};
  for (const auto& [name, counts] : known) {
    INFO(name);
    const FileContents contents = read_surface_file(data / "solids" / name);
    REQUIRE(contents.surfaces.size() == 1);
    CHECK(contents.surfaces[0].points.size() == counts.first);
    CHECK(contents.surfaces[0].triangles.size() == counts.second);
  }
}

TEST_CASE("a GOCAD model brings its regions, and their signed faces enclose the known volumes", "[readers][shared]") {
  if (!have_data()) return;
  const FileContents contents = read_surface_file(data / "modelA4/modelA4.ml");
  CHECK(contents.surfaces.size() == 11);
  CHECK(n_triangles(contents) == 48903);
  CHECK(contents.frame.depth);
  CHECK(contents.surfaces[0].kind == SurfaceKind::fault);
  CHECK(contents.surfaces[8].kind == SurfaceKind::horizon);
  const std::map<std::string, double> volume{{"H1b_2", 1.910289458695007e+10}, {"H0b_2", 1.552997748375148e+11},
                                             {"H2b_2", 7.690321669315164e+10}, {"H3b_2", 2.482677184401592e+11},
                                             {"H0b_1", 1.510235425751086e+11}, {"H3b_1", 7.035057973031653e+10},
                                             {"H1b_1", 1.153355172814854e+10}, {"H2b_1", 4.374732186774761e+10}};
  REQUIRE(contents.regions.size() == volume.size());
  for (const RegionHint& region : contents.regions) {
    INFO(region.name);
    REQUIRE(volume.count(region.name) == 1);
    CHECK(enclosed_volume(region, contents) == Approx(volume.at(region.name)).epsilon(1e-9));
  }
}

TEST_CASE("horizons, faults and the samples of GOCAD files are read", "[readers][shared]") {
  if (!have_data()) return;
  const FileContents claudius = read_surface_file(data / "claudius/claudius_delaunay.ts");
  CHECK(claudius.surfaces.size() == 4);
  CHECK(n_triangles(claudius) == 41434);
  CHECK(claudius.surfaces[1].name == "horizon_60");
  CHECK(claudius.warnings.empty());

  std::map<std::string, std::pair<std::size_t, std::size_t>> sums;
  for (const char* folder : {"SALT", "SNFA", "MJVA"}) {
    for (const auto& entry : std::filesystem::directory_iterator(data / "faults" / folder)) {
      if (entry.path().extension() != ".ts") continue;
      INFO(entry.path().string());
      const FileContents contents = read_surface_file(entry.path());
      REQUIRE(contents.surfaces.size() == 1);
      ++sums[folder].first;
      sums[folder].second += n_triangles(contents);
    }
  }
  CHECK(sums["SALT"] == std::pair<std::size_t, std::size_t>(11, 2105));
  CHECK(sums["SNFA"] == std::pair<std::size_t, std::size_t>(34, 24914));
  CHECK(sums["MJVA"] == std::pair<std::size_t, std::size_t>(44, 10212));

  const FileContents depth = read_surface_file(data / "gocad/ts-2props.ts");
  REQUIRE(depth.surfaces.size() == 1);
  CHECK(depth.surfaces[0].triangles == std::vector<Triangle>{{2, 0, 1}, {3, 2, 1}});
  CHECK(depth.surfaces[0].points[3].z == 81256.234375);
  CHECK(depth.warnings.size() == 1);  // Depth with z negative
  CHECK(read_surface_file(data / "gocad/closed_lines.pl").polylines.size() == 74);
  CHECK(read_surface_file(data / "gocad/points.vs").point_sets.at(0).points.front().x == 526771.3388671875);
}

TEST_CASE("TetGen files keep holes, regions and cavities", "[readers][shared]") {
  if (!have_data()) return;
  const PlcFile file = read_plc_file(data / "classic/pillar_holes_regions.poly");
  CHECK(file.plc.points.size() == 36);
  CHECK(file.plc.n_facets() == 28);
  CHECK(file.facet_markers[2] == 3);
  CHECK(file.plc.hole_seeds.size() == 1);
  CHECK(file.plc.region_seeds.size() == 4);
  CHECK(file.region_names == std::vector<std::string>{"region_1", "region_2", "region_3", "region_3"});
  CHECK(file.plc.n_loops(0) == 2);  // the floor has the pillar's foot as a hole
}

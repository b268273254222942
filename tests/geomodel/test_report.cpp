// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "geomesh/geomodel/report.hpp"
#include "hand_made.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

ModelMesh one_tetrahedron(const std::array<Vec3, 4>& p) {
  ModelMesh mesh;
  mesh.points.assign(p.begin(), p.end());
  mesh.point_kind.assign(4, 0);
  mesh.tetrahedra = {{0, 1, 2, 3}};
  mesh.tet_region = {1};
  mesh.regions = {{1, "r", {}, 1, 1}};
  return mesh;
}

}  // namespace

TEST_CASE("quality of tetrahedra whose angles are known", "[report]") {
  SECTION("regular") {
    const QualityStatistics q = measure_quality(one_tetrahedron({{{0, 0, 0}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}}}));
    CHECK(q.min_dihedral == Approx(std::acos(1.0 / 3) * 180 / M_PI).epsilon(1e-14));
    CHECK(q.max_dihedral == Approx(q.min_dihedral).epsilon(1e-14));
    CHECK(q.min_radius_ratio == Approx(1).epsilon(1e-14));
    CHECK(q.dihedral_histogram[7] == 6);
    CHECK(q.worst.size() == 1);
  }
  SECTION("corner of a cube") {
    const QualityStatistics q = measure_quality(one_tetrahedron({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}));
    CHECK(q.min_dihedral == Approx(std::atan(std::sqrt(2.0)) * 180 / M_PI).epsilon(1e-14));
    CHECK(q.max_dihedral == Approx(90).epsilon(1e-14));
    const double r = 1 / (3 + std::sqrt(3.0)), big = std::sqrt(3.0) / 2;
    CHECK(q.min_radius_ratio == Approx(3 * r / big).epsilon(1e-13));
  }
  SECTION("flat as a sheet: angles near 0 and 180 keep their digits") {
    const double h = 1e-9;
    const QualityStatistics q = measure_quality(one_tetrahedron({{{0, 0, 0}, {2, 0, 0}, {1, 1, h}, {1, -1, h}}}));
    CHECK(q.max_dihedral == Approx(180 - 2 * h * 180 / M_PI).epsilon(1e-14));
    CHECK(q.min_radius_ratio > 0);
    CHECK(q.min_radius_ratio < 1e-8);
  }
}

TEST_CASE("histograms count every tetrahedron and the worst come first", "[report]") {
  const ModelMesh mesh = three_layer_mesh(3);
  const QualityStatistics q = measure_quality(mesh);
  const auto sum = [](const std::vector<std::size_t>& h) { return std::accumulate(h.begin(), h.end(), std::size_t{0}); };
  CHECK(sum(q.min_dihedral_histogram) == mesh.tetrahedra.size());
  CHECK(sum(q.dihedral_histogram) == 6 * mesh.tetrahedra.size());
  CHECK(sum(q.radius_ratio_histogram) == mesh.tetrahedra.size());
  CHECK(q.worst.size() == 10);
  CHECK(q.worst.front().min_dihedral == q.min_dihedral);
  CHECK(std::is_sorted(q.worst.begin(), q.worst.end(), [](const auto& a, const auto& b) { return a.min_dihedral < b.min_dihedral; }));
}

TEST_CASE("a full report has the names of the output contract and fits its schema", "[report]") {
  const ModelMesh mesh = three_layer_mesh(2);
  ConstrainedTetrahedralization core;
  core.recovery.segments_total = 7;
  core.recovery.facets_not_recovered = {3};
  core.delaunay_statistics.points_deferred = 11;
  ArrangementResult arrangement;
  arrangement.area_clipped_by_bodies = {0, 2.5};
  arrangement.area_clipped_by_box = {1, 0};
  arrangement.spots = {{"crossing", 0, 1, 3, 0.5, {1, 2, 3}}};
  Report report;
  report.command = "project";
  report.name = mesh.name;
  report.stages = {{"read", 0.1, 0.1, 1000}, {"write", 0.2, 0.3, 2000}};
  report.input_json = R"({"surfaces": 2})";
  report.core = &core;
  report.arrangement = &arrangement;
  report.mesh = &mesh;
  report.quality = measure_quality(mesh);
  report.warnings = {"something \xff not UTF-8"};
  report.files = {"model.vtu"};
  const json read = json::parse(to_json(report));
  CHECK(read["stages"][1]["name"] == "write");
  CHECK(read["points_deferred"] == 11);
  CHECK(read["recovery"]["segments_total"] == 7);
  CHECK(read["recovery"]["facets_not_recovered"] == json::array({3}));
  CHECK(read["regions"][1]["name"] == "middle layer, which is long to name");
  CHECK(read["regions"][1]["volume"].get<double>() == Approx(4).epsilon(1e-14));
  CHECK(read["surfaces"][0]["area"] == 4.0);
  CHECK(read["displacement"]["clipping"]["area_by_bodies"] == 2.5);
  CHECK(read["displacement"]["clipping"]["surfaces"][0]["surface"] == "upper");
  CHECK(read["intersection"]["spots"][0]["surface_b"] == "lower");
  CHECK(read["input"]["surfaces"] == 2);

  const fs::path folder = fs::path(GEOMESH_BINARY_DIR) / "test-output";
  fs::create_directories(folder);
  Report empty;
  empty.command = "info";
  for (const Report* r : {&report, &empty}) {
    write_report(*r, folder / "report.json");
    const std::string command = std::string("timeout 60 /usr/bin/python3 ") + GEOMESH_SOURCE_DIR + "/tests/geomodel/read_back.py schema " +
                                GEOMESH_SOURCE_DIR + "/docs/report.schema.json '" + (folder / "report.json").string() + "'";
    const int status = std::system(command.c_str());
    if (WIFEXITED(status) && (WEXITSTATUS(status) == 77 || WEXITSTATUS(status) == 127)) {
      WARN("skipped: schema check (python3-jsonschema is not installed)");
    } else {
      CHECK(status == 0);
    }
  }
}

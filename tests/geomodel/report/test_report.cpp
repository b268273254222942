// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "geomesh/geomodel/report.hpp"
#include "geomesh/geomodel/warnings.hpp"
#include "hand_made.hpp"
#include "installed.hpp"
#include "made_up_quality.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A soup of three triangles of different surfaces, each a facet of the PLC; one segment on the curve `tip`.
struct NamedParts {
  PolygonSoup soup;
  ModelPlc plc;
  std::vector<TriangulatedSurface> surfaces;
  NamedParts() {
    for (Index f = 0; f < 3; ++f) {
      soup.facets.push_back({0, 1, 2});
      soup.origins.push_back({f, 0, false});
      soup.origin_offsets.push_back(f + 1);
      plc.facet_soup.push_back(f);
      plc.facet_soup_offsets.push_back(f + 1);
    }
    plc.curves = {{"F2.tip", "fault_tip"}};
    plc.segment_curves = {{0}};
    surfaces.resize(3);
    surfaces[0].name = "F2", surfaces[0].kind = SurfaceKind::fault;
    surfaces[1].name = "H1", surfaces[1].kind = SurfaceKind::horizon;
    surfaces[2].name = "xmin", surfaces[2].kind = SurfaceKind::box;
  }
  std::string words(const WorstElement& w, bool refined = true) const {
    return cause_in_words(w, refined, soup, plc, surfaces);
  }
};

}  // namespace

TEST_CASE("causes name what meets and at which angle", "[report]") {
  const NamedParts parts;
  WorstElement w;
  CHECK(parts.words(w) == "nothing in the input forces it");
  CHECK(parts.words(w, false).find("not refined") != std::string::npos);
  w.cause = ShapeCause::input_angle;
  w.forcing_angle = 3;
  w.facet_a = 0, w.facet_b = 1;
  CHECK(parts.words(w) == "input angle of 3 degrees between fault F2 and horizon H1");
  w.facet_b = 0;
  CHECK(parts.words(w) == "input angle of 3 degrees between two parts of fault F2");
  w.facet_a = no_index, w.segment_a = 0, w.facet_b = 2;
  CHECK(parts.words(w) == "input angle of 3 degrees between curve F2.tip and box side xmin");
  WorstElement gap;
  gap.cause = ShapeCause::thin_gap;
  gap.gap = 0.25;
  gap.facet_a = 1, gap.facet_b = 2;
  CHECK(parts.words(gap) ==
        "gap of 0.25 between horizon H1 and box side xmin, thinner than a quarter of the requested size");
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
  report.stages = {{"read", 0.1, 0.1, 1000}, {"write", 0.2, 0.3, 2000, 3}};
  report.input_json = R"({"surfaces": 2})";
  report.core = &core;
  report.arrangement = &arrangement;
  report.mesh = &mesh;
  report.refinement = RefineStatistics{};
  report.quality = quality_of(mesh);
  report.warnings = {"something \xff not UTF-8"};
  report.files = {"model.vtu"};
  const json read = json::parse(to_json(report));
  CHECK(read["stages"][1]["name"] == "write");
  CHECK(read["stages"][0]["runs"] == 1);
  CHECK(read["stages"][1]["runs"] == 3);
  CHECK(read["refinement"]["runs"] == 1);
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
  CHECK(read["quality"]["whole"]["tetrahedra"] == mesh.tetrahedra.size());
  CHECK(read["quality"]["min_dihedral"] == read["quality"]["whole"]["min_dihedral"]["min"]);
  CHECK(read["quality"]["regions"].size() == mesh.regions.size());
  CHECK(read["quality"]["regions"][1]["name"] == "middle layer, which is long to name");
  CHECK(read["quality"]["worst"][1]["forced"] == true);
  CHECK(read["quality"]["worst"][1]["region"] == mesh.tet_region[1]);
  CHECK(read["refinement"]["points_inside"] == 0);

  const fs::path folder = fs::path(GEOMESH_BINARY_DIR) / "test-output";
  fs::create_directories(folder);
  Report empty;
  empty.command = "info";
  for (const Report* r : {&report, &empty}) {
    write_report(*r, folder / "report.json");
    const std::string command = std::string("timeout 60 /usr/bin/python3 ") + GEOMESH_SOURCE_DIR +
                                "/tests/geomodel/read_back.py schema " + GEOMESH_SOURCE_DIR +
                                "/docs/report.schema.json '" + (folder / "report.json").string() + "'";
    const int status = exit_code_of(command);
    if (status == no_reader || status == no_program) {
      WARN("skipped: schema check (python3-jsonschema is not installed)");
    } else {
      CHECK(status == 0);
    }
  }
}

TEST_CASE("Warnings that say one thing of many surfaces are one group", "[report]") {
  const std::vector<std::string> warnings{
      "basement falls into 2 regions: basement__1 (volume 1.9e+10), basement__2 (volume 8e+09)",
      "top.ts: the file says z is in ft; taken as m as the project says",
      "sand falls into 12 regions: sand__1 (volume 1), sand__2 (volume 2)",
      "base_sand.ts: the file says z is in ft; taken as m as the project says"};
  const std::vector<WarningGroup> groups = group_warnings(warnings);
  REQUIRE(groups.size() == 2);
  CHECK(groups[0].cause == "falls into ... regions");
  CHECK(warning_statement(groups[0].first) == "basement falls into 2 regions");
  CHECK(warning_statement(warnings[1]) == "top.ts: the file says z is in ft");
  CHECK(warning_statement("all is lost") == "all is lost");
  const std::string outside = "polyline W2: a length of 35 lies outside the box, near (1, 2, 3), and is left out";
  CHECK(warning_cause(outside) == "a length of ... lies outside the box near");  // and not "polyline W2"
  CHECK(warning_cause(outside) != warning_cause("polyline W2: repeats itself"));
  CHECK(warning_statement(outside) == "polyline W2: a length of 35 lies outside the box");
  CHECK(groups[0].count == 2);
  CHECK(groups[0].first == warnings[0]);
  CHECK(groups[1].cause == "the file says z is in ft");
  CHECK(groups[1].count == 2);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Real horizons with holes that stop short of the box: as they are, and completed by rule.
#include <catch2/catch.hpp>
#include <filesystem>

#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/build_model.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
namespace fs = std::filesystem;

namespace {

const Box3 whole_box{{548800, 7816600, -11010}, {552500, 7822000, -8400}};
const std::vector<std::string> column{"u1",          "horizon_0", "u2",          "horizon_60", "u3",
                                      "horizon_250", "u4",        "horizon_330", "u5"};

/// The four horizons, or nothing (said aloud) where the data are absent.
std::vector<TriangulatedSurface> read_horizons() {
  const fs::path file = fs::path(GEOMESH_SHARED_DATA) / "claudius" / "claudius_delaunay.ts";
  if (!fs::exists(file)) {
    WARN("skipped: " << file.string() << " is not there");
    return {};
  }
  std::vector<TriangulatedSurface> horizons = read_surface_file(file).surfaces;
  for (TriangulatedSurface& s : horizons) s.kind = SurfaceKind::horizon;
  return horizons;
}

struct Run {
  ModelMesh mesh;
  std::vector<std::string> notes, warnings;
};

/// The whole way from surfaces and rules to the named mesh.
Run mesh_by_rules(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules) {
  BuiltSurfaces built = build_surfaces(surfaces, rules);
  ArrangementOptions options;
  options.box = rules.box;
  const ArrangementResult arranged = arrange(built.surfaces, {}, {}, options);
  for (const TriangulatedSurface& side : arranged.box_sides) built.surfaces.push_back(side);
  const TrimmedSoup trimmed = trim_soup(arranged.soup, built.surfaces, built.rows, rules);
  CHECK(validate_soup(trimmed.soup).empty());
  const ModelPlc plc = make_plc(trimmed.soup, built.surfaces, {});
  const ConstrainedTetrahedralization mesh = tetrahedralize(plc.plc);
  Run run;
  run.notes = built.notes;
  run.notes.insert(run.notes.end(), trimmed.notes.begin(), trimmed.notes.end());
  run.warnings = built.warnings;
  NamingRules naming;
  naming.column = rules.column;
  run.mesh = name_model({mesh, trimmed.soup, plc, built.surfaces}, {}, naming, run.warnings);
  CHECK(validate_model_mesh(run.mesh) == std::vector<std::string>{});
  return run;
}

std::string all_text(const Run& run) {
  std::string text;
  for (const auto& line : run.notes) text += "note: " + line + "\n";
  for (const auto& line : run.warnings) text += "warning: " + line + "\n";
  for (const Region& r : run.mesh.regions) text += r.name + " " + std::to_string(r.volume) + "\n";
  return text;
}

double total_volume(const ModelMesh& mesh) {
  double volume = 0;
  for (const Region& r : mesh.regions) volume += r.volume;
  return volume;
}

}  // namespace

TEST_CASE("Claudius in its whole box, holes filled and horizons extended by rule, makes five units", "[sets]") {
  const auto horizons = read_horizons();
  if (horizons.empty()) return;
  ModelRules rules;
  rules.box = whole_box;
  rules.column = column;
  rules.on_crossing = OnCrossing::clip_older;
  rules.surfaces.resize(horizons.size());
  for (SurfaceRules& rule : rules.surfaces) {
    rule.extend = Extend::tangent;
    rule.fill_holes = std::numeric_limits<double>::infinity();
  }
  const Run run = mesh_by_rules(horizons, rules);
  INFO(all_text(run));
  const double box_volume = 3700.0 * 5400.0 * 2610.0;
  CHECK(total_volume(run.mesh) == Approx(box_volume).epsilon(1e-12));
  for (const char* unit : {"u1", "u2", "u3", "u4", "u5"}) {
    const auto n = std::count_if(run.mesh.regions.begin(), run.mesh.regions.end(),
                                 [&](const Region& r) { return r.unit == unit; });
    INFO(unit);
    CHECK(n >= 1);
  }
  // Nothing but the five units is there, and pieces apart from the main ones are small.
  double largest_sum = 0;
  for (const char* unit : {"u1", "u2", "u3", "u4", "u5"}) {
    double largest = 0;
    for (const Region& r : run.mesh.regions)
      if (r.unit == unit) largest = std::max(largest, r.volume);
    largest_sum += largest;
  }
  CHECK(largest_sum > 0.999 * box_volume);
}

TEST_CASE("Claudius in its whole box as it is: warnings tell holes, borders and the units that join", "[sets]") {
  const auto horizons = read_horizons();
  if (horizons.empty()) return;
  ModelRules rules;
  rules.box = whole_box;
  rules.column = column;
  const Run run = mesh_by_rules(horizons, rules);
  INFO(all_text(run));
  const auto told = [&](const char* horizon, const char* what) {
    return std::any_of(run.warnings.begin(), run.warnings.end(), [&](const std::string& w) {
      return w.find(horizon) != std::string::npos && w.find(what) != std::string::npos &&
             w.find("join") != std::string::npos;
    });
  };
  CHECK(told("horizon_60", "hole"));
  CHECK(told("horizon_250", "stops short"));
  CHECK(run.mesh.regions.size() == 1);
  CHECK(run.mesh.regions[0].name == "u1+u2+u3+u4+u5");
}

// SPDX-License-Identifier: GPL-3.0-or-later
// What the constants of recovery, refinement and improvement reach on models of the repository, against a stored table.
//
// Whoever changes one of them, or a rule that they steer, sees here what it costs: Steiner points, elements, bad cells,
// least angles. `scripts/constants-table` writes the table anew; its difference belongs into the commit.
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "corpus_models.hpp"
#include "corpus_run.hpp"
#include "geomesh/core/quality.hpp"
#include "geomesh/core/refine.hpp"
#include "needle_cad.hpp"
#include "refine_models.hpp"
#include "test_places.hpp"

using namespace geomesh;

namespace {

const char* const table_file = GEOMESH_SOURCE_DIR "/tests/core/constants/table.txt";

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::string points(std::size_t on_segments, std::size_t on_facets, std::size_t inside) {
  return std::to_string(on_segments) + " " + std::to_string(on_facets) + " " + std::to_string(inside);
}

struct RecoveryCase {
  std::string name;
  PiecewiseLinearComplex plc;
};

std::vector<RecoveryCase> recovery_cases() {
  std::vector<RecoveryCase> cases;
  for (const char* name : {"chazelle_4", "needle_bundle", "sheaf_1deg", "fan_of_segments", "pyramids_and_block_0.5",
                           "pinching_layers", "pinching_horizons", "hanging_facets", "well_among_points"})
    cases.push_back({name, test::corpus_model(name).make()});
  for (const unsigned seed : {0u, 3u, 4u})
    cases.push_back(
        {"needle_plate_" + std::to_string(seed), test::needle_cad(seed, test::needle_cad_options(seed)).plc});
  return cases;
}

/// Steiner points by place, tetrahedra, facets given up.
void add_recovery(std::ostringstream& table) {
  table << "recovery: mode, model: Steiner points on segments, on facets, inside; tetrahedra; facets not Delaunay\n";
  const std::pair<const char*, TetrahedralizeOptions> modes[] = {{"constrained", test::constrained_mode()},
                                                                 {"preserving", test::preserving_mode()},
                                                                 {"conforming", test::conforming_mode()}};
  const std::vector<RecoveryCase> cases = recovery_cases();
  for (const auto& [mode, options] : modes)
    for (const RecoveryCase& c : cases) {
      if (std::string(mode) == "conforming" && c.name.starts_with("needle_plate")) continue;
      const ConstrainedTetrahedralization mesh = tetrahedralize(c.plc, options);
      const RecoveryStatistics& s = mesh.recovery;
      table << mode << ", " << c.name << ": " << points(s.steiner_on_segments, s.steiner_on_facets, s.steiner_inside)
            << "; " << mesh.tetrahedra.size() << "; " << s.facets_not_recovered.size() << "\n";
    }
}

struct RefinementCase {
  const char* name;
  refine_models::Model model;
  double size;
  double tolerance = 0;
};

std::vector<RefinementCase> refinement_cases() {
  using namespace refine_models;
  return {{"two_boxes", two_boxes(3), 0.15},
          {"ball_in_box", ball_in_box(5), 0.5},
          {"ball_in_box, tolerance 0.05", ball_in_box(5), 0.5, 0.05},
          {"box_with_well", box_with_well(4), 0.15},
          {"box_with_ridge", box_with_ridge(0.5), 0.6}};
}

/// Elements, points by place, elements below 8 degrees, least and mean least dihedral angle.
void add_refinement(std::ostringstream& table) {
  table << "refinement: level, model: elements; points on curves, on surfaces, inside; below 8 degrees; least angle; "
           "mean\n";
  const std::pair<const char*, QualityLevel> levels[] = {
      {"fast", QualityLevel::fast}, {"default", QualityLevel::standard}, {"best", QualityLevel::best}};
  for (const auto& [level, quality] : levels)
    for (const RefinementCase& c : refinement_cases()) {
      RefineOptions options;
      options.size.global = c.size;
      options.quality = quality;
      if (c.tolerance > 0) {
        options.honour = Honour::tolerance;
        options.tolerance = c.tolerance;
      }
      const RefineResult r = refine_and_improve(c.model.plc, c.model.mesh, options);
      const MeshQuality q = measure_quality(c.model.plc, r.mesh);
      const RefineStatistics& s = r.statistics;
      table << level << ", " << c.name << ": " << r.mesh.tetrahedra.size() << "; "
            << points(s.points_on_curves, s.points_on_surfaces, s.points_inside) << "; " << q.n_bad << "; "
            << number(q.whole.min_dihedral.min) << "; " << number(q.whole.min_dihedral.mean) << "\n";
    }
}

std::vector<std::string> lines_of(std::istream& in) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("The constants of recovery, refinement and improvement reach what their stored table says", "[constants]") {
  std::ostringstream table;
  add_recovery(table);
  add_refinement(table);
  if (std::getenv("GEOMESH_REWRITE_TABLES")) {
    std::ofstream(table_file) << table.str();
    WARN("written anew: " << table_file);
    return;
  }
  std::ifstream stored_file(table_file);
  REQUIRE(stored_file);
  const std::vector<std::string> stored = lines_of(stored_file);
  std::istringstream found_text(table.str());
  const std::vector<std::string> found = lines_of(found_text);
  INFO(
      "another result is no fault by itself: scripts/constants-table writes the table anew, and git diff shows the "
      "cost");
  REQUIRE(found.size() == stored.size());
  for (std::size_t k = 0; k < found.size(); ++k) CHECK(found[k] == stored[k]);
}

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The report: what was understood, done, measured and warned of. JSON by docs/report.schema.json.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geomesh/core/quality.hpp"
#include "geomesh/core/refine.hpp"
#include "geomesh/core/short_edges.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/core/voronoi_dual.hpp"
#include "geomesh/geomodel/arrangement.hpp"
#include "geomesh/geomodel/build_model.hpp"
#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "geomesh/geomodel/solver_verdict.hpp"
#include "geomesh/geomodel/stack.hpp"
#include "geomesh/geomodel/tolerance_ledger.hpp"
#include "geomesh/geomodel/tops.hpp"

namespace geomesh::geomodel {

struct StageRecord {
  std::string name;
  double wall_s = 0, cpu_s = 0;  ///< cpu counts all threads
  std::size_t peak_bytes = 0;    ///< peak resident size of the process at the stage's end
  std::size_t runs =
      1;  ///< how often it ran: refine and improve more than once where surfaces had to be held more closely
};

/// Element quality with the worst elements' causes in words.
struct QualityReport {
  MeshQuality measured;             ///< parted by region: row is region id - 1
  std::vector<std::string> causes;  ///< per row of measured.worst
  bool has_sizes = false;           ///< edge lengths were held against the asked sizes
  ShortEdges short_edges{};         ///< below a third of the asked size; of none where there are no sizes
};
/// "input angle of 3 degrees between fault F2 and horizon H1".
std::string cause_in_words(const WorstElement& worst, bool refined, const PolygonSoup& soup, const ModelPlc& plc,
                           const std::vector<TriangulatedSurface>& surfaces);

/// Everything a report may hold; what a command did not do stays empty and is left out.
struct Report {
  std::string command;  ///< "project", "mesh", "delaunay", "check", "info"
  std::string name;
  std::vector<StageRecord> stages;
  std::string input_json;  ///< the input as understood, a JSON object in text ("" if none)
  const ConstrainedTetrahedralization* core = nullptr;
  const ArrangementResult* arrangement = nullptr;
  const ToleranceLedger* tolerance = nullptr;
  const ModelMesh* mesh = nullptr;
  const SettledStack* stack = nullptr;            ///< where the stack was settled
  std::span<const ContinuedSurface> continued{};  ///< surfaces that were continued to what bounds them
  std::vector<std::string>
      surface_names;            ///< input surfaces, then box sides, for areas and spots; empty: those of `mesh`
  std::vector<FittedTop> tops;  ///< of wells, with their misfits
  std::optional<RefineStatistics> refinement;
  std::optional<QualityReport> quality;
  std::optional<SolverVerdict> solver;
  std::string model_verdict;                ///< whether units have regions, and how many warnings; of projects
  std::optional<VoronoiDual> voronoi_dual;  ///< in conforming mode
  std::vector<std::string> notes;           ///< what was found before meshing and what rules changed, with areas
  std::vector<std::string> warnings;
  std::vector<std::string> files;  ///< written, relative to the report
};
std::string to_json(const Report& report);
void write_report(const Report& report, const std::filesystem::path& file);

/// The report as one web page that needs no other file: a turnable picture of the units, sections, tables, histograms,
/// warnings. It holds the stages' times, so it differs from run to run as the JSON does. Size and time linear in the
/// mesh.
std::string to_html(const Report& report);
void write_html_report(const Report& report, const std::filesystem::path& file);

}  // namespace geomesh::geomodel

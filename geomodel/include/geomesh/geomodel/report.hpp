// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The report on a run: how the input was interpreted, what was done and measured, and the warnings. Its JSON follows
/// docs/report.schema.json.
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
  double wall_s = 0, cpu_s = 0;  ///< wall time and CPU time of a stage; CPU time is the sum over all threads
  std::size_t peak_bytes = 0;    ///< peak resident memory of the process at the end of the stage, in bytes
  std::size_t runs =
      1;  ///< Number of runs of the stage. Refinement and improvement run again if surfaces must be kept more closely.
};

/// Element quality, with descriptions of why the worst elements are bad.
struct QualityReport {
  MeshQuality measured;             ///< element quality by region; the row is the region's id - 1
  std::vector<std::string> causes;  ///< description of the cause for each of the worst elements (measured.worst)
  bool has_sizes = false;           ///< whether edge lengths were compared with target sizes
  /// Number and worst of the edges shorter than a third of the target size; not filled if target sizes are not known.
  ShortEdges short_edges{};
};
/// Describes in words why an element is bad, for example "input angle of 3 degrees between fault F2 and horizon H1".
std::string cause_in_words(const WorstElement& worst, bool refined, const PolygonSoup& soup, const ModelPlc& plc,
                           const std::vector<TriangulatedSurface>& surfaces);

/// Contents of a report. Parts that a command does not produce are empty and are omitted.
struct Report {
  std::string command;  ///< command that made the report: "project", "mesh", "delaunay", "check", "info"
  std::string name;
  std::vector<StageRecord> stages;
  std::string input_json;  ///< the input as the program interpreted it, as the text of a JSON object ("" if none)
  const ConstrainedTetrahedralization* core = nullptr;
  const ArrangementResult* arrangement = nullptr;
  const ToleranceLedger* tolerance = nullptr;
  const ModelMesh* mesh = nullptr;
  const SettledStack* stack = nullptr;  ///< horizons after they were put in depositional order; null if they were not
  std::span<const ContinuedSurface> continued{};  ///< surfaces that were continued to the surfaces that bound them
  std::vector<std::string>
      /// Names of the input surfaces followed by the sides of the box, for areas and places in the report; if empty,
      /// the names of `mesh` are used.
      surface_names;
  std::vector<FittedTop> tops;  ///< well tops, with the misfits of their horizons
  std::optional<RefineStatistics> refinement;
  std::optional<QualityReport> quality;
  std::optional<SolverVerdict> solver;
  /// For projects: a sentence that says whether all units have regions, and the number of warnings.
  std::string model_verdict;
  std::optional<VoronoiDual> voronoi_dual;  ///< in conforming mode
  std::vector<std::string> notes;  ///< notes on what was found before meshing, and on changes by rules, with areas
  std::vector<std::string> warnings;
  std::vector<std::string> files;  ///< paths of the written files, relative to the report
};
std::string to_json(const Report& report);
void write_report(const Report& report, const std::filesystem::path& file);

/// Returns the report as one self-contained web page: a rotatable picture of the units, sections, tables, histograms,
/// warnings. It includes the run times of stages, so like the JSON it differs from run to run. Size and time are linear
/// in the mesh.
std::string to_html(const Report& report);
void write_html_report(const Report& report, const std::filesystem::path& file);

}  // namespace geomesh::geomodel

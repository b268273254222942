// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The report: how the input was interpreted, what was done and measured, and the warnings. JSON according to
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
  double wall_s = 0, cpu_s = 0;  ///< wall time and CPU time; CPU time is the sum over all threads
  std::size_t peak_bytes = 0;    ///< peak resident memory of the process at the end of the stage, in bytes
  std::size_t runs =
      1;  ///< number of runs of the stage: refine and improve run again if surfaces must be kept more closely
};

/// Element quality, with descriptions of why the worst elements are bad.
struct QualityReport {
  MeshQuality measured;             ///< quality by region; the row is the region's id - 1
  std::vector<std::string> causes;  ///< description of the cause for each row of measured.worst
  bool has_sizes = false;           ///< whether edge lengths were compared with target sizes
  ShortEdges short_edges{};         ///< edges shorter than a third of the target size; not filled if there are no sizes
};
/// Describes a cause, for example "input angle of 3 degrees between fault F2 and horizon H1".
std::string cause_in_words(const WorstElement& worst, bool refined, const PolygonSoup& soup, const ModelPlc& plc,
                           const std::vector<TriangulatedSurface>& surfaces);

/// Everything that a report can contain. Parts that a command does not produce are empty and are omitted.
struct Report {
  std::string command;  ///< command that made the report: "project", "mesh", "delaunay", "check", "info"
  std::string name;
  std::vector<StageRecord> stages;
  std::string input_json;  ///< the input as interpreted, as the text of a JSON object ("" if none)
  const ConstrainedTetrahedralization* core = nullptr;
  const ArrangementResult* arrangement = nullptr;
  const ToleranceLedger* tolerance = nullptr;
  const ModelMesh* mesh = nullptr;
  const SettledStack* stack = nullptr;            ///< the settled stack of horizons; null if nothing was settled
  std::span<const ContinuedSurface> continued{};  ///< surfaces that were continued to what bounds them
  std::vector<std::string>
      /// Names of input surfaces, then of box sides, for areas and spots; if empty, those of `mesh` are used.
      surface_names;
  std::vector<FittedTop> tops;  ///< tops of wells, with their misfits
  std::optional<RefineStatistics> refinement;
  std::optional<QualityReport> quality;
  std::optional<SolverVerdict> solver;
  std::string model_verdict;  ///< for projects: whether all units have regions, and the number of warnings
  std::optional<VoronoiDual> voronoi_dual;  ///< in conforming mode
  std::vector<std::string> notes;           ///< findings before meshing, and changes by rules with their areas
  std::vector<std::string> warnings;
  std::vector<std::string> files;  ///< paths of written files, relative to the report
};
std::string to_json(const Report& report);
void write_report(const Report& report, const std::filesystem::path& file);

/// Returns the report as one self-contained web page: a rotatable picture of the units, sections, tables, histograms,
/// warnings. It includes the run times of stages, so like the JSON it differs from run to run. Size and time are linear
/// in the mesh.
std::string to_html(const Report& report);
void write_html_report(const Report& report, const std::filesystem::path& file);

}  // namespace geomesh::geomodel

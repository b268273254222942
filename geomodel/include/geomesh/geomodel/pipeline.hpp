// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The complete jobs behind the command line: each is one function that turns a request into written files. They follow
/// the flow of docs/architecture.md: read, build, intersect, [core: delaunay, recover, classify, refine, improve],
/// verify, write.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/arrangement.hpp"
#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/project.hpp"
#include "geomesh/geomodel/refinement.hpp"

namespace geomesh::geomodel {

/// Outcome of a job of the command line: the written files and a summary.
struct JobResult {
  std::vector<std::filesystem::path> files;  ///< paths of the written files in order; the report is the last one
  std::vector<std::string> warnings;
  /// About ten lines on the mesh for a person: counts, units with volumes, and the verdict.
  std::vector<std::string> summary;
  /// Further lines on the mesh: every region, element shapes, and what would make solvers fail.
  std::vector<std::string> details;
  ModelMesh mesh;           ///< the verified mesh, for runs of `project` and `mesh` that reached the end
  std::string report_json;  ///< the report as text, for runs of `project` and `mesh` that reached the end
};

/// Names of the stages that `--stop-after` accepts, in order.
const std::vector<std::string>& stage_names();

struct ProjectRequest {
  Project project;
  /// Makes a coarse mesh in seconds, with preview_settings() in place of the project's mesh settings.
  bool preview = false;
  std::optional<std::filesystem::path> directory;  ///< output directory, which overrides the project's output.directory
  std::optional<std::filesystem::path> report;     ///< path to which a second copy of the report is written
  std::string stop_after;                          ///< stage after which the run stops; if empty, it runs to the end
  /// Whether the command writes its output files (`written`) or only returns its results (`kept`). With `kept`,
  /// `directory` and `report` are ignored.
  enum class Outputs { written, kept } outputs = Outputs::written;
};
/// Runs `geomesh PROJECT.yaml`. Throws as the functions that it calls; nothing is written before the mesh has been
/// verified.
JobResult run_project(const ProjectRequest& request, const RunContext& context);

struct MeshRequest {
  std::vector<std::filesystem::path> inputs;
  /// Path of the output. For .vtu, all four files with its stem are written; for other extensions, only this file.
  std::filesystem::path output;
  TetrahedralizeOptions options;
  RefinementSettings refinement;
  enum class Intersect { automatic, always, never } intersect = Intersect::automatic;
  bool keep_hull = false;
  double tolerance = 0;  ///< as ArrangementOptions::tolerance
  std::optional<Box3> box;
  std::optional<std::filesystem::path> report;
  std::string stop_after;
};
/// `geomesh mesh`.
JobResult run_mesh(const MeshRequest& request, const RunContext& context);

struct DelaunayRequest {
  std::filesystem::path points;
  std::filesystem::path output;
  DelaunayOptions options;
  std::optional<std::filesystem::path> report;
};
/// `geomesh delaunay`.
JobResult run_delaunay(const DelaunayRequest& request, const RunContext& context);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The whole jobs behind the command line: each is one function from a request to written files. They read as the flow
/// of docs/architecture.md: read, build, intersect, [core: delaunay, recover, classify, refine, improve], verify,
/// write.
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

/// What a job left behind.
struct JobResult {
  std::vector<std::filesystem::path> files;  ///< written, in order; the report last
  std::vector<std::string> warnings;
  std::vector<std::string> summary;  ///< about ten lines for a person: counts, units with volumes, the verdict
  std::vector<std::string> details;  ///< further lines: every region, shapes, what solvers would fail at
  ModelMesh mesh;                    ///< of project and mesh jobs that ran to the end: what was verified
  std::string report_json;           ///< of these: the report, as in the file
};

/// Names accepted by `--stop-after`, in order.
const std::vector<std::string>& stage_names();

struct ProjectRequest {
  Project project;
  bool preview = false;  ///< a coarse mesh in seconds, whatever the project asks of its mesh (preview_settings)
  std::optional<std::filesystem::path> directory;  ///< wins over the project's output.directory
  std::optional<std::filesystem::path> report;     ///< a further copy of the report
  std::string stop_after;                          ///< empty: run to the end
  /// `kept`: no file is written, and `directory` and `report` have no meaning.
  enum class Outputs { written, kept } outputs = Outputs::written;
};
/// `geomesh PROJECT.yaml`. Errors as the rooms it calls; nothing is written before the mesh has been verified.
JobResult run_project(const ProjectRequest& request, const RunContext& context);

struct MeshRequest {
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path output;  ///< .vtu: the four files with its stem; another known extension: that file alone
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

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What project and mesh jobs share from the soup on: mesh, name, verify, write.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/geomodel/build_model.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/pipeline.hpp"
#include "geomesh/geomodel/refinement.hpp"
#include "geomesh/geomodel/tops.hpp"
#include "geomesh/geomodel/write_options.hpp"
#include "pipeline/stage_recorder.hpp"
#include "pipeline/z_scale.hpp"

namespace geomesh::geomodel {

/// Everything known once the surfaces have been intersected.
struct PreparedModel {
  std::string command, name;
  std::vector<TriangulatedSurface> surfaces;  ///< input surfaces followed by the box sides
  std::vector<NamedPoint> points;
  std::vector<FittedTop> tops;  ///< of wells
  ArrangementResult arrangement;
  ModelPlc plc;
  NamingRules naming;
  TetrahedralizeOptions options;
  RefinementSettings refinement;
  Vec3 origin{0, 0, 0};
  std::string system = "local", unit = "m";  ///< of the mesh, for the report
  ZScale z_scale{1};  ///< of everything but naming.seeds, from after `build` until the mesh is named
  ModelRules rules;
  SettledStack stack;                       ///< as stage build settled it
  std::vector<ContinuedSurface> continued;  ///< by stage build
  ModelVolume volume;
  BuiltRows built_rows;  ///< which triangles of the input surfaces rules made
  double sparse_growth = 0, sparse_ratio = 10, sparse_surfaces = 1;  ///< RefineOptions
  std::string input_json;
  std::vector<std::string> notes;  ///< what was found before meshing and what rules changed
  std::vector<std::string> warnings;
  std::vector<std::string> doubted;  ///< inputs that a warning before the work was about: not warned of for this again
};

struct OutputPlan {
  std::filesystem::path stem;        ///< without extension
  std::vector<std::string> formats;  ///< as known_formats()
  WriteOptions options;
  bool report_beside = true;  ///< STEM.report.json
  std::optional<std::filesystem::path> report_copy;
};

/// Runs `prepare` (stages read, build, intersect: fills the model), then the stages delaunay to write. With a stage to
/// stop after, ends there with the report, and after `intersect` with the soup and its offending spots for viewing.
/// Nothing is written where verification finds a fault (InternalError) or an error is thrown.
JobResult run_stages(PreparedModel& model, const OutputPlan& plan, StageRecorder& recorder,
                     const std::function<void()>& prepare);

/// What was meshed, named and verified, and is not written. `refined.mesh` has the tetrahedra of `mesh`, in the
/// same order.
struct VerifiedModel {
  RefineResult refined;
  ModelMesh mesh;
};
/// The stages delaunay to verify, of a model that stage intersect has left. Errors as run_stages.
VerifiedModel mesh_and_verify(PreparedModel& model, StageRecorder& recorder);

/// Collects what a rule changed and passes it on to the log.
void note(std::vector<std::string>& notes, const RunContext& context, std::string text);

/// Collects a warning and passes it on to the log at once.
void warn(std::vector<std::string>& warnings, const RunContext& context, std::string text);

}  // namespace geomesh::geomodel

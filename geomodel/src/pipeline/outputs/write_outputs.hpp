// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines and writes the files of a run.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/geomodel/pipeline.hpp"
#include "geomesh/geomodel/report.hpp"
#include "geomesh/geomodel/write_options.hpp"
#include "pipeline/journal.hpp"
#include "pipeline/stage_recorder.hpp"

namespace geomesh::geomodel {

struct OutputPlan {
  std::filesystem::path stem;        ///< without extension
  std::vector<std::string> formats;  ///< as known_formats()
  WriteOptions options;
  bool report_beside = true;  ///< STEM.report.json
  std::optional<std::filesystem::path> report_copy;
};

/// Throws if an output folder is not writable. Called before anything is computed, so that the error appears early.
void require_writable_outputs(const OutputPlan& plan);

void make_output_folder(const OutputPlan& plan);

/// Runs the stage write: writes the mesh in all formats except the HTML page, which is written with the report.
std::vector<std::filesystem::path> write_mesh(const OutputPlan& plan, const ModelMesh& mesh, const RunContext& context);

/// Writes the HTML page, STEM.report.json and a requested second copy of the report. Completes report and result.
void write_reports(const OutputPlan& plan, Report& report, const StageRecorder& recorder, const Journal& journal,
                   JobResult& result);

}  // namespace geomesh::geomodel

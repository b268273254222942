// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The files of a run: which, and their writing.
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

/// Before anything is computed: folders that cannot be written to are found out now.
void require_writable_outputs(const OutputPlan& plan);

void make_output_folder(const OutputPlan& plan);

/// Stage write: the mesh in each format but the page, which comes with the report. Returns the files.
std::vector<std::filesystem::path> write_mesh(const OutputPlan& plan, const ModelMesh& mesh, const RunContext& context);

/// The page, STEM.report.json and the further copy that was asked for. Completes the report and the result.
void write_reports(const OutputPlan& plan, Report& report, const StageRecorder& recorder, const Journal& journal,
                   JobResult& result);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/outputs/write_outputs.hpp"

#include <algorithm>

#include "geomesh/geomodel/formats.hpp"
#include "geomesh/geomodel/writers.hpp"

namespace geomesh::geomodel {

void require_writable_outputs(const OutputPlan& plan) {
  for (const std::string& format : plan.formats) {
    const Format* const known = format_of_name(format);
    const std::filesystem::path file = plan.stem.string() + (known ? known->extensions.front() : ".html");
    require_writable(format == "openfoam" ? file / "mesh.json" : file);
    if (plan.report_copy && std::filesystem::absolute(*plan.report_copy).lexically_normal() ==
                                std::filesystem::absolute(file).lexically_normal())
      throw Error(ErrorKind::usage,
                  "--report " + file.string() + " is the mesh file's own name; give the report another");
  }
  if (plan.report_beside) require_writable(plan.stem.string() + ".report.json");
  if (plan.report_copy) require_writable(*plan.report_copy);
}

void make_output_folder(const OutputPlan& plan) {
  if (!plan.stem.parent_path().empty()) std::filesystem::create_directories(plan.stem.parent_path());
}

std::vector<std::filesystem::path> write_mesh(const OutputPlan& plan, const ModelMesh& mesh,
                                              const RunContext& context) {
  const StageScope stage(context, "write");
  make_output_folder(plan);
  std::vector<std::filesystem::path> files;
  std::size_t n_formats_done = 0;
  for (const std::string& format : plan.formats) {
    context.report(mesh.tetrahedra.size() * n_formats_done++, mesh.tetrahedra.size() * plan.formats.size());
    if (format == "html") continue;
    for (auto& file : write_format(mesh, format, plan.stem, plan.options)) files.push_back(std::move(file));
  }
  context.note(LogLevel::info,
               std::to_string(plan.formats.size()) + (plan.formats.size() == 1 ? " format" : " formats"));
  return files;
}

void write_reports(const OutputPlan& plan, Report& report, const StageRecorder& recorder, const Journal& journal,
                   JobResult& result) {
  for (const auto& file : result.files) report.files.push_back(file.filename().string());
  report.stages = recorder.records();
  report.notes = journal.notes();
  report.warnings = journal.warnings();
  result.warnings = journal.warnings();
  if (std::find(plan.formats.begin(), plan.formats.end(), "html") != plan.formats.end()) {
    const std::filesystem::path file = plan.stem.string() + ".html";
    report.files.push_back(file.filename().string());
    write_html_report(report, file);
    result.files.push_back(file);
  }
  result.report_json = to_json(report);
  if (plan.report_beside) {
    const std::filesystem::path file = plan.stem.string() + ".report.json";
    write_text_file(file, result.report_json);
    result.files.push_back(file);
  }
  if (plan.report_copy) {
    write_text_file(*plan.report_copy, result.report_json);
    result.files.push_back(*plan.report_copy);
  }
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the commands that make meshes, declared in geomesh/geomodel/pipeline.hpp.
#include "geomesh/geomodel/formats.hpp"
#include "geomesh/geomodel/pipeline.hpp"
#include "pipeline/jobs/run_stages.hpp"

namespace geomesh::geomodel {

const std::vector<std::string>& stage_names() {
  static const std::vector<std::string> names{"read",     "build",  "intersect", "delaunay", "recover", "classify",
                                              "estimate", "refine", "improve",   "verify",   "write"};
  return names;
}

static Project preview_of(Project project) {
  project.mesh.refinement = preview_settings();
  project.mesh.options.recover.mode = MeshMode::constrained;
  project.mesh.options.recover.preserve_boundary = false;
  return project;
}

JobResult run_project(const ProjectRequest& request, const RunContext& context) {
  const Project project = request.preview ? preview_of(request.project) : request.project;
  StageRecorder recorder(context, request.stop_after);
  OutputPlan plan;
  if (request.outputs == ProjectRequest::Outputs::written) {
    plan.stem = request.directory.value_or(project.output.directory) / project.name;
    plan.formats = project.output.formats;
    plan.options = project.output.options;
    plan.report_copy = request.report;
  } else {
    plan.report_beside = false;
  }
  return run_stages(plan, recorder, [&](Journal& journal) { return read_project_model(project, journal); });
}

JobResult run_mesh(const MeshRequest& request, const RunContext& context) {
  StageRecorder recorder(context, request.stop_after);
  OutputPlan plan;
  plan.stem = request.output.parent_path() / request.output.stem();
  plan.formats = {format_name_of(request.output)};
  plan.report_beside = plan.formats.front() == "vtu";
  plan.report_copy = request.report;
  return run_stages(plan, recorder, [&](Journal& journal) { return read_mesh_model(request, journal); });
}

}  // namespace geomesh::geomodel

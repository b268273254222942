// SPDX-License-Identifier: GPL-3.0-or-later
// Measures element shapes and checks solver limits and missing units, declared in pipeline/stages/stages.hpp.
#include <algorithm>

#include "pipeline/stages/stages.hpp"
#include "report/model_verdict.hpp"
#include "solver_verdict/velocities.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns the units of the stratigraphic column that the model may contain: below its topography and above its base.
std::vector<std::string> column_inside(const NamingRules& naming) {
  std::vector<std::string> column = naming.column;
  const auto bottom = std::find(column.begin(), column.end(), naming.floor);
  if (bottom != column.end()) column.erase(bottom, column.end());
  const auto top = std::find(column.begin(), column.end(), naming.topography);
  if (top != column.end()) column.erase(column.begin(), top + 1);
  return column;
}

}  // namespace

QualityReport judge_quality(const ModelRecords& model, const Meshed& meshed, const ModelMesh& mesh, unsigned threads) {
  const ConstrainedTetrahedralization& core = meshed.refined.mesh;
  const PiecewiseLinearComplex& plc = model.arranged.plc.plc;
  const bool refined = meshed.used.refine;
  const SizeField* const size = refined ? &meshed.refined.size_field : nullptr;
  constexpr std::size_t n_listed = 10;
  QualityOptions options;
  options.min_worst = n_listed;
  options.size = size;
  options.threads = threads;
  if (refined) {
    options.asked = &meshed.refined.asked;
    options.facet_patch = meshed.refined.kept_patch;
    options.tolerance = meshed.used.tolerance.left();
    options.tolerance_share = meshed.used.tolerance.left_share();
  }
  for (const std::int32_t region : mesh.tet_region) options.group.push_back(static_cast<Index>(region - 1));
  options.n_groups = mesh.regions.size();
  QualityReport report{measure_quality(plc, core, options), {}, size != nullptr};
  if (size) report.short_edges = find_short_edges(plc, core, options);
  for (const WorstElement& w : report.measured.worst)
    report.causes.push_back(
        cause_in_words(w, refined, model.arranged.arrangement.soup, model.arranged.plc, model.arranged.surfaces));
  return report;
}

SolverVerdict judge_solvers(const Meshed& meshed, const ModelMesh& mesh, unsigned threads) {
  const ConstrainedTetrahedralization& core = meshed.refined.mesh;
  const SizeField* const size = meshed.used.refine ? &meshed.refined.size_field : nullptr;
  const std::vector<double> velocity = velocity_by_region(mesh);
  MeshForSolver judged{.points = mesh.points, .tetrahedra = mesh.tetrahedra, .threads = threads};
  judged.velocity = [&](std::size_t t) { return velocity[static_cast<std::size_t>(mesh.tet_region[t] - 1)]; };
  if (size && size->limits().background) judged.threads = 1;  // sizes from a background file need a single thread
  if (size) judged.largest_size = std::min(size->limits().global, size->limits().max_size);
  constexpr double nothing_asked = 0;  // fault zones have no target size
  if (size)
    judged.size = [&](std::size_t t, const Vec3& p, double enough) {
      return t < core.component.size() ? size->at_unless_below(enough, p, core.component[t]) : nothing_asked;
    };
  return judge_for_solvers(judged);
}

std::vector<FittedTop> measure_tops(std::vector<FittedTop> tops, const ModelMesh& mesh) {
  for (FittedTop& top : tops) {
    std::vector<Triangle> faces;
    for (const ModelMesh::Face& face : mesh.faces)
      for (const std::int32_t id : mesh.surface_sets[static_cast<std::size_t>(face.surface_set)])
        for (const NamedSurface& s : mesh.surfaces)
          if (s.id == id && s.name == top.horizon) faces.push_back(face.vertices);
    top.misfit_meshed = misfit_of(top.place, mesh.points, faces);
  }
  return tops;
}

std::string judge_model(const ModelRecords& model, const ModelMesh& mesh, Journal& journal) {
  if (model.inputs.command != "project") return "";
  const NamingRules& naming = model.built.naming;
  const std::vector<std::string> column = column_inside(naming);
  const std::vector<MissingUnit> missing = missing_units(column, mesh);
  std::size_t n_eroded = 0;  // number of the youngest missing units, which the topography may have removed
  while (!naming.topography.empty() && n_eroded < missing.size() && missing[n_eroded].name == column[2 * n_eroded])
    ++n_eroded;
  const std::vector<MissingUnit> lost(missing.begin() + static_cast<std::ptrdiff_t>(n_eroded), missing.end());
  if (!lost.empty()) journal.warn(describe_missing(lost, (column.size() + 1) / 2));
  return model_verdict(missing, column, journal.warnings().size());
}

}  // namespace geomesh::geomodel

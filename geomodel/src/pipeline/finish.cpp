// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/finish.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "fault_zones/project_zones.hpp"
#include "geomesh/geomodel/formats.hpp"
#include "geomesh/geomodel/model_error.hpp"
#include "geomesh/geomodel/report.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "naming/name_regions.hpp"
#include "pipeline/failed_place.hpp"
#include "pipeline/refine_model.hpp"
#include "pipeline/region_volumes.hpp"
#include "pipeline/soup_vtp.hpp"
#include "pipeline/summary.hpp"
#include "pipeline/target_elements.hpp"
#include "report/model_verdict.hpp"
#include "rules/order/laid_down.hpp"
#include "solver_mesh/corners/divide_tetrahedra.hpp"
#include "solver_mesh/corners/free_corners.hpp"
#include "solver_mesh/curved_edges.hpp"
#include "solver_verdict/velocities.hpp"

namespace geomesh::geomodel {
namespace {

std::string count_words(std::size_t n, const char* what) { return std::to_string(n) + " " + what; }

ConstrainedTetrahedralization mesh_core(PreparedModel& model, StageRecorder& recorder) {
  ConstrainedTetrahedralization core = tetrahedralize(model.plc.plc, model.options, recorder.context());
  if (core.tetrahedra.empty()) {
    throw Error(ErrorKind::cannot_mesh,
                "the surfaces enclose nothing: there is no region to mesh. Close the surfaces, add a box (--box "
                "x0,y0,z0,x1,y1,z1), or keep the convex hull (--hull)");
  }
  return core;
}

/// The surfaces that these facets stand for, in the order of the project.
std::string surfaces_of(const std::vector<Index>& facets, const PreparedModel& model) {
  std::vector<Index> surfaces;
  const PiecewiseLinearComplex& plc = model.plc.plc;
  for (const Index f : facets)
    if (const Index set = plc.facet_provenance[f]; set != no_index)
      surfaces.insert(surfaces.end(), plc.provenance_sets[set].begin(), plc.provenance_sets[set].end());
  std::sort(surfaces.begin(), surfaces.end());
  surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  std::string out;
  for (const Index s : surfaces) out += (out.empty() ? "" : ", ") + model.surfaces[s].name;
  return out;
}

/// Without what lies above the topography or below the floor, where the model has them.
void cut_at_ends(ConstrainedTetrahedralization& core, PreparedModel& model, StageRecorder& recorder) {
  if (!core.recovery.facets_not_recovered.empty())
    warn(model.warnings, recorder.context(),
         count_words(core.recovery.facets_not_recovered.size(),
                     "facets are in the mesh but not Delaunay: small angles between surfaces would need more points "
                     "than the budget (") +
             surfaces_of(core.recovery.facets_not_recovered, model) +
             "; the report lists them in recovery.facets_not_recovered)");
  std::vector<std::string> warnings;
  core = within_ends(std::move(core), model.arrangement.soup, model.plc, model.surfaces, model.naming, warnings);
  for (std::string& text : warnings) warn(model.warnings, recorder.context(), std::move(text));
  model.naming.topography.clear();  // what lies beyond is gone
  model.naming.floor.clear();
}

/// The options of refinement, once the number of elements that they ask for is told.
CountedOptions counted_options(PreparedModel& model, const ConstrainedTetrahedralization& mesh,
                               const RunContext& context) {
  const StageScope stage(context, "estimate");
  CountedOptions counted = with_derived_size(model, mesh, refine_options(model, mesh));
  announce_count(model, counted, context);
  return counted;
}

/// The mesh, refined where that is asked for. In conforming mode the whole is refined, since Delaunay is a matter of
/// the whole; else what is kept.
RefineResult mesh_to_size(PreparedModel& model, StageRecorder& recorder, std::vector<double>& volumes_of_input) {
  RefineResult result;
  result.mesh = mesh_core(model, recorder);
  const bool refine = model.refinement.refine, conforming = model.options.recover.mode == MeshMode::conforming;
  const auto refine_now = [&] {
    if (model.refinement.target_elements > 0) {
      result = refine_to_count(model, result.mesh, refine_options(model, result.mesh), recorder.context());
      return;
    }
    const CountedOptions counted = counted_options(model, result.mesh, recorder.context());
    result = refine_model(model, std::move(result.mesh), counted.options, recorder.context());
  };
  if (refine && conforming) refine_now();
  cut_at_ends(result.mesh, model, recorder);
  if (!refine || conforming) return result;
  if (model.refinement.honour == Honour::tolerance) volumes_of_input = component_volumes(result.mesh);
  refine_now();
  return result;
}

/// What follows (naming, verification, writing) is in true heights.
void undo_z_scale(PreparedModel& model, ConstrainedTetrahedralization& core) {
  const ZScale& scale = model.z_scale;
  if (scale.factor() == 1) return;
  char text[32];
  std::snprintf(text, sizeof text, "%g", scale.factor());
  scale.undo(core.points);
  scale.undo(model.arrangement.soup.points);
  scale.undo(model.plc.plc.points);
  for (TriangulatedSurface& surface : model.surfaces) scale.undo(surface.points);
  for (NamedPoint& p : model.points) scale.undo(p.point);
  model.notes.push_back(std::string("z was scaled by ") + text +
                        " while meshing; lengths and areas of clipping and rounding are those of the scaled model");
}

/// What a run promises of its mesh, before anything is written.
void require_valid(const ModelMesh& mesh, const PreparedModel& model, unsigned threads) {
  const std::vector<std::string> faults = validate_model_mesh(mesh, threads);
  if (!faults.empty() && !model.z_scale.is_exact())
    throw Error(
        ErrorKind::cannot_mesh,
        "crs.z_scale is no power of two, so that undoing it rounds, and here a tetrahedron does not bear that: " +
            faults.front() + "; take a power of two (2, 4, 8, 16 ...), which is undone exactly");
  if (faults.empty()) return;
  std::string all =
      "the finished mesh does not hold what it must, so nothing was written (a bug of geomesh; please report it):";
  for (const std::string& fault : faults) all += "\n  " + fault;
  throw InternalError(all);
}

/// By bringing surfaces together, by rounding, and within a tolerance.
double moved_at_most(const PreparedModel& model) {
  return model.refinement.tolerance.bound() + model.arrangement.rounding.largest;
}

ModelMesh name_and_verify(const ConstrainedTetrahedralization& core, std::vector<CellArray> arrays,
                          PreparedModel& model, const StageRecorder& recorder) {
  const std::size_t known = model.warnings.size();
  const NamingRules naming = with_heights(model.naming, model.surfaces, model.built_rows, model.rules);
  ModelMesh mesh = name_model({core, model.arrangement.soup, model.plc, model.surfaces, moved_at_most(model)},
                              model.points, naming, model.warnings, recorder.context().threads);
  for (std::size_t i = known; i < model.warnings.size(); ++i)
    recorder.context().note(LogLevel::warning, model.warnings[i]);
  mesh.name = model.name;
  mesh.origin = model.origin;
  mesh.cell_arrays = std::move(arrays);
  mesh.unit = model.unit;
  require_valid(mesh, model, recorder.context().threads);
  if (model.volume.volume > 0)
    require_volume_filled(mesh, model.volume.volume, !model.rules.topography.empty() || !model.rules.floor.empty());
  recorder.context().note(LogLevel::info,
                          count_words(mesh.tetrahedra.size(), "tetrahedra exactly positive and conforming"));
  return mesh;
}

/// Before anything is measured or reported: counts and shapes are then those of the mesh that is written.
void free_split_corners(ConstrainedTetrahedralization& core, const PreparedModel& model,
                        const std::vector<std::string>& split, unsigned threads) {
  if (split.empty()) return;
  std::vector<std::string> told_later;  // naming tells its warnings when the mesh is named for good
  const NamingRules naming = with_heights(model.naming, model.surfaces, model.built_rows, model.rules);
  const ModelMesh named = name_model({core, model.arrangement.soup, model.plc, model.surfaces, moved_at_most(model)},
                                     model.points, naming, told_later, threads);
  divide_tetrahedra(core, tetrahedra_on_surfaces(named, split));
}

/// `core` has the tetrahedra of `mesh`, in the same order; `refined` tells what the model was refined to, where it was.
QualityReport judge_quality(const ConstrainedTetrahedralization& core, const ModelMesh& mesh,
                            const PreparedModel& model, const RefineResult& refined, unsigned threads) {
  const SizeField* const size = model.refinement.refine ? &refined.size_field : nullptr;
  constexpr std::size_t n_listed = 10;
  QualityOptions options;
  options.min_worst = n_listed;
  options.size = size;
  options.threads = threads;
  if (model.refinement.refine) {
    options.asked = &refined.asked;
    options.facet_patch = refined.kept_patch;
    options.tolerance = model.refinement.tolerance.left();
    options.tolerance_share = model.refinement.tolerance.left_share();
  }
  for (const std::int32_t region : mesh.tet_region) options.group.push_back(static_cast<Index>(region - 1));
  options.n_groups = mesh.regions.size();
  QualityReport report{measure_quality(model.plc.plc, core, options), {}, size != nullptr};
  if (size) report.short_edges = find_short_edges(model.plc.plc, core, options);
  for (const WorstElement& w : report.measured.worst)
    report.causes.push_back(
        cause_in_words(w, model.refinement.refine, model.arrangement.soup, model.plc, model.surfaces));
  return report;
}

/// `core` has the tetrahedra of `mesh` but for those of fault zones, which come last, in the same order.
SolverVerdict judge_solvers(const ConstrainedTetrahedralization& core, const ModelMesh& mesh, const SizeField* size,
                            unsigned threads) {
  const std::vector<double> velocity = velocity_by_region(mesh);
  MeshForSolver judged{.points = mesh.points, .tetrahedra = mesh.tetrahedra, .threads = threads};
  judged.velocity = [&](std::size_t t) { return velocity[static_cast<std::size_t>(mesh.tet_region[t] - 1)]; };
  if (size && size->limits().background) judged.threads = 1;  // it is asked on one thread alone
  if (size) judged.largest_size = std::min(size->limits().global, size->limits().max_size);
  constexpr double nothing_asked = 0;  // of zones: any edge is longer
  if (size)
    judged.size = [&](std::size_t t, const Vec3& p, double enough) {
      return t < core.component.size() ? size->at_unless_below(enough, p, core.component[t]) : nothing_asked;
    };
  return judge_for_solvers(judged);
}

/// How far the mesh's horizons are off the tops of wells.
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

/// STEM.report.json and the further copy that was asked for.
void write_reports(const OutputPlan& plan, Report& report, const PreparedModel& model, const StageRecorder& recorder,
                   JobResult& result) {
  for (const auto& file : result.files) report.files.push_back(file.filename().string());
  report.stages = recorder.records();
  if (model.stack.settled) report.stack = &model.stack;
  report.continued = model.continued;
  report.notes = model.notes;
  report.warnings = model.warnings;
  result.warnings = model.warnings;
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

/// What remeshing moved: proven to be within what was left for it, so that nothing is taken.
ToleranceUse use_of(const RefineStatistics& statistics) {
  ToleranceUse use{"remeshing"};
  use.moved = std::max(statistics.deviation_result_to_input, statistics.deviation_input_to_result);
  return use;
}

Report begin_report(const PreparedModel& model) {
  Report report;
  report.command = model.command;
  report.name = model.name;
  report.input_json = model.input_json;
  report.arrangement = &model.arrangement;
  report.tolerance = &model.refinement.tolerance;
  return report;
}

/// Before anything is computed: folders that cannot be written to are found out now.
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

/// The units of the column that the model may hold: below its topography and above its bottom.
std::vector<std::string> column_inside(const NamingRules& naming) {
  std::vector<std::string> column = naming.column;
  const auto bottom = std::find(column.begin(), column.end(), naming.floor);
  if (bottom != column.end()) column.erase(bottom, column.end());
  const auto top = std::find(column.begin(), column.end(), naming.topography);
  if (top != column.end()) column.erase(column.begin(), top + 1);
  return column;
}

/// Units without a region are warned of; the verdict counts all warnings. Empty where no project says what is wanted.
std::string judge_model(PreparedModel& model, const ModelMesh& mesh, const RunContext& context) {
  if (model.command != "project") return "";
  const std::vector<std::string> column = column_inside(model.naming);
  const std::vector<MissingUnit> missing = missing_units(column, mesh);
  std::size_t n_eroded = 0;  // the youngest units, which a topography may have taken away
  while (!model.naming.topography.empty() && n_eroded < missing.size() &&
         missing[n_eroded].name == column[2 * n_eroded])
    ++n_eroded;
  const std::vector<MissingUnit> lost(missing.begin() + static_cast<std::ptrdiff_t>(n_eroded), missing.end());
  if (!lost.empty()) warn(model.warnings, context, describe_missing(lost, (column.size() + 1) / 2));
  return model_verdict(missing, column, model.warnings.size());
}

/// What of the stage `verify` is done once the mesh has been named and verified, and once its shapes have been
/// measured.
constexpr double verified_share = 0.65, measured_share = 0.9;

JobResult mesh_and_write(PreparedModel& model, const OutputPlan& plan, StageRecorder& recorder) {
  JobResult result;
  Report report = begin_report(model);
  WriteOptions options = plan.options;
  const std::vector<FaultZone> zones = std::exchange(options.fault_zones, {});
  const NamingRules zone_rules = take_zone_rules(model.naming, zones);
  std::vector<double> volumes_of_input;
  RefineResult refined = mesh_to_size(model, recorder, volumes_of_input);
  report.input_json = model.input_json;  // sizes may follow from a number of elements
  const bool refine = model.refinement.refine;
  if (refine) report.refinement = refined.statistics;
  if (model.refinement.tolerance.left() > 0) model.refinement.tolerance.take(use_of(refined.statistics));
  undo_z_scale(model, refined.mesh);
  free_split_corners(refined.mesh, model, options.split, recorder.context().threads);
  const ConstrainedTetrahedralization& core = refined.mesh;
  report.core = &core;
  const SizeField* const size = refine ? &refined.size_field : nullptr;
  ModelMesh mesh;
  {
    StageScope stage(recorder.context(), "verify");
    const std::size_t n = core.tetrahedra.size();
    const auto tell_share = [&](double share) {
      recorder.context().report(static_cast<std::size_t>(share * static_cast<double>(n)), n);
    };
    tell_share(0);
    mesh = name_and_verify(core, make_cell_arrays(model.refinement.cell_arrays, core, size), model, recorder);
    set_volumes_of_input(mesh, core, volumes_of_input);
    if (!volumes_of_input.empty()) require_volumes_within(mesh, model.refinement.tolerance.left());
    for (std::string& text : volume_changes(mesh, model.refinement.tolerance.left()))
      warn(model.warnings, recorder.context(), std::move(text));
    tell_share(verified_share);
    report.quality = judge_quality(core, mesh, model, refined, recorder.context().threads);
    tell_share(measured_share);
    if (!zones.empty()) {
      mesh = open_project_zones(mesh, zones, zone_rules);
      require_valid(mesh, model, recorder.context().threads);
      note(model.notes, recorder.context(),
           "fault zones were opened once the mesh was made; shapes are told of the mesh without them");
    }
    if (options.order == ElementOrder::second && refine && model.refinement.honour == Honour::tolerance)
      mesh.curved_edges = curved_edges(mesh, model.surfaces, model.refinement.tolerance.left());
    report.solver = judge_solvers(core, mesh, size, recorder.context().threads);
    if (model.options.recover.mode == MeshMode::conforming)
      report.voronoi_dual = measure_voronoi_dual(core.points, core.tetrahedra);
  }
  report.mesh = &mesh;
  report.tops = measure_tops(model.tops, mesh);
  report.model_verdict = judge_model(model, mesh, recorder.context());
  Summary summary = summarise(report, model.refinement);
  result.summary = std::move(summary.lines);
  result.details = std::move(summary.details);
  {
    StageScope stage(recorder.context(), "write");
    make_output_folder(plan);
    std::size_t n_formats_done = 0;
    for (const std::string& format : plan.formats) {
      recorder.context().report(mesh.tetrahedra.size() * n_formats_done++,
                                mesh.tetrahedra.size() * plan.formats.size());
      if (format == "html") continue;  // the report as a page: written with the report
      for (auto& file : write_format(mesh, format, plan.stem, options)) result.files.push_back(std::move(file));
    }
    recorder.context().note(LogLevel::info,
                            count_words(plan.formats.size(), plan.formats.size() == 1 ? "format" : "formats"));
  }
  write_reports(plan, report, model, recorder, result);
  result.mesh = std::move(mesh);
  return result;
}

/// The surfaces and triangles that the facets of an error of the core are pieces of.
ModelItems items_of(const Error& error, const PreparedModel& model) {
  ModelItems items;
  for (const Index f : error.context().facets) {
    if (f >= model.plc.plc.n_facets()) continue;
    for (const PolygonSoup::Origin& o : origins_of(model.arrangement.soup, model.plc, f))
      items.add_triangle(model.surfaces[o.surface].name, o.triangle);
  }
  return items;
}

/// Where meshing has failed at a place that can be looked at: with `--stop-after recover` it is written, else the
/// message tells how to get it.
[[noreturn]] void fail_in_terms_of_model(const Error& error, const PreparedModel& model, const OutputPlan& plan,
                                         const StageRecorder& recorder) {
  std::string message = error.what();
  std::vector<Index> facets = error.context().facets;
  std::erase_if(facets, [&](Index f) { return f >= model.plc.plc.n_facets(); });
  if (const std::string names = surfaces_of(facets, model); !names.empty()) message += " (surfaces: " + names + ")";
  if (!error.context().excerpt || plan.stem.empty()) {
    // nothing to look at, or nowhere to write it
  } else if (recorder.stop_after() == "recover") {
    make_output_folder(plan);
    message += ". The tetrahedra and constraints about the place are in";
    for (const auto& file :
         write_failed_place(*error.context().excerpt, model.plc, model.arrangement.soup, model.surfaces, plan.stem))
      message += " " + file.string();
  } else {
    message += ". With --stop-after recover the tetrahedra and constraints about the place are written for viewing";
  }
  throw ModelError(error.kind(), message, items_of(error, model), error.context());
}

JobResult stop_early(PreparedModel& model, const OutputPlan& plan, const StageRecorder& recorder) {
  JobResult result;
  Report report = begin_report(model);
  make_output_folder(plan);
  if (recorder.stop_after() == "intersect")
    for (auto& file : write_soup_vtp(model.arrangement, model.plc, model.surfaces, plan.stem))
      result.files.push_back(std::move(file));
  write_reports(plan, report, model, recorder, result);
  result.summary.push_back("stopped after " + recorder.stop_after() + ", as asked");
  return result;
}

}  // namespace

void note(std::vector<std::string>& notes, const RunContext& context, std::string text) {
  context.note(LogLevel::info, text);
  notes.push_back(std::move(text));
}

void warn(std::vector<std::string>& warnings, const RunContext& context, std::string text) {
  context.note(LogLevel::warning, text);
  warnings.push_back(std::move(text));
}

VerifiedModel mesh_and_verify(PreparedModel& model, StageRecorder& recorder) {
  try {
    VerifiedModel meshed;
    std::vector<double> volumes_of_input;
    meshed.refined = mesh_to_size(model, recorder, volumes_of_input);
    const StageScope stage(recorder.context(), "verify");
    meshed.mesh = name_and_verify(meshed.refined.mesh, {}, model, recorder);
    set_volumes_of_input(meshed.mesh, meshed.refined.mesh, volumes_of_input);
    if (!volumes_of_input.empty()) require_volumes_within(meshed.mesh, model.refinement.tolerance.left());
    return meshed;
  } catch (const ModelError&) {
    throw;
  } catch (const Error& error) {
    fail_in_terms_of_model(error, model, {}, recorder);
  }
}

JobResult run_stages(PreparedModel& model, const OutputPlan& plan, StageRecorder& recorder,
                     const std::function<void()>& prepare) {
  require_writable_outputs(plan);
  try {
    prepare();
    return mesh_and_write(model, plan, recorder);
  } catch (const StopRequested&) {
    return stop_early(model, plan, recorder);
  } catch (const ModelError&) {
    throw;
  } catch (const Error& error) {
    fail_in_terms_of_model(error, model, plan, recorder);
  }
}

}  // namespace geomesh::geomodel

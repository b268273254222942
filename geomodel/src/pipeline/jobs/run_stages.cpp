// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/jobs/run_stages.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "fault_zones/project_zones.hpp"
#include "geomesh/geomodel/model_error.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "naming/region_facts.hpp"
#include "pipeline/outputs/failed_place.hpp"
#include "pipeline/outputs/soup_vtp.hpp"
#include "pipeline/outputs/summary.hpp"
#include "pipeline/region_volumes.hpp"
#include "pipeline/stages/refine_model.hpp"
#include "pipeline/surfaces_of_facets.hpp"
#include "solver_mesh/curved_edges.hpp"

namespace geomesh::geomodel {
namespace {

/// The records of the stages that a run has completed. The run may end early; its report then describes these records.
struct RecordsSoFar {
  std::optional<Inputs> inputs;
  std::optional<Built> built;
  std::optional<Arranged> arranged;
};

/// The fault zones of a project, with the groups and attributes that name them. They are opened after the mesh is made.
struct Zones {
  std::vector<FaultZone> zones;
  NamingRules rules;
};

Report begin_report(const RecordsSoFar& records) {
  static const ArrangementResult nothing;
  Report report;
  report.arrangement = records.arranged ? &records.arranged->arrangement : &nothing;
  if (records.inputs) {
    report.command = records.inputs->command;
    report.name = records.inputs->name;
    report.input_json = records.inputs->description;
    report.tolerance = &records.inputs->refinement.tolerance;
  }
  if (records.built) {
    report.tolerance = &records.built->refinement.tolerance;
    if (records.built->stack.settled) report.stack = &records.built->stack;
    report.continued = records.built->continued;
  }
  if (records.arranged) report.tolerance = &records.arranged->refinement.tolerance;
  return report;
}

/// Returns the description of the inputs with the size that was used, which may be derived from a number of elements.
std::string described_with_size(const Inputs& inputs, const RefinementSettings& used) {
  const double size = used.size.base.global;
  if (!(size > 0) || size == inputs.refinement.size.base.global) return inputs.description;
  auto input = nlohmann::ordered_json::parse(inputs.description, nullptr, false);
  if (input.is_discarded()) return inputs.description;
  input["mesh"]["size"] = size;
  return input.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// Progress of the stage `verify` after the mesh was named and verified, and after its shapes were measured. These
/// shares only affect the displayed progress.
constexpr double verified_share = 0.65, measured_share = 0.9;

ModelMesh verify(const ModelRecords& model, const Meshed& meshed, const Zones& zones, const WriteOptions& options,
                 Report& report, Journal& journal) {
  const StageScope stage(journal.context(), "verify");
  const ConstrainedTetrahedralization& core = meshed.refined.mesh;
  const RefinementSettings& used = meshed.used;
  const unsigned threads = journal.context().threads;
  const std::size_t n = core.tetrahedra.size();
  const auto tell_share = [&](double share) {
    journal.context().report(static_cast<std::size_t>(share * static_cast<double>(n)), n);
  };
  tell_share(0);
  const SizeField* const size = used.refine ? &meshed.refined.size_field : nullptr;
  ModelMesh mesh = name_and_verify(model, meshed, make_cell_arrays(used.cell_arrays, core, size), journal);
  journal.warn_all(volume_changes(mesh, used.tolerance.left()));
  tell_share(verified_share);
  report.quality = judge_quality(model, meshed, mesh, threads);
  tell_share(measured_share);
  if (!zones.zones.empty()) {
    mesh = open_project_zones(mesh, zones.zones, zones.rules);
    require_valid(mesh, model.built.z_scale, threads);
    journal.note("fault zones were opened once the mesh was made; shapes are those of the mesh without them");
  }
  if (options.order == ElementOrder::second && used.refine && used.honour == Honour::tolerance)
    mesh.curved_edges = curved_edges(mesh, model.arranged.surfaces, used.tolerance.left());
  report.solver = judge_solvers(meshed, mesh, threads);
  if (model.inputs.options.recover.mode == MeshMode::conforming)
    report.voronoi_dual = measure_voronoi_dual(core.points, core.tetrahedra);
  return mesh;
}

JobResult mesh_and_write(const RecordsSoFar& records, const Zones& zones, const OutputPlan& plan,
                         StageRecorder& recorder, Journal& journal) {
  const Inputs& inputs = *records.inputs;
  const Built& built = *records.built;
  Meshed meshed = mesh_model({inputs, built, *records.arranged}, {}, journal);
  std::optional<Arranged> unscaled;
  if (built.z_scale.factor() != 1) unscaled = in_true_heights(*records.arranged, built.z_scale);
  const ModelRecords model{inputs, built, unscaled ? *unscaled : *records.arranged};
  meshed = free_split_corners(model, std::move(meshed), plan.options.split, recorder.context().threads);
  Report report = begin_report(records);
  report.arrangement = &model.arranged.arrangement;
  report.input_json = described_with_size(inputs, meshed.used);
  report.tolerance = &meshed.used.tolerance;
  report.core = &meshed.refined.mesh;
  if (meshed.used.refine) report.refinement = meshed.refined.statistics;
  JobResult result;
  result.mesh = verify(model, meshed, zones, plan.options, report, journal);
  report.mesh = &result.mesh;
  report.tops = measure_tops(inputs.tops, result.mesh);
  report.model_verdict = judge_model(model, result.mesh, journal);
  Summary summary = summarise(report, meshed.used);
  result.summary = std::move(summary.lines);
  result.details = std::move(summary.details);
  result.files = write_mesh(plan, result.mesh, recorder.context());
  write_reports(plan, report, recorder, journal, result);
  return result;
}

/// Returns the surfaces and triangles to which the facets named by an error of the core belong.
ModelItems items_of(const Error& error, const Arranged& arranged) {
  ModelItems items;
  for (const Index f : error.context().facets) {
    if (f >= arranged.plc.plc.n_facets()) continue;
    for (const PolygonSoup::Origin& o : origins_of(arranged.arrangement.soup, arranged.plc, f))
      items.add_triangle(arranged.surfaces[o.surface].name, o.triangle);
  }
  return items;
}

/// Throws the error again in terms of surfaces and triangles of the model. With `--stop-after recover` the surroundings
/// of the failure are written to files for viewing; otherwise the message explains how to get these files.
[[noreturn]] void fail_in_terms_of_model(const Error& error, const Arranged& arranged, const OutputPlan& plan,
                                         const std::string& stop_after) {
  std::string message = error.what();
  std::vector<Index> facets = error.context().facets;
  std::erase_if(facets, [&](Index f) { return f >= arranged.plc.plc.n_facets(); });
  if (const std::string names = surfaces_of_facets(facets, arranged); !names.empty())
    message += " (surfaces: " + names + ")";
  if (!error.context().excerpt || plan.stem.empty()) {
    // No files can be written: the error does not contain the mesh around the failure, or the output folder is unknown.
  } else if (stop_after == "recover") {
    make_output_folder(plan);
    message += ". The tetrahedra and constraints about the place are in";
    for (const auto& file : write_failed_place(*error.context().excerpt, arranged.plc, arranged.arrangement.soup,
                                               arranged.surfaces, plan.stem))
      message += " " + file.string();
  } else {
    message += ". With --stop-after recover the tetrahedra and constraints about the place are written for viewing";
  }
  throw ModelError(error.kind(), message, items_of(error, arranged), error.context());
}

JobResult stop_early(const RecordsSoFar& records, const OutputPlan& plan, const StageRecorder& recorder,
                     const Journal& journal) {
  JobResult result;
  Report report = begin_report(records);
  make_output_folder(plan);
  if (recorder.stop_after() == "intersect") {
    const Arranged& arranged = *records.arranged;
    for (auto& file : write_soup_vtp(arranged.arrangement, arranged.plc, arranged.surfaces, plan.stem))
      result.files.push_back(std::move(file));
  }
  write_reports(plan, report, recorder, journal, result);
  result.summary.push_back("stopped after " + recorder.stop_after() + ", as requested");
  return result;
}

}  // namespace

VerifiedModel mesh_and_verify(const ModelRecords& model, const SparseMeshing& sparse, Journal& journal) {
  try {
    Meshed meshed = mesh_model(model, sparse, journal);
    const StageScope stage(journal.context(), "verify");
    ModelMesh mesh = name_and_verify(model, meshed, {}, journal);
    std::string description = described_with_size(model.inputs, meshed.used);
    return {std::move(meshed.refined), std::move(mesh), std::move(description)};
  } catch (const ModelError&) {
    throw;
  } catch (const Error& error) {
    fail_in_terms_of_model(error, model.arranged, {}, "");
  }
}

JobResult run_stages(const OutputPlan& asked, StageRecorder& recorder, const std::function<Inputs(Journal&)>& read) {
  require_writable_outputs(asked);
  OutputPlan plan = asked;
  Zones zones{std::exchange(plan.options.fault_zones, {}), {}};
  Journal journal(recorder.context());
  RecordsSoFar records;
  try {
    Inputs inputs = read(journal);
    zones.rules = take_zone_rules(inputs.naming, zones.zones);
    inputs.curved_faces = plan.options.order == ElementOrder::second;
    records.inputs = std::move(inputs);
    records.built = records.inputs->has_rules ? build_model(*records.inputs, journal) : built_as_given(*records.inputs);
    records.arranged = intersect(*records.inputs, *records.built, journal);
    return mesh_and_write(records, zones, plan, recorder, journal);
  } catch (const StopRequested&) {
    return stop_early(records, plan, recorder, journal);
  } catch (const ModelError&) {
    throw;
  } catch (const Error& error) {
    fail_in_terms_of_model(error, records.arranged ? *records.arranged : Arranged{}, plan, recorder.stop_after());
  }
}

}  // namespace geomesh::geomodel

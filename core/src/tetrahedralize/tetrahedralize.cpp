// SPDX-License-Identifier: MIT
#include "geomesh/core/tetrahedralize.hpp"

#include "classify/classify.hpp"
#include "recover/conforming.hpp"
#include "recover/declare.hpp"
#include "recover/recover.hpp"
#include "recover/start_triangulation.hpp"

namespace geomesh {

namespace {

using recover::ConstrainedMesh;
using recover::DeclaredModel;
using recover::Recovery;

void refuse_invalid(const PiecewiseLinearComplex& plc) {
  const std::vector<PlcFault> faults = validate_plc(plc);
  if (faults.empty()) return;
  std::string message = "the model is not valid: " + faults[0].message;
  if (faults.size() > 1) message += " (and " + std::to_string(faults.size() - 1) + " more faults)";
  throw Error(ErrorKind::invalid_input, message, faults[0].context);
}

/// Segments (3.1), facets (3.2), what is still missing (3.3).
void recover_constraints(const PiecewiseLinearComplex& plc, DeclaredModel& model, ConstrainedMesh& mesh, RecoveryStatistics& statistics,
                         const RecoverOptions& options, const RunContext& context) {
  const StageScope stage(context, "recover");
  Recovery recovery{mesh, model.constraints, statistics, context, model.input_vertex, plc};
  try {
    if (options.mode == MeshMode::conforming) {
      recover::ConformingRecovery conforming(recovery, options);
      const bool within_budget = conforming.run();
      statistics.facets_not_recovered = conforming.facets_given_up();
      if (!within_budget) throw Error(ErrorKind::cannot_mesh, "the model needs more points than conforming mode may add");
    }
    recover::recover_segments(recovery);
    recover::recover_facets(recovery);
    if (options.preserve_boundary || options.mode == MeshMode::constrained) recover::remove_added_points(recovery);
    if (options.preserve_boundary) recover::require_untouched_boundary(recovery);
  } catch (const Error& e) {
    // What cannot be meshed may be invalid in a place that recovery did not see first.
    if (e.kind() == ErrorKind::cannot_mesh) recovery.refuse_crossings();
    throw;
  }
  recover::validate_recovered(recovery);
}

}  // namespace

namespace {

ConstrainedTetrahedralization mesh_in_mode(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options, const RunContext& context,
                                           std::vector<Index>& given_up) {
  DeclaredModel model = recover::declare_constraints(plc, context);
  if (model.input_vertex.size() < 4) throw Error(ErrorKind::cannot_mesh, "fewer than four points cannot enclose anything");
  RecoveryStatistics statistics;
  statistics.facets_total = plc.n_facets();
  statistics.segments_total = model.constraints.segments.size();

  recover::StartTriangulation start;
  {
    const StageScope stage(context, "delaunay");
    start = recover::triangulate_start(plc, model, options.delaunay, context, options.recover.mode == MeshMode::constrained);
  }
  statistics.tetrahedra_unconstrained = start.tetrahedra;
  statistics.missing_edges_initial = start.missing_edges;
  statistics.missing_facets_before_segments = start.missing_facets;
  ConstrainedMesh mesh(std::move(start.mesh), std::move(start.points), model.input_vertex.size());
  try {
    recover_constraints(plc, model, mesh, statistics, options.recover, context);
  } catch (const Error&) {
    given_up = statistics.facets_not_recovered;
    throw;
  }
  const StageScope stage(context, "classify");
  ConstrainedTetrahedralization out = classify::classify(mesh, model, plc, context);
  const std::size_t n_tetrahedra = out.tetrahedra.size();
  out.delaunay = options.recover.mode == MeshMode::conforming && recover::is_locally_delaunay(mesh);
  out.recovery = statistics;
  out.recovery.tetrahedra_final = n_tetrahedra;
  for (VertexOrigin origin : out.origin) {
    out.recovery.steiner_on_segments += origin == VertexOrigin::on_segment;
    out.recovery.steiner_on_facets += origin == VertexOrigin::on_facet;
    out.recovery.steiner_inside += origin == VertexOrigin::inside;
  }
  out.delaunay_statistics = start.statistics;
  return out;
}

}  // namespace

ConstrainedTetrahedralization tetrahedralize(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options,
                                             const RunContext& context) {
  if (options.recover.preserve_boundary && options.recover.mode == MeshMode::conforming)
    throw Error(ErrorKind::usage, "conforming mode adds points to the boundary: it cannot be asked to preserve it");
  refuse_invalid(plc);
  std::vector<Index> given_up;
  if (options.recover.mode == MeshMode::constrained) return mesh_in_mode(plc, options, context, given_up);
  try {
    return mesh_in_mode(plc, options, context, given_up);
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::cannot_mesh) throw;
    context.note(LogLevel::warning, "conforming mode: small angles need too many points; the model is meshed in constrained mode instead");
  }
  // Points crowded by small angles can leave no room for what is still missing; without them there is.
  TetrahedralizeOptions constrained = options;
  constrained.recover.mode = MeshMode::constrained;
  if (given_up.empty())
    for (Index f = 0; f < plc.n_facets(); ++f) given_up.push_back(f);
  std::vector<Index> unused;
  ConstrainedTetrahedralization out = mesh_in_mode(plc, constrained, context, unused);
  out.recovery.facets_not_recovered = given_up;
  return out;
}

}  // namespace geomesh

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
      conforming.run();
      statistics.facets_not_recovered = conforming.facets_given_up();
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

ConstrainedTetrahedralization tetrahedralize(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options,
                                             const RunContext& context, bool keep_hull) {
  if (options.recover.preserve_boundary && options.recover.mode == MeshMode::conforming)
    throw Error(ErrorKind::usage, "conforming mode adds points to the boundary: it cannot be asked to preserve it");
  refuse_invalid(plc);
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
  recover_constraints(plc, model, mesh, statistics, options.recover, context);
  const StageScope stage(context, "classify");
  ConstrainedTetrahedralization out = classify::classify(mesh, model, plc, context, keep_hull);
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

}  // namespace geomesh

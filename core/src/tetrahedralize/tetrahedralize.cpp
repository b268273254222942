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
  {
    const StageScope stage(context, "recover");
    Recovery recovery{mesh, model.constraints, statistics, context, model.input_vertex};
    if (options.recover.mode == MeshMode::conforming) {
      recover::ConformingRecovery conforming(recovery, options.recover);
      conforming.run();
      statistics.facets_not_recovered = conforming.facets_given_up();
    }
    recover::recover_segments(recovery);
    recover::recover_facets(recovery);
    const bool preserve = options.recover.preserve_boundary;
    if (preserve || options.recover.mode == MeshMode::constrained) recover::remove_added_points(recovery);
    if (preserve) recover::require_untouched_boundary(recovery);
    recover::validate_recovered(recovery);
  }
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

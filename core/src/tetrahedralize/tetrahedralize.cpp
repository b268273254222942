// SPDX-License-Identifier: MIT
#include "geomesh/core/tetrahedralize.hpp"

#include <algorithm>
#include <cmath>

#include "classify/classify.hpp"
#include "recover/declare.hpp"
#include "recover/recover.hpp"

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

/// The model's vertices and the eight corners of a box that encloses them at a distance, so that the hull of the mesh is never touched.
/// Corners on powers of two and far off: they disturb neither the model's Delaunay cells much nor the predicates' filters.
std::vector<Vec3> vertices_with_box(const PiecewiseLinearComplex& plc, const DeclaredModel& model) {
  std::vector<Vec3> points;
  Box3 box;
  for (VertexIndex v : model.input_vertex) {
    points.push_back(plc.points[v]);
    box.add(plc.points[v]);
  }
  const double extent = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
  const double margin = std::ldexp(1.0, std::ilogb(extent > 0 ? extent : 1.0) + 4);
  for (unsigned corner = 0; corner < 8; ++corner)
    points.push_back({corner & 1 ? box.max.x + margin : box.min.x - margin, corner & 2 ? box.max.y + margin : box.min.y - margin,
                      corner & 4 ? box.max.z + margin : box.min.z - margin});
  return points;
}

std::size_t count_model_cells(const ConstrainedMesh& mesh) {
  std::size_t n = 0;
  const TetMesh& cells = mesh.cells();
  for (CellIndex c = 0; c < cells.n_slots(); ++c) {
    if (!cells.is_live(c)) continue;
    const auto& v = cells.vertices(c);
    if (std::all_of(v.begin(), v.end(), [&](VertexIndex u) { return u < mesh.n_input(); })) ++n;
  }
  return n;
}

}  // namespace

ConstrainedTetrahedralization tetrahedralize(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options,
                                             const RunContext& context, bool keep_hull) {
  refuse_invalid(plc);
  DeclaredModel model = recover::declare_constraints(plc, context);
  if (model.input_vertex.size() < 4) throw Error(ErrorKind::cannot_mesh, "fewer than four points cannot enclose anything");
  RecoveryStatistics statistics;
  statistics.facets_total = plc.n_facets();
  statistics.segments_total = model.constraints.segments.size();

  std::vector<Vec3> points = vertices_with_box(plc, model);
  DelaunayTetrahedralization delaunay;
  {
    const StageScope stage(context, "delaunay");
    delaunay = delaunay_tetrahedralization(points, options.delaunay, context);
  }
  ConstrainedMesh mesh(std::move(delaunay.mesh), std::move(points), model.input_vertex.size());
  model.constraints.vertices.resize(mesh.points().size());
  statistics.tetrahedra_unconstrained = count_model_cells(mesh);
  {
    const StageScope stage(context, "recover");
    Recovery recovery{mesh, model.constraints, statistics, context, model.input_vertex};
    statistics.missing_facets_before_segments = recover::count_missing_subfacets(recovery);
    recover::recover_segments(recovery);
    recover::recover_facets(recovery);
    recover::remove_added_points(recovery);
    recover::validate_recovered(recovery);
  }
  const StageScope stage(context, "classify");
  ConstrainedTetrahedralization out = classify::classify(mesh, model, plc, context, keep_hull);
  const std::size_t n_tetrahedra = out.tetrahedra.size();
  out.recovery = statistics;
  out.recovery.tetrahedra_final = n_tetrahedra;
  for (VertexOrigin origin : out.origin) {
    out.recovery.steiner_on_segments += origin == VertexOrigin::on_segment;
    out.recovery.steiner_on_facets += origin == VertexOrigin::on_facet;
    out.recovery.steiner_inside += origin == VertexOrigin::inside;
  }
  out.delaunay_statistics = delaunay.statistics;
  return out;
}

}  // namespace geomesh

// SPDX-License-Identifier: MIT
#include "geomesh/core/tetrahedralize.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "classify/classify.hpp"
#include "common/sort_unique.hpp"
#include "geomesh/core/predicates.hpp"
#include "recover/conforming/conforming.hpp"
#include "recover/model/declare.hpp"
#include "recover/model/recover.hpp"
#include "recover/start/hard_parts_first.hpp"
#include "recover/start/start_triangulation.hpp"
#include "tetrahedralize/canonical_form.hpp"
#include "tetrahedralize/conforming_step.hpp"

namespace geomesh {

namespace {

using recover::ConstrainedMesh;
using recover::DeclaredModel;
using recover::HardPartsFirst;
using recover::Recovery;
using recover::StartTriangulation;

void refuse_invalid(const PiecewiseLinearComplex& plc) {
  const std::vector<PlcFault> faults = validate_plc(plc);
  if (faults.empty()) return;
  std::string message = "the model is not valid: " + faults[0].message;
  if (faults.size() > 1) message += " (and " + std::to_string(faults.size() - 1) + " more faults)";
  throw Error(ErrorKind::invalid_input, message, faults[0].context);
}

bool recover_conforming(Recovery& recovery, const RecoverOptions& options, std::vector<Index>& given_up) {
  recover::ConformingRecovery conforming(recovery, options);
  const bool within_budget = conforming.run();
  given_up = conforming.facets_given_up();
  return within_budget;
}

/// Segments (3.1), facets (3.2), what is still missing (3.3).
void recover_constraints(Recovery& recovery, const RecoverOptions& options, const ConformingStep& conform) {
  if (options.mode == MeshMode::conforming) {
    if (!conform(recovery, options, recovery.statistics.facets_not_recovered))
      throw Error(ErrorKind::cannot_mesh, "the model needs more points than conforming mode may add");
  }
  recover::recover_segments(recovery);
  recover::recover_facets(recovery);
  if (options.preserve_boundary || options.mode == MeshMode::constrained)
    recover::remove_added_points(recovery, options.preserve_boundary);
  if (options.preserve_boundary) recover::require_untouched_boundary(recovery);
  recover::validate_recovered(recovery);
}

double ulp_of_largest(const std::vector<Vec3>& points) {
  double largest = 0;
  for (const Vec3& p : points)
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::fabs(p[i]));
  return std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
}

/// One model, in canonical form, on its way to a mesh.
struct MeshingRun {
  const PiecewiseLinearComplex& plc;
  const ModelNames& names;
  const TetrahedralizeOptions& options;
  const RunContext& context;
  const ConformingStep& conform;
  DeclaredModel model{};
  RecoveryStatistics statistics{};
  DelaunayStatistics delaunay{};
  HardPartsFirst hard_parts{};

  StartTriangulation start(unsigned attempt = 0) {
    model = recover::declare_constraints(plc, names, context);
    if (model.input_vertex.size() < 4)
      throw Error(ErrorKind::cannot_mesh, "fewer than four points cannot enclose anything");
    const bool may_scale = options.recover.mode == MeshMode::constrained && !begins_hard(attempt);
    StartTriangulation out =
        recover::triangulate_start(plc, names, model, options.delaunay, context, may_scale, attempt);
    if (begins_hard(attempt)) out.mesh = hard_parts.triangulate(out.points, options.delaunay, context);
    statistics = {};
    statistics.facets_total = plc.n_facets();
    statistics.segments_total = model.constraints.segments.size();
    statistics.tetrahedra_unconstrained = out.tetrahedra;
    statistics.missing_edges_initial = out.missing_edges;
    statistics.missing_facets_before_segments = out.missing_facets;
    delaunay = out.statistics;
    return out;
  }

  /// A second attempt from another scale, with other points, is cheap and mostly enough; the others begin with what was
  /// hard.
  bool begins_hard(unsigned attempt) const { return attempt > 1 && hard_parts.has_learned(); }

  /// Where rounding of added points has led recovery into a dead end, it is begun again. What recovery found wrong with
  /// the model is believed at once where the exact search finds a crossing, else after the last attempt.
  ConstrainedMesh recover(StartTriangulation first) {
    CrossingsOf crossings(plc);
    for (unsigned attempt = 0;; ++attempt) {
      StartTriangulation from = attempt == 0 ? std::move(first) : start(attempt);
      ConstrainedMesh mesh(std::move(from.mesh), std::move(from.points), model.input_vertex.size());
      Recovery recovery{mesh, model.constraints, statistics, context, model.input_vertex, plc, names, crossings};
      recovery.attempt = attempt;
      recovery.least_spacing = 64 * ulp_of_largest(plc.points);
      for (unsigned i = 0; i < attempt; ++i) mesh.random(2);
      try {
        if (begins_hard(attempt)) hard_parts.run(recovery);
        recover_constraints(recovery, options.recover, conform);
        return mesh;
      } catch (const Error& e) {
        if (e.kind() != ErrorKind::cannot_mesh && e.kind() != ErrorKind::invalid_input) throw;
        const bool is_last =
            attempt + 1 >= options.recover.max_attempts || options.recover.mode == MeshMode::conforming;
        if (e.kind() == ErrorKind::cannot_mesh) recovery.refuse_crossings();
        if (is_last || (e.kind() == ErrorKind::invalid_input && recovery.has_crossings())) throw;
        context.note(LogLevel::debug, "attempt " + std::to_string(attempt + 1) + " of " +
                                          std::to_string(options.recover.max_attempts) + " ends: " + e.what());
        hard_parts.learn(recovery, model);
      }
    }
  }
};

ConstrainedTetrahedralization recover_and_classify(MeshingRun& run, StartTriangulation start) {
  std::optional<ConstrainedMesh> mesh;
  {
    const StageScope stage(run.context, "recover");
    mesh = run.recover(std::move(start));
  }
  const StageScope stage(run.context, "classify");
  ConstrainedTetrahedralization out = classify::classify(*mesh, run.model, run.plc, run.context);
  out.delaunay = run.options.recover.mode == MeshMode::conforming && recover::is_locally_delaunay(*mesh);
  out.recovery = run.statistics;
  out.recovery.tetrahedra_final = out.tetrahedra.size();
  for (VertexOrigin origin : out.origin) {
    out.recovery.steiner_on_segments += origin == VertexOrigin::on_segment;
    out.recovery.steiner_on_facets += origin == VertexOrigin::on_facet;
    out.recovery.steiner_inside += origin == VertexOrigin::inside;
  }
  out.delaunay_statistics = run.delaunay;
  return out;
}

/// Sets `given_up` where it throws.
ConstrainedTetrahedralization mesh_in_mode(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options,
                                           const RunContext& context, const ConformingStep& conform,
                                           std::vector<Index>& given_up) {
  std::optional<StageScope> delaunay_stage(std::in_place, context, "delaunay");
  const CanonicalForm form = canonical_form(plc);
  MeshingRun run{form.plc, form.names, options, context, conform};
  try {
    StartTriangulation start = run.start();
    delaunay_stage.reset();
    return in_callers_terms(recover_and_classify(run, std::move(start)), form.names, plc);
  } catch (const Error& e) {
    given_up = facets_in_callers_terms(std::move(run.statistics.facets_not_recovered), form.names);
    throw in_callers_terms(e, form.names);
  }
}

}  // namespace

void list_facets_off_delaunay(ConstrainedTetrahedralization& mesh) {
  std::vector<Index>& list = mesh.recovery.facets_not_recovered;
  for (const ConstrainedTetrahedralization::Face& face : mesh.faces) {
    if (face.tetrahedron_above == no_index || face.tetrahedron_below == no_index) continue;
    const Tetrahedron &above = mesh.tetrahedra[face.tetrahedron_above],
                      &below = mesh.tetrahedra[face.tetrahedron_below];
    const auto opposite = std::find_if(below.begin(), below.end(), [&](VertexIndex v) {
      return std::find(face.vertices.begin(), face.vertices.end(), v) == face.vertices.end();
    });
    const auto point = [&](VertexIndex v) -> const Vec3& { return mesh.points[v]; };
    if (in_sphere(point(above[0]), point(above[1]), point(above[2]), point(above[3]), point(*opposite)) ==
        Sign::positive)
      list.push_back(face.facet);
  }
  sort_unique(list);
}

ConstrainedTetrahedralization tetrahedralize_conforming(const PiecewiseLinearComplex& plc,
                                                        const TetrahedralizeOptions& options, const RunContext& context,
                                                        const ConformingStep& step) {
  std::vector<Index> given_up;
  ConstrainedTetrahedralization out = mesh_in_mode(plc, options, context, step, given_up);
  list_facets_off_delaunay(out);
  return out;
}

ConstrainedTetrahedralization tetrahedralize(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options,
                                             const RunContext& context) {
  if (options.recover.preserve_boundary && options.recover.mode == MeshMode::conforming)
    throw Error(ErrorKind::usage, "conforming mode adds points to the boundary: it cannot be asked to preserve it");
  refuse_invalid(plc);
  std::vector<Index> given_up;
  if (options.recover.mode == MeshMode::constrained)
    return mesh_in_mode(plc, options, context, recover_conforming, given_up);
  try {
    ConstrainedTetrahedralization out = mesh_in_mode(plc, options, context, recover_conforming, given_up);
    list_facets_off_delaunay(out);
    return out;
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::cannot_mesh) throw;
    context.note(LogLevel::warning,
                 "conforming mode: small angles need too many points; the model is meshed in constrained mode instead");
  }
  // Points crowded by small angles can leave no room for what is still missing; without them there is.
  TetrahedralizeOptions constrained = options;
  constrained.recover.mode = MeshMode::constrained;
  std::vector<Index> unused;
  ConstrainedTetrahedralization out = mesh_in_mode(plc, constrained, context, recover_conforming, unused);
  out.recovery.facets_not_recovered = given_up;
  list_facets_off_delaunay(out);
  if (out.recovery.facets_not_recovered.empty())  // the cells between them may have left Delaunay
    for (Index f = 0; f < plc.n_facets(); ++f) out.recovery.facets_not_recovered.push_back(f);
  return out;
}

}  // namespace geomesh

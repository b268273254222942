// SPDX-License-Identifier: MIT
#include "tetrahedralize/recovery_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "recover/model/messages.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/rounding/rounding.hpp"

namespace geomesh {

using recover::BoundaryPoints;
using recover::ConstrainedMesh;
using recover::InnerEffort;
using recover::Recovery;
using recover::StartFrame;
using recover::StartTriangulation;

namespace {

double ulp_of_largest(const std::vector<Vec3>& points) {
  double largest = 0;
  for (const Vec3& p : points)
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::fabs(p[i]));
  return std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
}

/// Rounds the remaining Steiner points to doubles. Points without a suitable double nearby are first moved off segments
/// and facets, because stars are larger inside regions; then all doubles of their stars are tried. Ends the attempt
/// only if that does not help, because another attempt repeats all work. Returns the number of points without a double.
std::size_t round_steiner_points(Recovery& recovery) {
  std::size_t n_before = std::numeric_limits<std::size_t>::max();
  for (unsigned run = 0; run < recover::recovery_budget.rounding_runs; ++run) {
    if (run > 0) recover::remove_added_points(recovery, BoundaryPoints::must_go);
    std::vector<VertexIndex> left = recover::round_exact_points(recovery);
    if (left.empty()) return 0;
    if (left.size() >= n_before || run + 1 == recover::recovery_budget.rounding_runs) {
      recover::round_anywhere_in_stars(recovery, left);
      if (left.empty()) return 0;
      recovery.end(recover::error_of_rounding(recovery, left));
      return left.size();
    }
    n_before = left.size();
  }
  return 0;
}

void validate_stage([[maybe_unused]] Recovery& recovery) {
#ifdef GEOMESH_EXPENSIVE_CHECKS
  recover::validate_cells(recovery.mesh);
#endif
}

}  // namespace

RecoveryRun::RecoveryRun(const PiecewiseLinearComplex& plc, const ModelNames& names,
                         const TetrahedralizeOptions& options, const RunContext& context, const ConformingStep& conform)
    : plc_(plc),
      names_(names),
      options_(options),
      context_(context),
      conform_(conform),
      least_spacing_(recover::recovery_budget.least_spacing_ulps * ulp_of_largest(plc.points)) {}

void RecoveryRun::triangulate() { first_start_ = start(attempt_of(0, options_.recover, hard_parts_)); }

StartTriangulation RecoveryRun::start(const Attempt& attempt) {
  model_ = recover::declare_constraints(plc_, names_, context_);
  if (model_.input_vertex.size() < 4)
    throw Error(ErrorKind::cannot_mesh, "fewer than four points cannot enclose anything");
  const bool has_all = attempt.order == InsertionOrder::all_at_once;
  const bool may_stretch = options_.recover.mode == MeshMode::constrained && has_all;
  StartTriangulation out =
      recover::triangulate_start(plc_, names_, model_, options_.delaunay, context_,
                                 may_stretch ? StartFrame::may_be_stretched : StartFrame::as_given);
  if (!has_all) out.mesh = hard_parts_.triangulate(out.points, options_.delaunay, context_);
  statistics_ = {};
  statistics_.facets_total = plc_.n_facets();
  statistics_.segments_total = model_.constraints.segments.size();
  statistics_.tetrahedra_unconstrained = out.tetrahedra;
  statistics_.missing_edges_initial = out.missing_edges;
  statistics_.missing_facets_before_segments = out.missing_facets;
  delaunay_ = out.statistics;
  return out;
}

RecoveryOutcome RecoveryRun::recover() {
  CrossingsOf crossings(plc_);
  Attempt attempt = attempt_of(0, options_.recover, hard_parts_);
  std::optional<Error> refusal;  // last error that has a mesh excerpt or reports invalid input; else the last one
  for (unsigned n_made = 1;; ++n_made) {
    StartTriangulation from = n_made == 1 ? std::move(*first_start_) : start(attempt);
    ConstrainedMesh mesh(std::move(from.mesh), std::move(from.points), model_.input_vertex.size());
    mesh.reseed(1 + attempt.number);
    Recovery recovery{mesh, model_.constraints, statistics_, context_, model_.input_vertex, plc_, names_, crossings};
    recovery.attempt = attempt.number;
    recovery.has_exact_points = attempt.places == SteinerPlaces::exact;
    recovery.least_spacing = least_spacing_;
    recover_stages(attempt, recovery);
    n_decided_ += mesh.exact_places().n_decided();
    std::optional<Error>& dead_end = recovery.dead_end;
    if (!dead_end) return {std::move(mesh), std::nullopt};
    context_.note(LogLevel::debug,
                  "attempt " + std::to_string(n_made) + " (" + attempt.difference() + ") ends: " + dead_end->what());
    if (dead_end->kind() == ErrorKind::cannot_mesh)
      if (std::optional<Error> crossing = recovery.describe_crossing()) return {std::nullopt, std::move(crossing)};
    const bool says_more = dead_end->context().excerpt || dead_end->kind() == ErrorKind::invalid_input;
    if (!refusal || !refusal->context().excerpt || says_more) refusal = dead_end;
    hard_parts_.learn(recovery, model_);
    const std::optional<Attempt> next = attempt_after(attempt, *dead_end, recovery);
    if (!next) return {std::nullopt, with_way_out(*refusal)};
    attempt = *next;
  }
}

/// Runs the stages of one attempt: recovers segments and facets, removes Steiner points, rounds the remaining ones, and
/// checks the boundary. Ends with the first stage that sets recovery.dead_end.
void RecoveryRun::recover_stages(const Attempt& attempt, Recovery& recovery) {
  const RecoverOptions& options = options_.recover;
  const BoundaryPoints boundary = options.preserve_boundary ? BoundaryPoints::must_go : BoundaryPoints::may_stay;
  const auto begin = [&] {
    if (attempt.order == InsertionOrder::hard_parts_first) hard_parts_.run(recovery);
    if (options.mode == MeshMode::conforming && !conform_(recovery, options, statistics_.facets_not_recovered))
      recovery.end(Error(ErrorKind::cannot_mesh, "the model needs more points than conforming mode may add"));
  };
  const auto remove_points = [&] {
    const InnerEffort effort = recovery.has_exact_points ? InnerEffort::star : InnerEffort::region;  // regions later
    if (options.mode == MeshMode::constrained) recover::remove_added_points(recovery, boundary, effort);
  };
  const auto round_points = [&] {
    if (!recovery.has_exact_points) return;
    n_without_double_ += round_steiner_points(recovery);
    if (recovery.has_ended()) return;
    // Points that could not be removed before may be removable at the positions to which rounding has moved them.
    recover::remove_added_points(recovery, boundary);
    GEOMESH_CHECK(recover::round_exact_points(recovery).empty());
  };
  const auto check_boundary = [&] {
    if (options.preserve_boundary) recover::require_untouched_boundary(recovery);
  };
  const std::array<std::function<void()>, 6> stages{begin,
                                                    [&] { recover::recover_segments(recovery); },
                                                    [&] { recover::recover_facets(recovery); },
                                                    remove_points,
                                                    round_points,
                                                    check_boundary};
  for (const auto& stage : stages) {
    stage();
    if (recovery.has_ended()) return;
    validate_stage(recovery);
  }
  recover::validate_recovered(recovery);
}

/// If the boundary must be preserved, adds to the message that the model may be meshed without preserve_boundary.
Error RecoveryRun::with_way_out(const Error& dead_end) const {
  const std::string message = dead_end.what();
  if (!options_.recover.preserve_boundary || dead_end.kind() != ErrorKind::cannot_mesh ||
      message.find("preserve_boundary") != std::string::npos)
    return dead_end;
  return Error(dead_end.kind(),
               message + "; without preserve_boundary points may be added on surfaces, which may leave more room",
               dead_end.context());
}

/// Returns the next attempt after recovery has reached a dead end. Returns nothing if an exact search finds that input
/// items cross, if too many points could not be rounded to doubles (another attempt would hardly succeed), or if too
/// many orientations have been decided (it would take too long).
std::optional<Attempt> RecoveryRun::attempt_after(const Attempt& attempt, const Error& dead_end,
                                                  const Recovery& recovery) const {
  if (n_without_double_ >= recover::recovery_budget.points_without_double ||
      n_decided_ >= recover::recovery_budget.decisions_per_facet * plc_.n_facets() ||
      (dead_end.kind() == ErrorKind::invalid_input && recovery.has_crossings()))
    return std::nullopt;
  return geomesh::attempt_after(attempt, options_.recover, hard_parts_);
}

}  // namespace geomesh

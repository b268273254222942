// SPDX-License-Identifier: MIT
// The schedule of improvement; declared in improve_passes.hpp.
#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "remesh/passes/improve_passes.hpp"
#include "remesh/passes/pass_runner.hpp"
#include "remesh/passes/passes.hpp"
#include "remesh/passes/worst_first_repair.hpp"
#include "remesh/rescue/bad_cells.hpp"
#include "remesh/rescue/rescue.hpp"

namespace geomesh::remesh {

namespace {

class TimeBudget {
 public:
  TimeBudget(double seconds, RefineStatistics& statistics, const RunContext& context)
      : seconds_(seconds), statistics_(statistics), context_(context), start_(std::chrono::steady_clock::now()) {}
  /// Returns whether the time budget is used up. Throws if the run was cancelled.
  bool is_spent() const {
    context_.check_cancelled();
    if (!(seconds_ > 0)) return false;
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    if (spent > seconds_) statistics_.out_of_time = true;
    return statistics_.out_of_time;
  }

 private:
  double seconds_;  // 0: none
  RefineStatistics& statistics_;
  const RunContext& context_;
  std::chrono::steady_clock::time_point start_;
};

double share(std::size_t n, const DomainMesh& mesh) {
  return static_cast<double>(n) / static_cast<double>(mesh.n_cells());
}

/// Runs rounds of repair as long as they lower the number of poor cells. If surfaces impose poor shapes everywhere,
/// repair only moves poor cells around.
class RepairRounds {
 public:
  RepairRounds(Toolbox& tools, const ImproveSchedule& schedule, WorstFirstRepair& repair, bool may_add_points)
      : tools_(tools),
        mesh_(tools.mesh),
        schedule_(schedule),
        repair_(repair),
        may_add_points_(may_add_points),
        fewest_(mesh_.n_cells()),
        fewest_worst_(mesh_.n_cells()) {}

  Next round(unsigned k) {
    const CellQuality& measure = mesh_.measure();
    const double limit = measure.of_angle(schedule_.target_angle);
    const std::vector<BadCell> poor = schedule_.poor_classes > 0
                                          ? cells_below_by_class(mesh_, limit, schedule_.poor_classes)
                                          : cells_below(mesh_, limit);
    const double worst = measure.of_angle(schedule_.progress_angle);
    const auto n_worst =
        static_cast<std::size_t>(std::ranges::count_if(poor, [&](const BadCell& b) { return b.shape < worst; }));
    if (is_in_vain(k, poor.size(), n_worst)) return Next::done;
    fewest_ = std::min(fewest_, poor.size());
    fewest_worst_ = std::min(fewest_worst_, n_worst);
    const std::size_t n_changed = repair_.run(poor, operations_of(k), usual_room);
    ++tools_.statistics.passes;
    n_idle_ = n_changed == 0 ? n_idle_ + 1 : 0;
    return n_idle_ < schedule_.idle_rounds ? Next::again : Next::done;
  }

 private:
  bool is_in_vain(unsigned k, std::size_t n_poor, std::size_t n_worst) const {
    const auto falls = [&](std::size_t now, std::size_t fewest) {
      return static_cast<double>(now) <= schedule_.progress * static_cast<double>(fewest);
    };
    const bool was_all_tried = k > (may_add_points_ ? schedule_.first_round_with_points : 0);
    return was_all_tried && !falls(n_poor, fewest_) && !falls(n_worst, fewest_worst_);
  }
  RepairBy operations_of(unsigned k) const {
    if (k == 0) return RepairBy::flips_and_moves;
    const bool has_points = may_add_points_ && k >= schedule_.first_round_with_points;
    return has_points ? RepairBy::points : RepairBy::contraction;
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  const ImproveSchedule& schedule_;
  WorstFirstRepair& repair_;
  bool may_add_points_;
  std::size_t fewest_, fewest_worst_, n_idle_ = 0;
};

/// Repairs slivers with points closer to others than the target sizes require, because a bad angle is worse than a
/// short edge. If there are many slivers, the surfaces impose them. In that case only the worst slivers are repaired,
/// with points still closer to others (ImproveSchedule::forced_room).
Next repair_slivers(Toolbox& tools, const ImproveSchedule& schedule, WorstFirstRepair& repair, double room) {
  DomainMesh& mesh = tools.mesh;
  std::vector<BadCell> slivers = cells_below(mesh, mesh.measure().of_angle(schedule.sliver_angle));
  const bool are_forced = share(slivers.size(), mesh) > schedule.few_slivers;
  if (are_forced) slivers.resize(static_cast<std::size_t>(schedule.forced_share * static_cast<double>(mesh.n_cells())));
  if (repair.run(slivers, RepairBy::points, are_forced ? schedule.forced_room : room) == 0) return Next::done;
  ++tools.statistics.passes;
  return Next::again;
}

/// For each value of ShortEdges, the mesh's time (DomainMesh::tick) when such edges were last examined; 0: never.
using LastLook = std::array<std::uint64_t, 2>;

/// One round of a pass that removes points: first inside, then on surfaces that may be remeshed. Skips edges around
/// which nothing has changed since the last round. The pass is done when a round removes no point.
template <class Thin>
Next thin_points(const Toolbox& tools, LastLook& last, const Thin& thin) {
  const auto thin_changed = [&](ShortEdges which) {
    return thin(which, std::exchange(last[static_cast<std::size_t>(which)], tools.mesh.tick()));
  };
  std::size_t n = thin_changed(ShortEdges::inside);
  if (!tools.guard.exact()) n += thin_changed(ShortEdges::on_surfaces);
  return n == 0 ? Next::done : Next::again;
}

RescueRule rescue_below(double shape, const ImproveSchedule& schedule) {
  return {shape, schedule.smoothing_steps, rescue_limits.steps};
}

bool mends_bad_cells(const Toolbox& tools, const ImproveSchedule& schedule) {
  return schedule.sliver_rounds > 0 && !tools.bad_cells_may_spread;
}

struct Mending {
  Toolbox& tools;
  const ImproveSchedule& schedule;
  const PassRunner& passes;
  const RunContext& context;
  const OutOfTime& out_of_time;
};

/// Repairs the remaining bad cells by sequences of operations, and removes points added close to others without gain.
void mend_what_is_left(const Mending& mending) {
  Toolbox& tools = mending.tools;
  const ImproveSchedule& schedule = mending.schedule;
  const PassRunner& passes = mending.passes;
  const RunContext& context = mending.context;
  const OutOfTime& out_of_time = mending.out_of_time;
  DomainMesh& mesh = tools.mesh;
  const CellQuality& measure = mesh.measure();
  const bool rescues_bad = mends_bad_cells(tools, schedule);
  const double thinning_floor = std::max(measure.of_angle(schedule.sliver_angle),
                                         shape_at_percentile(mesh, schedule.floor_percentile, context.threads));
  const auto thin_unneeded = [&](ShortEdges which, std::uint64_t since) {
    return thin_out(tools, which, thinning_floor, since, context);
  };
  LastLook look_at_unneeded{}, look_at_mended{};
  passes.run({.name = "points taken out that were not needed",
              .round = [&](unsigned) { return thin_points(tools, look_at_unneeded, thin_unneeded); },
              .most_rounds = schedule.thinning_rounds,
              .applies = rescues_bad});
  // This pass is skipped if many cells are bad, because the input then imposes them and hardly any repair succeeds. A
  // later pass repairs the bad cells that the input does not impose.
  passes.once(
      "bad cells mended by looking ahead",
      [&] { rescue_bad_cells(tools, rescue_below(measure.bad(), schedule), out_of_time); },
      rescues_bad && share(count_below(mesh, measure.bad()), mesh) <= schedule.few_bad);
  const RescueRule flat_rescue = rescue_below(measure.of_angle(schedule.flat_angle), schedule);
  // Solvers refuse flat cells, so these are repaired at every quality level.
  passes.once(
      "cells too flat for solvers mended by looking ahead",
      [&] { rescue_flat_cells(tools, flat_rescue, rescue_limits.most_vain, out_of_time); },
      !tools.bad_cells_may_spread);
  RescueRule aim_rescue = flat_rescue;
  for (const ImproveSchedule::Aim& aim : schedule.aims) {
    const RescueRule rule = rescue_below(measure.of_angle(aim.angle), schedule);
    const bool are_few = share(count_below(mesh, rule.bad_shape), mesh) <= aim.few;
    if (are_few || &aim == &schedule.aims.front()) aim_rescue = rule;
    passes.once(
        "the last poor cells mended by looking ahead",
        [&] { rescue_flat_cells(tools, rule, rescue_limits.most_vain_poor, out_of_time); }, rescues_bad && are_few);
  }
  const auto thin_mending = [&](ShortEdges which, std::uint64_t since) {
    return thin_out_mending(tools, which, aim_rescue, since, context);
  };
  passes.run({.name = "points too near to others taken out, and what is about them mended",
              .round = [&](unsigned) { return thin_points(tools, look_at_mended, thin_mending); },
              .most_rounds = schedule.thinning_rounds,
              .applies = rescues_bad});
}

}  // namespace

void mend_bad_cells(Toolbox& tools, const RefineOptions& options, const RunContext& context) {
  const ImproveSchedule schedule = schedule_of(options.quality);
  const TimeBudget budget(options.time_budget, tools.statistics, context);
  const OutOfTime out_of_time = [&] { return budget.is_spent(); };
  mend_what_is_left({tools, schedule, PassRunner(tools.mesh, context, out_of_time), context, out_of_time});
}

void improve_mesh(Toolbox& tools, const RefineOptions& options, const RunContext& context, const FreeCellJudge* judge) {
  DomainMesh& mesh = tools.mesh;
  const CellQuality& measure = mesh.measure();
  const ImproveSchedule schedule = schedule_of(options.quality);
  const TimeBudget budget(options.time_budget, tools.statistics, context);
  const OutOfTime out_of_time = [&] { return budget.is_spent(); };
  const bool may_add_points = options.size_surfaces || options.honour != Honour::exact;
  const bool rescues_bad = mends_bad_cells(tools, schedule);
  WorstFirstRepair repair(tools, schedule, out_of_time);
  RepairRounds rounds(tools, schedule, repair, may_add_points);
  const auto poor_share = [&] { return share(count_below(mesh, measure.of_angle(schedule.target_angle)), mesh); };
  const auto raise = [&](unsigned round, unsigned smoothing_steps, double poor = 1) {
    const double least = tools.bad_cells_may_spread ? 0 : measure.bad();
    const double floor = std::clamp(shape_at_percentile(mesh, schedule.floor_percentile, context.threads), least,
                                    measure.of_angle(schedule.mean_floor_angle));
    raise_mean(tools, floor, smoothing_steps, context, poor);
    const bool is_poor = poor_share() > schedule.many_poor;
    return round + 1 < (is_poor ? schedule.mean_rounds_if_poor : schedule.mean_rounds) ? Next::again : Next::done;
  };
  const PassRunner passes(mesh, context, out_of_time);

  mesh.sort_cells(context.threads);
  passes.run({.name = "the mean raised",
              .round = [&](unsigned k) { return raise(k, schedule.smoothing_steps / 2); },
              .most_rounds = schedule.mean_rounds_if_poor});
  passes.run({.name = "poor cells repaired, the worst first",
              .round = [&](unsigned k) { return rounds.round(k); },
              .most_rounds = schedule.repair_rounds});
  for (const double room : schedule.sliver_rooms) {
    repair.forget_failed_points();
    passes.run({.name = "slivers repaired by points close to others",
                .round = [&](unsigned) { return repair_slivers(tools, schedule, repair, room); },
                .most_rounds = schedule.sliver_rounds});
  }
  mend_what_is_left({tools, schedule, passes, context, out_of_time});
  // Repair considers only the worst cells. If it has given up many of them, the other cells may have any shape, so the
  // mean shape of all cells is raised here.
  const double poor = measure.of_angle(schedule.target_angle + schedule.good_above_target);
  passes.run({.name = "the mean raised where much is poor",
              .round = [&](unsigned k) { return raise(k, schedule.smoothing_steps, poor); },
              .most_rounds = schedule.mean_rounds_if_poor,
              .applies = poor_share() > schedule.many_poor});
  passes.once(
      "bad cells searched that nothing forces",
      [&] { rescue_free_cells(tools, rescue_below(measure.bad(), schedule), *judge, out_of_time); },
      rescues_bad && judge);
}

}  // namespace geomesh::remesh

// SPDX-License-Identifier: MIT

#include "remesh/operations/improve.hpp"

#include <algorithm>
#include <array>
#include <chrono>

#include "quality/measure/shape.hpp"
#include "remesh/passes/improve_passes.hpp"
#include "remesh/passes/passes.hpp"
#include "remesh/rescue/bad_cells.hpp"
#include "remesh/rescue/rescue_sweeps.hpp"

namespace geomesh::remesh {

namespace {

/// What a level does, pass by pass.
struct Schedule {
  unsigned even_passes;  ///< flips and moves that raise the mean
  unsigned repair_passes;
  double target_angle;     ///< cells below (in the weighted measure) are repaired
  double insertion_angle;  ///< below this also by new points
  unsigned smoothing_steps;
  double least_rise;  ///< of the worst shape about a vertex that moves in repair, as a factor: less is hardly worth its
                      ///< time
  unsigned last_passes;  ///< over the worst alone, with points closer to others
  double progress;       ///< share of the poor cells of the best pass so far to which the next must bring their number
};

Schedule schedule_of(QualityLevel level) {
  switch (level) {
    case QualityLevel::fast:
      return {1, 2, 20, 0, 6, 1.05, 0, 0.9};
    case QualityLevel::best:
      return {2, 60, 36, 30, 20, 1.0005, 20, 1.02};
    default:
      return {2, 8, 32, 26, 12, 1.03, 8, 0.9};
  }
}

constexpr unsigned first_pass_with_points = 2;
constexpr double enough_visits =
    1.5;                            ///< of poor cells, by the number of all, before a lack of progress ends the repair
constexpr double worst_angle = 16;  ///< progress is measured on cells below this too
constexpr double rescue_angle = 12;
constexpr std::array rescue_rooms{0.15, 0.03};
/// Slivers that are more than this share of all cells are forced by the surfaces: then the worst alone are rescued,
/// with points however near.
constexpr double few_slivers = 0.05, forced_rescue_share = 0.001, forced_rescue_room = 0.01;
constexpr double evening_floor_angle = 30;
constexpr double many_poor = 0.1;
constexpr unsigned thinning_passes = 4, rescue_steps = 40;
constexpr unsigned poor_even_passes = 4;  ///< times as many as before the repair, which left many poor cells

class Improver {
 public:
  Improver(Toolbox& tools, const RefineOptions& options, const RunContext& context, const FreeCellJudge* judge)
      : tools_(tools),
        mesh_(tools.mesh),
        context_(context),
        judge_(judge),
        schedule_(schedule_of(options.quality)),
        may_add_points_(options.size_surfaces || options.honour != Honour::exact),
        budget_(options.time_budget),
        start_(std::chrono::steady_clock::now()) {}

  void run() {
    mesh_.sort_cells();
    for (unsigned k = 0; k < schedule_.even_passes && !out_of_time(); ++k) even_out();
    std::size_t idle = 0, fewest = mesh_.n_cells(), fewest_worst = mesh_.n_cells();
    for (unsigned k = 0; k < schedule_.repair_passes && idle < 2 && !out_of_time(); ++k) {
      const std::vector<BadCell> bad = cells_below(mesh_, mesh_.measure().of_angle(schedule_.target_angle));
      // Where surfaces force poor shapes everywhere, repair only moves them about: passes that do not lower their
      // number end it.
      const std::size_t worst = count_below(bad, mesh_.measure().of_angle(worst_angle));
      const auto falls = [&](std::size_t now, std::size_t least) {
        return static_cast<double>(now) <= schedule_.progress * static_cast<double>(least);
      };
      const bool costly = static_cast<double>(visited_) > enough_visits * static_cast<double>(mesh_.n_cells());
      const bool all_tried = k > (may_add_points_ ? first_pass_with_points : 0);
      if ((costly || !may_add_points_) && all_tried && !falls(bad.size(), fewest) && !falls(worst, fewest_worst)) break;
      fewest = std::min(fewest, bad.size());
      fewest_worst = std::min(fewest_worst, worst);
      context_.report(k, schedule_.repair_passes);
      const std::size_t n = repair(bad, k);
      ++tools_.statistics.passes;
      idle = n == 0 ? idle + 1 : 0;
    }
    const bool rescues_bad = schedule_.last_passes > 0 && !tools_.bad_cells_may_spread;
    const OutOfTime late = [&] { return out_of_time(); };
    if (schedule_.last_passes > 0) rescue_worst();
    if (rescues_bad) {
      thin_out();
      rescue_bad_cells(tools_, rescue_rule(), late);
    }
    if (is_poor_altogether())
      for (unsigned k = 0; k < poor_even_passes * schedule_.even_passes && !out_of_time(); ++k) even_out();
    if (rescues_bad && judge_) rescue_free_cells(tools_, rescue_rule(), *judge_, late);
  }

 private:
  /// The few cells that are still slivers may have points nearer to others than sizes ask: worse than that is a bad
  /// angle.
  void rescue_worst() {
    may_add_points_ = true;
    for (const double room : rescue_rooms) {
      for (Attempt& a : tried_) a.what = std::min(a.what, Tried::collapse);
      for (unsigned k = 0; k < schedule_.last_passes && !out_of_time(); ++k) {
        if (rescue_pass(room) == 0) break;
        ++tools_.statistics.passes;
      }
    }
  }
  std::size_t rescue_pass(double room) {
    std::vector<BadCell> worst = cells_below(mesh_, mesh_.measure().of_angle(rescue_angle));
    const double n_cells = static_cast<double>(mesh_.n_cells());
    const bool are_forced = static_cast<double>(worst.size()) > few_slivers * n_cells;
    if (are_forced) worst.resize(static_cast<std::size_t>(forced_rescue_share * n_cells));
    room_ = are_forced ? forced_rescue_room : room;
    return repair(worst, first_pass_with_points);
  }

  /// Points that the rescue put near others in vain, or that later ones have made needless, would be out of size for
  /// nothing.
  void thin_out() {
    const double floor = std::max(mesh_.measure().of_angle(rescue_angle), first_percentile());
    for (unsigned k = 0; k < thinning_passes && !out_of_time(); ++k)
      if (thin_out_inside(tools_, floor, context_) + thin_out_surfaces(floor) == 0) break;
  }

  /// Where surfaces may be remeshed, edges on them too.
  std::size_t thin_out_surfaces(double floor) {
    return tools_.guard.exact() ? 0 : remesh::thin_out_surfaces(tools_, floor, context_);
  }

  RescueRule rescue_rule() const { return {mesh_.measure().bad(), schedule_.smoothing_steps, rescue_steps}; }

  /// Before the repair, which looks at the worst alone; and after it where it had to give up on many cells, since what
  /// it exchanged about those is arbitrary but for the worst. A few of the cells may get worse for the many.
  void even_out() {
    const double least = tools_.bad_cells_may_spread ? 0 : mesh_.measure().bad();
    const double floor = std::clamp(first_percentile(), least, mesh_.measure().of_angle(evening_floor_angle));
    raise_mean(tools_, floor, schedule_.smoothing_steps / 2, context_, flips_in_vain_);
  }
  double first_percentile() const {
    std::vector<double> shapes;
    for (CellIndex c = 0; c < mesh_.n_slots(); ++c)
      if (mesh_.is_live(c)) shapes.push_back(mesh_.shape_of(c));
    const auto at = shapes.begin() + static_cast<std::ptrdiff_t>(0.01 * static_cast<double>(shapes.size()));
    std::nth_element(shapes.begin(), at, shapes.end());
    return *at;
  }

  bool is_poor_altogether() const {
    const std::size_t n = cells_below(mesh_, mesh_.measure().of_angle(schedule_.target_angle)).size();
    return static_cast<double>(n) > many_poor * static_cast<double>(mesh_.n_cells());
  }

  bool out_of_time() {
    context_.check_cancelled();
    if (!(budget_ > 0)) return false;
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    if (spent > budget_) tools_.statistics.out_of_time = true;
    return tools_.statistics.out_of_time;
  }

  static std::size_t count_below(const std::vector<BadCell>& sorted, double limit) {
    return static_cast<std::size_t>(
        std::partition_point(sorted.begin(), sorted.end(), [&](const BadCell& b) { return b.shape < limit; }) -
        sorted.begin());
  }

  std::size_t repair(const std::vector<BadCell>& bad, unsigned pass) {
    std::size_t n = 0;
    for (const BadCell& b : bad) {
      if (++visited_ % 64 == 0 && out_of_time()) break;
      if (is_left(mesh_, b) && repair_cell(b, pass)) ++n;
    }
    return n;
  }

  /// How much of a repair was tried in vain about a cell, each including what is before it.
  enum class Tried : std::uint8_t { nothing, flips_and_moves, collapse, points };

  /// What is known to fail: nothing about the cell has changed since.
  Tried tried_at(CellIndex c) const {
    if (c >= tried_.size()) return Tried::nothing;
    return changed_since(mesh_, bad_cell(mesh_, c), tried_[c].when) ? Tried::nothing : tried_[c].what;
  }
  void remember(CellIndex c, Tried what) {
    if (c >= tried_.size()) tried_.resize(mesh_.n_slots() + mesh_.n_slots() / 8 + 1);
    tried_[c] = {mesh_.tick(), what};
  }

  bool repair_cell(const BadCell& b, unsigned pass) {
    const Tried tried = tried_at(b.cell);
    if (tried < Tried::flips_and_moves) {
      if (flip_about_cell(tools_, b.cell)) return true;
      bool moved = false;
      for (const VertexIndex v : b.vertices) moved |= smooth(v);
      if (moved) return true;
      remember(b.cell, Tried::flips_and_moves);
    }
    if (pass == 0) return false;
    if (tried < Tried::collapse) {
      if (collapse_about_cell(tools_, b.cell)) return true;
      remember(b.cell, Tried::collapse);
    }
    if (!may_add_points_ || pass < first_pass_with_points || tried == Tried::points) return false;
    if (b.shape < mesh_.measure().of_angle(schedule_.insertion_angle) && add_point_about_cell(tools_, b.cell, room_))
      return true;
    remember(b.cell, Tried::points);
    return false;
  }

  /// Not again where the last attempt was in vain and nothing about the vertex has changed since.
  bool smooth(VertexIndex v) {
    if (v >= smoothed_.size()) smoothed_.resize(mesh_.n_vertices() + mesh_.n_vertices() / 8 + 1, 0);
    if (smoothed_[v] >= mesh_.changed_at(v)) return false;
    if (smooth_vertex(tools_, v,
                      {schedule_.smoothing_steps, mesh_.measure().of_angle(schedule_.target_angle + 4),
                       SmoothGoal::worst, 0, schedule_.least_rise}))
      return true;
    smoothed_[v] = mesh_.tick();
    return false;
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  const RunContext& context_;
  const FreeCellJudge* judge_;
  Schedule schedule_;
  bool may_add_points_;
  double budget_;
  double room_ = usual_room;
  std::size_t visited_ = 0;  // poor cells, over all passes
  struct Attempt {
    std::uint64_t when = 0;  ///< the mesh's time
    Tried what = Tried::nothing;
  };
  std::vector<Attempt> tried_;  // by cell
  FlipsInVain flips_in_vain_;
  std::vector<std::uint64_t> smoothed_;  // by vertex: when moving it was last in vain
  std::chrono::steady_clock::time_point start_;
};

}  // namespace

void improve_mesh(Toolbox& tools, const RefineOptions& options, const RunContext& context, const FreeCellJudge* judge) {
  Improver(tools, options, context, judge).run();
}

}  // namespace geomesh::remesh

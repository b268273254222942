// SPDX-License-Identifier: MIT
#include "remesh/passes/worst_first_repair.hpp"

#include <algorithm>

namespace geomesh::remesh {

namespace {

constexpr std::size_t visits_between_looks = 64;  ///< at the clock

}  // namespace

std::size_t WorstFirstRepair::run(const std::vector<BadCell>& bad, RepairBy deepest, double room) {
  std::size_t n = 0;
  for (const BadCell& b : bad) {
    if (++n_visited_ % visits_between_looks == 0 && out_of_time_()) break;
    if (is_left(mesh_, b) && repair(b, deepest, room)) ++n;
  }
  return n;
}

void WorstFirstRepair::forget_failed_points() {
  for (Attempt& a : tried_) a.what = std::min(a.what, RepairBy::contraction);
}

/// Returns the operations that have failed at the cell since something around it was changed last.
RepairBy WorstFirstRepair::tried_at(CellIndex c) const {
  if (c >= tried_.size()) return RepairBy::nothing;
  return changed_since(mesh_, bad_cell(mesh_, c), tried_[c].when) ? RepairBy::nothing : tried_[c].what;
}

void WorstFirstRepair::remember(CellIndex c, RepairBy what) {
  if (c >= tried_.size()) tried_.resize(mesh_.n_slots() + mesh_.n_slots() / 8 + 1);
  tried_[c] = {mesh_.tick(), what};
}

bool WorstFirstRepair::repair(const BadCell& b, RepairBy deepest, double room) {
  const RepairBy tried = tried_at(b.cell);
  if (tried < RepairBy::flips_and_moves) {
    if (flip_about_cell(tools_, b.cell)) return true;
    bool moved = false;
    for (const VertexIndex v : b.vertices) moved |= smooth(v);
    if (moved) return true;
    remember(b.cell, RepairBy::flips_and_moves);
  }
  if (deepest < RepairBy::contraction) return false;
  if (tried < RepairBy::contraction) {
    if (collapse_about_cell(tools_, b.cell)) return true;
    remember(b.cell, RepairBy::contraction);
  }
  if (deepest < RepairBy::points || tried == RepairBy::points) return false;
  const double worth_points = mesh_.measure().of_angle(schedule_.insertion_angle);
  if (b.shape < worth_points && add_point_about_cell(tools_, b.cell, room)) return true;
  remember(b.cell, RepairBy::points);
  return false;
}

bool WorstFirstRepair::smooth(VertexIndex v) {
  if (v >= smoothed_.size()) smoothed_.resize(mesh_.n_vertices() + mesh_.n_vertices() / 8 + 1, 0);
  if (smoothed_[v] >= mesh_.changed_at(v)) return false;
  const double good = mesh_.measure().of_angle(schedule_.target_angle + schedule_.good_above_target);
  const SmoothRule rule{
      .max_steps = schedule_.smoothing_steps, .good_enough = good, .least_rise = schedule_.least_rise};
  if (smooth_vertex(tools_, v, rule)) return true;
  smoothed_[v] = mesh_.tick();
  return false;
}

}  // namespace geomesh::remesh

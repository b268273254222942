// SPDX-License-Identifier: MIT
#include "remesh/rescue/rescue_sweeps.hpp"

#include <algorithm>

#include "remesh/operations/improve_schedule.hpp"
#include "remesh/rescue/bad_cells.hpp"
#include "remesh/rescue/rescue_search.hpp"

namespace geomesh::remesh {

namespace {

std::vector<BadCell> free_cells(const DomainMesh& mesh, const FreeCellJudge& judge) {
  std::vector<BadCell> bad;
  for (const CellIndex c : judge.find(mesh)) bad.push_back(bad_cell(mesh, c));
  return bad;
}

}  // namespace

void rescue_bad_cells(Toolbox& tools, const RescueRule& rule, const OutOfTime& out_of_time) {
  std::uint64_t last_sweep = 0;
  for (unsigned k = 0; k < rescue_limits.bad_sweeps; ++k) {
    const std::uint64_t this_sweep = tools.mesh.tick();
    std::size_t n = 0;
    for (const BadCell& b : cells_below(tools.mesh, rule.bad_shape)) {
      if (out_of_time()) return;
      if (changed_since(tools.mesh, b, last_sweep) && is_left(tools.mesh, b) && rescue_cell(tools, b.cell, rule)) ++n;
    }
    if (n == 0) return;
    last_sweep = this_sweep;
  }
}

void rescue_free_cells(Toolbox& tools, const RescueRule& rule, const FreeCellJudge& judge,
                       const OutOfTime& out_of_time) {
  const DomainMesh& mesh = tools.mesh;
  const std::size_t n_trials =
      std::clamp(mesh.n_cells() / rescue_limits.cells_a_trial, rescue_limits.least_trials, rescue_limits.most_trials);
  RescueSearch search{Chooser(0), rescue_limits.first_trials, n_trials, out_of_time, judge};
  std::vector<BadCell> bad = free_cells(mesh, judge);
  std::uint64_t last_sweep = 0;
  for (unsigned k = 0; k < rescue_limits.free_sweeps && !bad.empty(); ++k) {
    const std::uint64_t this_sweep = tools.mesh.tick();
    std::size_t n = 0;
    for (const BadCell& b : bad) {
      if (out_of_time()) return;
      if (!is_left(mesh, b) || !(mesh.shape_of(b.cell) < rule.bad_shape)) continue;
      const bool is_rescued = changed_since(mesh, b, last_sweep) &&
                              (rescue_cell(tools, b.cell, rule) || rescue_cell_by_openings(tools, b.cell, rule));
      n += is_rescued || rescue_cell_by_search(tools, b.cell, rule, search);
    }
    if (n == 0 && search.trials_left == 0) return;
    last_sweep = this_sweep;
    if (n < bad.size()) search.trials_a_cell *= 2;
    const bool is_changed =
        std::any_of(bad.begin(), bad.end(), [&](const BadCell& b) { return changed_since(mesh, b, this_sweep); });
    if (is_changed) bad = free_cells(mesh, judge);
  }
}

}  // namespace geomesh::remesh

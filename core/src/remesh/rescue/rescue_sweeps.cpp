// SPDX-License-Identifier: MIT
#include "remesh/rescue/rescue_sweeps.hpp"

#include <algorithm>

#include "remesh/rescue/bad_cells.hpp"

namespace geomesh::remesh {

namespace {

constexpr unsigned bad_sweeps = 4, free_sweeps = 64;
/// Of the search about cells that nothing forces: about one of them in the first sweep, twice as many after each sweep
/// that has left one of them as it was; and about all of them together by the number of the mesh's cells, so that it
/// takes less than a fifth of the whole, within bounds.
constexpr std::size_t first_trials = 200, least_trials = 500, most_trials = 60'000, cells_a_trial = 25;

std::vector<BadCell> free_cells(const DomainMesh& mesh, const FreeCellJudge& judge) {
  std::vector<BadCell> bad;
  for (const CellIndex c : judge.find(mesh)) bad.push_back(bad_cell(mesh, c));
  return bad;
}

}  // namespace

void rescue_bad_cells(Toolbox& tools, const RescueRule& rule, const OutOfTime& out_of_time) {
  std::uint64_t last_sweep = 0;
  for (unsigned k = 0; k < bad_sweeps; ++k) {
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
  RescueSearch search{Chooser(0), first_trials, std::clamp(mesh.n_cells() / cells_a_trial, least_trials, most_trials),
                      out_of_time, judge};
  std::vector<BadCell> bad = free_cells(mesh, judge);
  std::uint64_t last_sweep = 0;
  for (unsigned k = 0; k < free_sweeps && !bad.empty(); ++k) {
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

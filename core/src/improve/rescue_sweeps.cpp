// SPDX-License-Identifier: MIT
#include "improve/rescue_sweeps.hpp"

#include <algorithm>

#include "improve/bad_cells.hpp"

namespace geomesh::remesh {

namespace {

constexpr unsigned bad_sweeps = 4, free_sweeps = 64;
/// Of the search about cells that nothing forces: about one of them in the first sweep, twice as many after each sweep that has left one of them as it was; and about
/// all of them together, least_trials or by the number of the mesh's cells, so that it takes less than a fifth of the whole.
constexpr std::size_t first_trials = 200, least_trials = 500, cells_a_trial = 25;

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

void rescue_free_cells(Toolbox& tools, const RescueRule& rule, const FreeCellJudge& judge, const OutOfTime& out_of_time) {
  const DomainMesh& mesh = tools.mesh;
  RescueSearch search{Chooser(0), first_trials, std::max(least_trials, mesh.n_cells() / cells_a_trial), out_of_time, judge};
  std::uint64_t last_sweep = 0;
  for (unsigned k = 0; k < free_sweeps; ++k) {
    const std::uint64_t this_sweep = tools.mesh.tick();
    std::vector<BadCell> bad;
    for (const CellIndex c : judge.find(mesh)) bad.push_back(bad_cell(mesh, c));
    if (bad.empty()) return;
    std::size_t n = 0;
    for (const BadCell& b : bad) {
      if (out_of_time()) return;
      if (!is_left(mesh, b) || !(mesh.shape_of(b.cell) < rule.bad_shape)) continue;
      const bool is_rescued = changed_since(mesh, b, last_sweep) && (rescue_cell(tools, b.cell, rule) || rescue_cell_by_openings(tools, b.cell, rule));
      n += is_rescued || rescue_cell_by_search(tools, b.cell, rule, search);
    }
    if (n == 0 && search.trials_left == 0) return;
    last_sweep = this_sweep;
    if (n < bad.size()) search.trials_a_cell *= 2;
  }
}

}  // namespace geomesh::remesh

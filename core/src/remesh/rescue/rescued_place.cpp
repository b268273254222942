// SPDX-License-Identifier: MIT
#include "remesh/rescue/rescued_place.hpp"

#include <algorithm>

#include "remesh/operations/improve.hpp"
#include "remesh/rescue/neighbourhood.hpp"
#include "remesh/rescue/openings.hpp"

namespace geomesh::remesh {

bool RescuedPlace::mend(CellIndex c) {
  return flip_about_cell(tools_, c) || move_vertices(c) || collapse_about_cell(tools_, c) ||
         add_point_about_cell(tools_, c, rescue_limits.room);
}

bool RescuedPlace::move_vertices(CellIndex c) {
  const SmoothRule rule{.max_steps = rule_.smoothing_steps,
                        .least_rise = rescue_limits.notable_rise,
                        .least_gain = 0,
                        .slides_on_edges = true};
  bool moved = false;
  for (const VertexIndex v : Tetrahedron(mesh_.vertices(c))) moved |= smooth_vertex(tools_, v, rule);
  return moved;
}

void RescuedPlace::mend_all() {
  given_up_.clear();
  for (unsigned step = 1; step < rule_.max_steps; ++step) {
    const CellIndex worst = next_bad();
    if (worst == no_cell) break;
    if (mend(worst)) continue;
    given_up_.push_back(mesh_.vertices(worst));
    if (given_up_.size() == rescue_limits.most_given_up) break;
  }
}

CellIndex RescuedPlace::next_bad() const {
  CellIndex worst = no_cell;
  double least = rule_.bad_shape;
  const auto consider = [&](CellIndex c) {
    if (!mesh_.is_live(c) || !(mesh_.shape_of(c) < least)) return;
    if (std::find(given_up_.begin(), given_up_.end(), mesh_.vertices(c)) != given_up_.end()) return;
    least = mesh_.shape_of(c);
    worst = c;
  };
  if (scope_ == MendScope::own)
    mesh_.for_each_cell_of_trial(consider);
  else
    mesh_.for_each_trial_cell(consider);
  return worst;
}

bool RescuedPlace::is_seed_as_it_was() const {
  return is_left(mesh_, seed_) && !(mesh_.shape_of(seed_.cell) > rescue_limits.notable_rise * seed_.shape);
}

Tally RescuedPlace::before() const {
  Tally tally;
  mesh_.for_each_cell_before_trial([&](double shape) { tally.add(shape, rule_.bad_shape); });
  return tally;
}

Tally RescuedPlace::after() const {
  Tally tally;
  mesh_.for_each_trial_cell([&](CellIndex c) {
    if (mesh_.is_live(c)) tally.add(mesh_.shape_of(c), rule_.bad_shape);
  });
  return tally;
}

std::vector<CellIndex> RescuedPlace::bad_cells_of_trial() const {
  std::vector<CellIndex> bad;
  mesh_.for_each_cell_of_trial([&](CellIndex c) {
    if (mesh_.shape_of(c) < rule_.bad_shape) bad.push_back(c);
  });
  return bad;
}

bool RescuedPlace::clear() {
  std::size_t n = 0;
  for (const VertexIndex u : movable_about(tools_, seed_.vertices))
    if (mesh_.kind(u) == VertexKind::inside)
      n += try_collapse(tools_, u, nearest_neighbour(tools_, u), CollapseRule::coarsen, opening_shape);
  return n > 0;
}

}  // namespace geomesh::remesh

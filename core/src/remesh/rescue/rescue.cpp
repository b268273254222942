// SPDX-License-Identifier: MIT
#include "remesh/rescue/rescue.hpp"

#include <algorithm>
#include <limits>

#include "common/sort_unique.hpp"
#include "remesh/operations/improve.hpp"
#include "remesh/rescue/trial.hpp"

namespace geomesh::remesh {

namespace {

using Edge = std::array<VertexIndex, 2>;

/// The bad cells that are repaired during a trial (a sequence of operations that can be undone).
enum class MendScope : bool {
  touched,  ///< bad cells that the undoable trial has created or changed, and their neighbours
  own,      ///< only bad cells that operations of the undoable trial have created or changed
};

enum class NewPoints : bool { no, yes };

/// The surroundings of a bad cell during a trial: compares the bad cells there with those before, and repairs them.
class RescuedPlace {
 public:
  RescuedPlace(Toolbox& tools, CellIndex seed, const RescueRule& rule, NewPoints points = NewPoints::yes)
      : tools_(tools), mesh_(tools.mesh), rule_(rule), points_(points), seed_(bad_cell(mesh_, seed)) {}

  /// Returns the bad cell that is to be improved, as it was before any operation.
  const BadCell& seed() const { return seed_; }
  void set_seed(CellIndex c) { seed_ = bad_cell(mesh_, c); }
  void set_scope(MendScope scope) { scope_ = scope; }

  /// Tries operations around the cell in turn, and performs the first one that raises the worst shape there.
  bool mend(CellIndex c) {
    return flip_about_cell(tools_, c) || move_vertices(c) || collapse_about_cell(tools_, c) ||
           (points_ == NewPoints::yes && add_point_about_cell(tools_, c, rescue_limits.room));
  }
  /// Improves the worst bad cell repeatedly, until no bad cell is left or too many could not be improved.
  void mend_all() {
    given_up_.clear();
    for (unsigned step = 1; step < rule_.max_steps; ++step) {
      const CellIndex worst = next_bad();
      if (worst == no_cell) break;
      if (mend(worst)) continue;
      given_up_.push_back(mesh_.vertices(worst));
      if (given_up_.size() == rescue_limits.most_given_up) break;
    }
  }
  /// Returns the worst of the bad cells to be repaired whose repair has not failed yet, or no_cell.
  CellIndex next_bad() const {
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
  void forget_given_up() { given_up_.clear(); }

  /// Returns whether the first bad cell of the undoable trial exists and is hardly better: only other cells gained.
  bool is_seed_as_it_was() const {
    return is_left(mesh_, seed_) && !(mesh_.shape_of(seed_.cell) > rescue_limits.notable_rise * seed_.shape);
  }
  Tally before() const {
    Tally tally;
    mesh_.for_each_cell_before_trial([&](double shape) { tally.add(shape, rule_.bad_shape); });
    return tally;
  }
  Tally after() const {
    Tally tally;
    mesh_.for_each_trial_cell([&](CellIndex c) {
      if (mesh_.is_live(c)) tally.add(mesh_.shape_of(c), rule_.bad_shape);
    });
    return tally;
  }
  std::vector<CellIndex> bad_cells_of_trial() const {
    std::vector<CellIndex> bad;
    mesh_.for_each_cell_of_trial([&](CellIndex c) {
      if (mesh_.shape_of(c) < rule_.bad_shape) bad.push_back(c);
    });
    return bad;
  }

 private:
  bool move_vertices(CellIndex c) {
    const SmoothRule rule{.max_steps = rule_.smoothing_steps,
                          .least_rise = rescue_limits.notable_rise,
                          .least_gain = 0,
                          .slides_on_edges = true};
    bool moved = false;
    for (const VertexIndex v : Tetrahedron(mesh_.vertices(c))) moved |= smooth_vertex(tools_, v, rule);
    return moved;
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  RescueRule rule_;
  NewPoints points_;
  BadCell seed_;
  MendScope scope_ = MendScope::touched;
  std::vector<Tetrahedron> given_up_;  // bad cells that no operation has improved
};

enum class BadCells : bool { may_not_spread, may_spread };

/// Calls `open`, an operation near a bad cell that may worsen shapes, and repairs the cells around. Keeps all changes
/// if the shapes are clearly better as a whole.
template <class Open>
bool attempt(Toolbox& tools, RescuedPlace& place, BadCells spread, const Open& open) {
  Trial trial(tools);
  if (!open()) return false;
  tools.bad_cells_may_spread = spread == BadCells::may_spread;
  place.mend_all();
  if (place.is_seed_as_it_was() || !place.after().is_better_than(place.before())) return false;
  trial.keep();
  return true;
}

/// Returns the cells that share at least two vertices with the given cell, including that cell, in ascending order.
std::vector<CellIndex> cells_about(Toolbox& tools, const Tetrahedron& t) {
  std::vector<CellIndex> star, cells;
  for (const VertexIndex v : t) {
    tools.mesh.star(v, tools.work.marks, star);
    for (const CellIndex c : star)
      if (std::ranges::count_if(t, [&](VertexIndex w) { return tools.mesh.cells().has_vertex(c, w); }) > 1)
        cells.push_back(c);
  }
  sort_unique(cells);
  return cells;
}

/// Returns the edges (u, v) near the cell t that may be contracted by moving u to v: u is a movable vertex of t or of a
/// cell around t, and v is a vertex of t or the one nearest to u.
std::vector<Edge> edges_to_collapse(Toolbox& tools, const Tetrahedron& t) {
  std::vector<Edge> edges;
  for (const VertexIndex u : movable_about(tools, t)) edges.push_back({u, nearest_neighbour(tools, u)});
  for (const VertexIndex u : t)
    for (const VertexIndex v : t)
      if (u != v && tools.mesh.kind(u) != VertexKind::corner) edges.push_back({u, v});
  return edges;
}

/// Calls `rescue` for all bad cells, and then repeatedly for those whose surroundings have changed since.
template <class Rescue>
void sweep_bad_cells(Toolbox& tools, const RescueRule& rule, const OutOfTime& out_of_time, const Rescue& rescue) {
  std::uint64_t last_sweep = 0;
  for (unsigned k = 0; k < rescue_limits.bad_sweeps; ++k) {
    const std::uint64_t this_sweep = tools.mesh.tick();
    std::size_t n = 0;
    for (const BadCell& b : cells_below(tools.mesh, rule.bad_shape)) {
      if (out_of_time()) return;
      if (changed_since(tools.mesh, b, last_sweep) && is_left(tools.mesh, b) && rescue(b.cell)) ++n;
    }
    if (n == 0) return;
    last_sweep = this_sweep;
  }
}

/// The result of one trial of a search: no gain; a repaired cell; or another bad cell that the input does not impose,
/// from which the search continues.
enum class Outcome : std::uint8_t { none, mended, elsewhere };

class Searcher {
 public:
  Searcher(Toolbox& tools, CellIndex seed, const RescueRule& rule, RescueSearch& search)
      : tools_(tools), search_(search), place_(tools, seed, rule) {}

  /// Runs one trial, which alternates openings and repair. Each opening is around the worst cell that the previous
  /// repair has left; the first may remove all points around the bad cell.
  Outcome search_once() {
    Trial trial(tools_);
    Random& choose = search_.choose;
    place_.set_scope(choose.below(4) != 0 ? MendScope::own : MendScope::touched);
    tools_.bad_cells_may_spread = false;
    const bool clears = choose.below(rescue_limits.trials_a_clearing) == 0;
    CellIndex target = place_.seed().cell;
    for (unsigned k = 0; k < rescue_limits.most_openings && target != no_cell; ++k) {
      const bool is_open = k == 0 && clears ? clear_about(tools_, place_.seed().vertices) : open(target);
      if (!is_open) return Outcome::none;
      place_.mend_all();
      if (const Outcome outcome = judge_trial(); outcome != Outcome::none) {
        trial.keep();
        return outcome;
      }
      if (place_.after().deficit > place_.before().deficit + rescue_limits.hopeless) return Outcome::none;
      place_.forget_given_up();
      target = place_.next_bad();
    }
    return Outcome::none;
  }

 private:
  bool open(CellIndex target) {
    for (unsigned k = 0; k < rescue_limits.most_vain_openings; ++k)
      if (open_about_cell(tools_, target, search_.choose)) return true;
    return false;
  }

  /// Decides on the result of a trial. Next to cells that cannot be improved, the worst shape says nothing, and the
  /// number of bad cells little. The goal is that only bad cells imposed by the input are left. If another bad cell
  /// that the input does not impose has taken the place of the first, and the shapes are hardly worse, the search
  /// continues from that cell.
  Outcome judge_trial() {
    if (place_.is_seed_as_it_was()) return Outcome::none;
    const Tally was = place_.before(), is = place_.after();
    if (is.is_less_bad_than(was)) return Outcome::mended;
    if (is.worst < was.worst || is.n_bad > was.n_bad + rescue_limits.forced_instead) return Outcome::none;
    const std::vector<CellIndex> free = search_.judge.find_among(tools_.mesh, place_.bad_cells_of_trial());
    if (free.empty()) return Outcome::mended;
    if (free.size() > 1 || is.n_bad > was.n_bad || is.deficit > was.deficit + rescue_limits.detour)
      return Outcome::none;
    place_.set_seed(free.front());
    return Outcome::elsewhere;
  }

  Toolbox& tools_;
  RescueSearch& search_;
  RescuedPlace place_;
};

std::vector<BadCell> free_cells(const DomainMesh& mesh, const FreeCellJudge& judge) {
  std::vector<BadCell> bad;
  for (const CellIndex c : judge.find(mesh)) bad.push_back(bad_cell(mesh, c));
  return bad;
}

/// Returns the bad cells not imposed by the input after a sweep, worst first. Cells without a change around them keep
/// their former classification.
std::vector<BadCell> free_cells_after(const DomainMesh& mesh, const FreeCellJudge& judge,
                                      const std::vector<BadCell>& before, std::uint64_t sweep) {
  std::vector<BadCell> bad;
  for (const BadCell& b : before)
    if (is_left(mesh, b) && !changed_since(mesh, b, sweep)) bad.push_back(b);
  for (const CellIndex c : judge.find_since(mesh, sweep)) bad.push_back(bad_cell(mesh, c));
  std::ranges::stable_sort(bad, {}, &BadCell::shape);
  return bad;
}

/// Calls `change`, which changes the mesh at the vertex u. Keeps the change if the cells around can be repaired.
template <class Change>
bool change_mending(Toolbox& tools, VertexIndex u, const RescueRule& rule, const Change& change) {
  RescuedPlace place(tools, tools.mesh.incident_cell(u), rule, NewPoints::no);
  place.set_scope(MendScope::own);
  Trial trial(tools);
  if (!change()) return false;
  tools.bad_cells_may_spread = false;
  place.mend_all();
  const Tally was = place.before(), is = place.after();
  const bool is_kept =
      is.n_bad <= was.n_bad && is.deficit <= was.deficit && is.worst >= std::min(was.worst, rule.bad_shape);
  if (is_kept) trial.keep();
  return is_kept;
}

}  // namespace

bool rescue_cell(Toolbox& tools, CellIndex c, const RescueRule& rule) {
  RescuedPlace place(tools, c, rule);
  return attempt(tools, place, BadCells::may_spread, [&] { return place.mend(c); });
}

VainTrials vain_trials(std::size_t n_cells, std::size_t most) {
  return {std::clamp(n_cells / rescue_limits.cells_a_vain_opening, rescue_limits.least_vain, most)};
}

bool rescue_cell_by_openings(Toolbox& tools, CellIndex c, const RescueRule& rule, VainTrials& vain) {
  RescuedPlace place(tools, c, rule);
  const Tetrahedron t = place.seed().vertices;
  const std::vector<Edge> to_collapse = edges_to_collapse(tools, t);
  const std::size_t left_before = vain.left;
  for (const BadCells spread : {BadCells::may_not_spread, BadCells::may_spread}) {
    const auto opens = [&](const auto& open) {
      if (vain.left == 0) return false;
      --vain.left;
      if (!attempt(tools, place, spread, open)) return false;
      vain.left = left_before;
      return true;
    };
    if (opens([&] { return clear_about(tools, t); })) return true;
    for (const auto& e : edge_vertices)
      if (opens([&] { return split_edge(tools, c, t[e[0]], t[e[1]], opening_shape).has_value(); })) return true;
    for (const Edge& e : to_collapse)
      if (opens([&] { return try_collapse(tools, e[0], e[1], CollapseRule::coarsen, opening_shape); })) return true;
    for (const CellIndex k : cells_about(tools, t))
      if (opens([&] {
            const Vec3 middle = tools.mesh.middle(tools.mesh.vertices(k));
            return insert_inside(tools, middle, k, {.min_shape = opening_shape}).has_value();
          }))
        return true;
  }
  return false;
}

bool collapse_mending(Toolbox& tools, VertexIndex u, VertexIndex v, const RescueRule& rule) {
  const auto collapse = [&] { return try_collapse(tools, u, v, CollapseRule::coarsen, opening_shape); };
  return change_mending(tools, u, rule, collapse);
}

bool stretch_mending(Toolbox& tools, VertexIndex u, VertexIndex v, double length, const RescueRule& rule) {
  return change_mending(tools, u, rule, [&] { return try_stretch(tools, u, v, length, opening_shape); });
}

bool rescue_cell_by_search(Toolbox& tools, CellIndex c, const RescueRule& rule, RescueSearch& search) {
  Searcher searcher(tools, c, rule, search);
  for (std::size_t k = 0; k < search.trials_a_cell && search.trials_left > 0 && !search.out_of_time(); ++k) {
    --search.trials_left;
    if (searcher.search_once() == Outcome::mended) return true;
  }
  return false;
}

void rescue_bad_cells(Toolbox& tools, const RescueRule& rule, const OutOfTime& out_of_time) {
  sweep_bad_cells(tools, rule, out_of_time, [&](CellIndex c) { return rescue_cell(tools, c, rule); });
}

void rescue_flat_cells(Toolbox& tools, const RescueRule& rule, std::size_t most_vain, const OutOfTime& out_of_time) {
  VainTrials vain = vain_trials(tools.mesh.n_cells(), most_vain), vain_openings = vain;
  sweep_bad_cells(tools, rule, out_of_time, [&](CellIndex c) {
    if (vain.left == 0) return false;
    if (rescue_cell(tools, c, rule)) return true;
    --vain.left;
    return vain_openings.left > 0 && rescue_cell_by_openings(tools, c, rule, vain_openings);
  });
}

void rescue_free_cells(Toolbox& tools, const RescueRule& rule, const FreeCellJudge& judge,
                       const OutOfTime& out_of_time) {
  const DomainMesh& mesh = tools.mesh;
  const std::size_t n_trials =
      std::clamp(mesh.n_cells() / rescue_limits.cells_a_trial, rescue_limits.least_trials, rescue_limits.most_trials);
  RescueSearch search{Random(0), rescue_limits.first_trials, n_trials, out_of_time, judge};
  VainTrials vain = vain_trials(mesh.n_cells(), rescue_limits.most_vain);
  vain.left = std::max(vain.left, rescue_limits.least_vain_free);
  std::vector<BadCell> bad = free_cells(mesh, judge);
  std::uint64_t last_sweep = 0;
  for (unsigned k = 0; k < rescue_limits.free_sweeps && !bad.empty(); ++k) {
    const std::uint64_t this_sweep = tools.mesh.tick();
    std::size_t n = 0;
    for (const BadCell& b : bad) {
      if (out_of_time()) return;
      if (!is_left(mesh, b) || !(mesh.shape_of(b.cell) < rule.bad_shape)) continue;
      const bool is_rescued =
          changed_since(mesh, b, last_sweep) &&
          (rescue_cell(tools, b.cell, rule) || (vain.left > 0 && rescue_cell_by_openings(tools, b.cell, rule, vain)));
      n += is_rescued || rescue_cell_by_search(tools, b.cell, rule, search);
    }
    if (n == 0 && search.trials_left == 0) return;
    last_sweep = this_sweep;
    if (n < bad.size()) search.trials_a_cell *= 2;
    const bool is_changed =
        std::ranges::any_of(bad, [&](const BadCell& b) { return changed_since(mesh, b, this_sweep); });
    if (is_changed) bad = free_cells_after(mesh, judge, bad, this_sweep);
  }
}

}  // namespace geomesh::remesh

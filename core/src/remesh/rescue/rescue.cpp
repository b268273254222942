// SPDX-License-Identifier: MIT
#include "remesh/rescue/rescue.hpp"

#include <algorithm>
#include <limits>

#include "common/sort_unique.hpp"
#include "quality/measure/shape.hpp"
#include "remesh/operations/improve.hpp"
#include "remesh/rescue/bad_cells.hpp"
#include "remesh/rescue/openings.hpp"
#include "remesh/rescue/trial.hpp"

namespace geomesh::remesh {

namespace {

constexpr double room = 0.03;  ///< of a new point, as a share of the asked size
constexpr double notable_rise = 1.05;
constexpr double notable_relief = 0.02;  ///< of one cell's way from flat to good
constexpr std::size_t max_given_up = 3;  ///< cells about which all was in vain
constexpr unsigned max_openings = 8;     ///< of one sequence of a search
constexpr std::size_t trials_a_clearing = 4;
constexpr double hopeless = 2;  ///< lacking so much more than before, in cells that are flat
constexpr unsigned max_vain_openings = 12;
constexpr std::size_t forced_instead = 1;  ///< bad cells more, forced ones all, that one that is not may cost
constexpr double detour =
    0.2;  ///< lacking so much more, in cells that are flat, where a search goes on from another place

/// Bad cells about a place.
struct Tally {
  std::size_t n_bad = 0;
  double worst = 1;
  double deficit = 0;  ///< sum over the bad of what they lack, as a share
  void add(double shape, double bad_shape) {
    n_bad += shape < bad_shape;
    worst = std::min(worst, shape);
    deficit += std::max(1 - shape / bad_shape, 0.0);
  }
  bool is_better_than(const Tally& other) const {
    return worst >= other.worst &&
           (n_bad < other.n_bad || (n_bad == other.n_bad && worst > notable_rise * other.worst));
  }
  /// Beside cells that cannot be mended the worst says nothing: all together count.
  bool is_less_bad_than(const Tally& other) const {
    return worst >= other.worst &&
           (n_bad < other.n_bad || (n_bad == other.n_bad && deficit < other.deficit - notable_relief));
  }
};

class Rescue {
 public:
  Rescue(Toolbox& tools, CellIndex seed, const RescueRule& rule)
      : tools_(tools), mesh_(tools.mesh), rule_(rule), seed_(bad_cell(mesh_, seed)) {}

  bool run() {
    return attempt(true, [&] { return mend(seed_.cell); });
  }

  bool run_by_openings() { return run_by_openings(false) || run_by_openings(true); }

  bool run_by_search(RescueSearch& search) {
    for (std::size_t k = 0; k < search.trials_a_cell && search.trials_left > 0 && !search.out_of_time(); ++k) {
      --search.trials_left;
      if (search_once(search) == Outcome::mended) return true;
    }
    return false;
  }

 private:
  bool run_by_openings(bool may_spread) {
    const CellIndex seed = seed_.cell;
    const Tetrahedron& t = seed_.vertices;
    if (attempt(may_spread, [&] { return clear_about(t); })) return true;
    for (const auto& e : edge_vertices)
      if (attempt(may_spread, [&] { return split_edge(tools_, seed, t[e[0]], t[e[1]], opening_shape).has_value(); }))
        return true;
    for (const auto& [u, v] : edges_to_collapse(t))
      if (attempt(may_spread, [&] { return try_collapse(tools_, u, v, CollapseRule::coarsen, opening_shape); }))
        return true;
    for (const CellIndex c : cells_about(t))
      if (attempt(may_spread, [&] { return insert_inside(tools_, centroid(c), c, {0, opening_shape}).has_value(); }))
        return true;
    return false;
  }

  /// What comes of `open`, mended (by operations that make no more cells bad unless these `may_spread`), is kept where
  /// it is worth it.
  template <class Open>
  bool attempt(bool may_spread, const Open& open) {
    Trial trial(tools_);
    if (!open()) return false;
    tools_.bad_cells_may_spread = may_spread;
    mend_all();
    if (!is_worth_it()) return false;
    trial.keep();
    return true;
  }

  /// What a trial of a search is worth: nothing, no free cell, or one that is elsewhere now, from which to go on.
  enum class Outcome : std::uint8_t { none, mended, elsewhere };

  /// Openings and repair in turns, each opening about the worst cell that the repair before has left. The first one may
  /// be a clearing.
  Outcome search_once(RescueSearch& search) {
    Trial trial(tools_);
    Chooser& choose = search.choose;
    mends_own_alone_ = choose.below(4) != 0;
    tools_.bad_cells_may_spread = false;
    const bool clears = choose.below(trials_a_clearing) == 0;
    CellIndex target = seed_.cell;
    for (unsigned k = 0; k < max_openings && target != no_cell; ++k) {
      const bool is_open = k == 0 && clears ? clear_about(seed_.vertices) : open(target, choose);
      if (!is_open) return Outcome::none;
      mend_all();
      if (const Outcome outcome = judge_trial(search.judge); outcome != Outcome::none) {
        trial.keep();
        return outcome;
      }
      if (after().deficit > before().deficit + hopeless) return Outcome::none;
      given_up_.clear();
      target = next_bad();
    }
    return Outcome::none;
  }

  /// Beside cells that cannot be mended the worst tells nothing, and their number not much: what counts is that nothing
  /// is left that is not forced. Where one such cell has made way for another and the place is hardly worse, that one
  /// is the seed from now on.
  Outcome judge_trial(const FreeCellJudge& judge) {
    if (is_seed_as_it_was()) return Outcome::none;
    const Tally was = before(), is = after();
    if (is.is_less_bad_than(was)) return Outcome::mended;
    if (is.worst < was.worst || is.n_bad > was.n_bad + forced_instead) return Outcome::none;
    const std::vector<CellIndex> free = judge.find_among(mesh_, bad_cells_of_trial());
    if (free.empty()) return Outcome::mended;
    if (free.size() > 1 || is.n_bad > was.n_bad || is.deficit > was.deficit + detour) return Outcome::none;
    seed_ = bad_cell(mesh_, free.front());
    return Outcome::elsewhere;
  }
  std::vector<CellIndex> bad_cells_of_trial() const {
    std::vector<CellIndex> bad;
    mesh_.for_each_cell_of_trial([&](CellIndex c) {
      if (mesh_.shape_of(c) < rule_.bad_shape) bad.push_back(c);
    });
    return bad;
  }

  bool open(CellIndex target, Chooser& choose) {
    for (unsigned k = 0; k < max_vain_openings; ++k)
      if (open_about_cell(tools_, target, choose)) return true;
    return false;
  }

  void mend_all() {
    given_up_.clear();
    for (unsigned step = 1; step < rule_.max_steps; ++step) {
      const CellIndex worst = next_bad();
      if (worst == no_cell) break;
      if (mend(worst)) continue;
      given_up_.push_back(mesh_.vertices(worst));
      if (given_up_.size() == max_given_up) break;
    }
  }

  Vec3 centroid(CellIndex c) const {
    const Tetrahedron& t = mesh_.vertices(c);
    return 0.25 * (mesh_.point(t[0]) + mesh_.point(t[1]) + mesh_.point(t[2]) + mesh_.point(t[3]));
  }
  /// Those with two vertices of the cell at least, it among them.
  std::vector<CellIndex> cells_about(const Tetrahedron& t) {
    std::vector<CellIndex> star, cells;
    for (const VertexIndex v : t) {
      mesh_.star(v, tools_.work.marks, star);
      for (const CellIndex c : star)
        if (std::count_if(t.begin(), t.end(), [&](VertexIndex w) { return mesh_.topology().has_vertex(c, w); }) > 1)
          cells.push_back(c);
    }
    sort_unique(cells);
    return cells;
  }

  /// The cell's vertices and their neighbours that may move.
  std::vector<VertexIndex> movable_about(const Tetrahedron& t) {
    std::vector<CellIndex> star;
    std::vector<VertexIndex> about;
    for (const VertexIndex v : t) {
      mesh_.star(v, tools_.work.marks, star);
      for (const CellIndex c : star)
        for (const VertexIndex w : mesh_.vertices(c))
          if (mesh_.kind(w) != VertexKind::corner) about.push_back(w);
    }
    sort_unique(about);
    return about;
  }

  /// Removes the points inside about the cell, as many as go: where earlier repairs have crowded them.
  bool clear_about(const Tetrahedron& t) {
    std::size_t n = 0;
    for (const VertexIndex u : movable_about(t))
      if (mesh_.kind(u) == VertexKind::inside)
        n += try_collapse(tools_, u, nearest_neighbour(u), CollapseRule::coarsen, opening_shape);
    return n > 0;
  }

  /// Each movable vertex of the cell, and of the cells about it, into each of the cell's vertices or its nearest
  /// neighbour.
  std::vector<std::array<VertexIndex, 2>> edges_to_collapse(const Tetrahedron& t) {
    std::vector<std::array<VertexIndex, 2>> edges;
    for (const VertexIndex u : movable_about(t)) edges.push_back({u, nearest_neighbour(u)});
    for (const VertexIndex u : t)
      for (const VertexIndex v : t)
        if (u != v && mesh_.kind(u) != VertexKind::corner) edges.push_back({u, v});
    return edges;
  }
  VertexIndex nearest_neighbour(VertexIndex u) {
    std::vector<CellIndex> star;
    mesh_.star(u, tools_.work.marks, star);
    VertexIndex nearest = no_vertex;
    double least = std::numeric_limits<double>::infinity();
    for (const CellIndex c : star)
      for (const VertexIndex w : mesh_.vertices(c)) {
        const double d = squared_distance(mesh_.point(u), mesh_.point(w));
        if (w != u && (d < least || (d == least && w < nearest))) least = d, nearest = w;
      }
    return nearest;
  }

  /// The worst of the bad cells that the trial has touched (or made or changed, where its own alone are mended), but
  /// those where all was in vain.
  CellIndex next_bad() const {
    CellIndex worst = no_cell;
    double least = rule_.bad_shape;
    const auto consider = [&](CellIndex c) {
      if (!mesh_.is_live(c) || !(mesh_.shape_of(c) < least)) return;
      if (std::find(given_up_.begin(), given_up_.end(), mesh_.vertices(c)) != given_up_.end()) return;
      least = mesh_.shape_of(c);
      worst = c;
    };
    if (mends_own_alone_)
      mesh_.for_each_cell_of_trial(consider);
    else
      mesh_.for_each_trial_cell(consider);
    return worst;
  }

  /// Not where only others about the cell have gained.
  bool is_worth_it() const { return !is_seed_as_it_was() && after().is_better_than(before()); }
  bool is_seed_as_it_was() const {
    return is_left(mesh_, seed_) && !(mesh_.shape_of(seed_.cell) > notable_rise * seed_.shape);
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

  bool mend(CellIndex c) {
    return flip_about_cell(tools_, c) || move(c) || collapse_about_cell(tools_, c) ||
           add_point_about_cell(tools_, c, room);
  }
  bool move(CellIndex c) {
    bool moved = false;
    for (const VertexIndex v : Tetrahedron(mesh_.vertices(c)))
      moved |= smooth_vertex(tools_, v, {rule_.smoothing_steps, 2, SmoothGoal::worst, 0, notable_rise, 0, true});
    return moved;
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  RescueRule rule_;
  std::vector<Tetrahedron> given_up_;
  bool mends_own_alone_ = false;  ///< not bad cells beside those that came of the trial
  BadCell seed_;
};

}  // namespace

bool rescue_cell(Toolbox& tools, CellIndex c, const RescueRule& rule) { return Rescue(tools, c, rule).run(); }

bool rescue_cell_by_openings(Toolbox& tools, CellIndex c, const RescueRule& rule) {
  return Rescue(tools, c, rule).run_by_openings();
}

bool rescue_cell_by_search(Toolbox& tools, CellIndex c, const RescueRule& rule, RescueSearch& search) {
  return Rescue(tools, c, rule).run_by_search(search);
}

}  // namespace geomesh::remesh

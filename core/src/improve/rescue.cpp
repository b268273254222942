// SPDX-License-Identifier: MIT
#include "improve/rescue.hpp"

#include <algorithm>

#include "improve/trial.hpp"

namespace geomesh::remesh {

namespace {

constexpr double room = 0.03;  ///< of a new point, as a share of the asked size
constexpr double notable_rise = 1.05;
constexpr std::size_t max_given_up = 3;  ///< cells about which all was in vain

/// Bad cells about a place.
struct Tally {
  std::size_t n_bad = 0;
  double worst = 1;
  void add(double shape, double bad_shape) {
    n_bad += shape < bad_shape;
    worst = std::min(worst, shape);
  }
  bool is_better_than(const Tally& other) const {
    return worst >= other.worst && (n_bad < other.n_bad || (n_bad == other.n_bad && worst > notable_rise * other.worst));
  }
};

class Rescue {
 public:
  Rescue(Toolbox& tools, const RescueRule& rule) : tools_(tools), mesh_(tools.mesh), rule_(rule) {}

  bool run(CellIndex seed) {
    Trial trial(tools_);
    if (!mend(seed)) return false;
    for (unsigned step = 1; step < rule_.max_steps; ++step) {
      const CellIndex worst = next_bad();
      if (worst == no_cell) break;
      if (mend(worst)) continue;
      given_up_.push_back(mesh_.vertices(worst));
      if (given_up_.size() == max_given_up) break;
    }
    if (!after().is_better_than(before())) return false;
    trial.keep();
    return true;
  }

 private:
  /// The worst of the bad cells that came of the trial, but those where all was in vain.
  CellIndex next_bad() const {
    CellIndex worst = no_cell;
    double least = rule_.bad_shape;
    mesh_.for_each_trial_cell([&](CellIndex c) {
      if (!mesh_.is_live(c) || !(mesh_.shape_of(c) < least)) return;
      if (std::find(given_up_.begin(), given_up_.end(), mesh_.vertices(c)) != given_up_.end()) return;
      least = mesh_.shape_of(c);
      worst = c;
    });
    return worst;
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

  bool mend(CellIndex c) { return flip(c) || move(c) || collapse(c) || add_point(c); }

  bool flip(CellIndex c) {
    const Tetrahedron t = mesh_.vertices(c);
    for (const auto& e : edge_vertices)
      if (remove_edge(tools_, c, t[e[0]], t[e[1]])) return true;
    for (unsigned i = 0; i < 4; ++i)
      if (remove_face(tools_, c, i)) return true;
    return false;
  }
  bool move(CellIndex c) {
    bool moved = false;
    for (const VertexIndex v : Tetrahedron(mesh_.vertices(c)))
      moved |= smooth_vertex(tools_, v, {rule_.smoothing_steps, 2, SmoothGoal::worst, 0, notable_rise});
    return moved;
  }
  bool collapse(CellIndex c) {
    const Tetrahedron t = mesh_.vertices(c);
    for (const auto& e : edge_vertices)
      if (try_collapse(tools_, t[e[0]], t[e[1]], CollapseRule::improve) || try_collapse(tools_, t[e[1]], t[e[0]], CollapseRule::improve))
        return true;
    return false;
  }
  bool add_point(CellIndex c) {
    const Tetrahedron t = mesh_.vertices(c);
    for (const auto& e : edge_vertices)
      if (split_to_improve(tools_, c, t[e[0]], t[e[1]], room)) return true;
    return insert_to_improve(tools_, c, room);
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  RescueRule rule_;
  std::vector<Tetrahedron> given_up_;
};

}  // namespace

bool rescue_cell(Toolbox& tools, CellIndex c, const RescueRule& rule) { return Rescue(tools, rule).run(c); }

}  // namespace geomesh::remesh

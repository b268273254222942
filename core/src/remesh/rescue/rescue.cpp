// SPDX-License-Identifier: MIT
#include "remesh/rescue/rescue.hpp"

#include "remesh/rescue/neighbourhood.hpp"
#include "remesh/rescue/openings.hpp"
#include "remesh/rescue/rescued_place.hpp"
#include "remesh/rescue/trial.hpp"

namespace geomesh::remesh {

namespace {

/// Whether operations that mend may make more cells bad.
enum class BadCells : bool { may_not_spread, may_spread };

class Rescue {
 public:
  Rescue(Toolbox& tools, CellIndex seed, const RescueRule& rule) : tools_(tools), place_(tools, seed, rule) {}

  bool run() {
    return attempt(BadCells::may_spread, [&] { return place_.mend(place_.seed().cell); });
  }

  bool run_by_openings() { return run_by_openings(BadCells::may_not_spread) || run_by_openings(BadCells::may_spread); }

 private:
  bool run_by_openings(BadCells spread) {
    const CellIndex seed = place_.seed().cell;
    const Tetrahedron t = place_.seed().vertices;
    if (attempt(spread, [&] { return place_.clear(); })) return true;
    for (const auto& e : edge_vertices)
      if (attempt(spread, [&] { return split_edge(tools_, seed, t[e[0]], t[e[1]], opening_shape).has_value(); }))
        return true;
    for (const auto& [u, v] : edges_to_collapse(tools_, t))
      if (attempt(spread,
                  [&, u = u, v = v] { return try_collapse(tools_, u, v, CollapseRule::coarsen, opening_shape); }))
        return true;
    for (const CellIndex c : cells_about(tools_, t))
      if (attempt(spread, [&] { return insert_centroid(c); })) return true;
    return false;
  }

  bool insert_centroid(CellIndex c) {
    const InsertionRule rule{.spacing = 0, .min_shape = opening_shape};
    return insert_inside(tools_, centroid(tools_.mesh, c), c, rule).has_value();
  }

  /// What comes of `open`, mended, is kept where it is worth it.
  template <class Open>
  bool attempt(BadCells spread, const Open& open) {
    Trial trial(tools_);
    if (!open()) return false;
    tools_.bad_cells_may_spread = spread == BadCells::may_spread;
    place_.mend_all();
    if (place_.is_seed_as_it_was() || !place_.after().is_better_than(place_.before())) return false;
    trial.keep();
    return true;
  }

  Toolbox& tools_;
  RescuedPlace place_;
};

}  // namespace

bool rescue_cell(Toolbox& tools, CellIndex c, const RescueRule& rule) { return Rescue(tools, c, rule).run(); }

bool rescue_cell_by_openings(Toolbox& tools, CellIndex c, const RescueRule& rule) {
  return Rescue(tools, c, rule).run_by_openings();
}

}  // namespace geomesh::remesh

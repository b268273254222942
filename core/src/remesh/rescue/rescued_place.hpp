// SPDX-License-Identifier: MIT
/// @file
/// The place about a bad cell during a trial: how it stands beside how it was, and the repair of what is bad there.
#pragma once

#include <vector>

#include "remesh/rescue/bad_cells.hpp"
#include "remesh/rescue/rescue.hpp"
#include "remesh/rescue/tally.hpp"

namespace geomesh::remesh {

/// The bad cells that a trial mends.
enum class MendScope : bool {
  touched,  ///< all that it touched
  own,      ///< those that it made or changed
};

class RescuedPlace {
 public:
  RescuedPlace(Toolbox& tools, CellIndex seed, const RescueRule& rule)
      : tools_(tools), mesh_(tools.mesh), rule_(rule), seed_(bad_cell(mesh_, seed)) {}

  /// The cell that the trial is about, as it was.
  const BadCell& seed() const { return seed_; }
  void set_seed(CellIndex c) { seed_ = bad_cell(mesh_, c); }
  void set_scope(MendScope scope) { scope_ = scope; }

  /// One operation that raises the worst shape about the cell, the first that there is.
  bool mend(CellIndex c);
  /// Mends the worst, again and again, until none is left or too many were given up.
  void mend_all();
  /// The worst of the bad cells in scope that was not given up, or no_cell.
  CellIndex next_bad() const;
  void forget_given_up() { given_up_.clear(); }

  /// Whether the seed is there and hardly better: then others alone have gained.
  bool is_seed_as_it_was() const;
  Tally before() const;
  Tally after() const;
  std::vector<CellIndex> bad_cells_of_trial() const;

  /// Removes the points inside about the seed as it was, as many as go: where earlier repairs have crowded them.
  bool clear();

 private:
  bool move_vertices(CellIndex c);

  Toolbox& tools_;
  DomainMesh& mesh_;
  RescueRule rule_;
  BadCell seed_;
  MendScope scope_ = MendScope::touched;
  std::vector<Tetrahedron> given_up_;  // about which all was in vain
};

}  // namespace geomesh::remesh

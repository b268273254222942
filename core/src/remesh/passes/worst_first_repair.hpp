// SPDX-License-Identifier: MIT
/// @file
/// Repair of poor cells in the order of their shapes, worst first, by one local operation around each.
#pragma once

#include <functional>
#include <vector>

#include "remesh/operations/improve.hpp"
#include "remesh/operations/improve_schedule.hpp"
#include "remesh/rescue/bad_cells.hpp"

namespace geomesh::remesh {

/// Kinds of operations by which a cell is repaired. Each value includes the operations of the values before it.
enum class RepairBy : std::uint8_t { nothing, flips_and_moves, contraction, points };

class WorstFirstRepair {
 public:
  /// `tools` and `schedule` must outlive this object. `out_of_time` is polled; once it returns true, repair ends.
  WorstFirstRepair(Toolbox& tools, const ImproveSchedule& schedule, std::function<bool()> out_of_time)
      : tools_(tools), mesh_(tools.mesh), schedule_(schedule), out_of_time_(std::move(out_of_time)) {}

  /// Tries to improve each listed cell by flips and moves, then contractions, then new points, up to the kind
  /// `deepest`. New points keep the distance `room`, as a share of the target size, from others. A failed operation is
  /// repeated only after a change around the cell. Returns the number of cells around which something changed.
  std::size_t run(const std::vector<BadCell>& bad, RepairBy deepest, double room);

  /// Permits new points to be tried again where they failed, e.g. because they may be closer to others then.
  void forget_failed_points();

 private:
  RepairBy tried_at(CellIndex c) const;
  void remember(CellIndex c, RepairBy what);
  bool repair(const BadCell& b, RepairBy deepest, double room);
  bool smooth(VertexIndex v);

  Toolbox& tools_;
  DomainMesh& mesh_;
  const ImproveSchedule& schedule_;
  std::function<bool()> out_of_time_;
  std::size_t n_visited_ = 0;
  struct Attempt {
    std::uint64_t when = 0;  ///< the mesh's time
    RepairBy what = RepairBy::nothing;
  };
  std::vector<Attempt> tried_;           // for each cell, the kinds of operations that failed to improve it
  std::vector<std::uint64_t> smoothed_;  // for each vertex, the mesh's time when moving it last failed
};

}  // namespace geomesh::remesh

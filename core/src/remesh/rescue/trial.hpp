// SPDX-License-Identifier: MIT
/// @file
/// A group of operations that is kept or undone as a whole.
#pragma once

#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

/// Records all changes of the mesh from construction on, and undoes them at destruction unless `keep` was called: the
/// mesh, the data about it in the Toolbox, and its statistics are then as before. While such a trial lasts, bad cells
/// may spread, and points may be put into thin gaps.
class Trial {
 public:
  explicit Trial(Toolbox& tools)
      : tools_(tools),
        statistics_(tools.statistics),
        may_spread_(tools.bad_cells_may_spread),
        in_gaps_(tools.points_in_thin_gaps) {
    tools.mesh.begin_trial();
    tools.bad_cells_may_spread = tools.points_in_thin_gaps = true;
  }
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  ~Trial() {
    if (!kept_) {
      tools_.mesh.for_each_trial_vertex([&](VertexIndex v) { tools_.lengths.forget(v); });
      tools_.mesh.undo_trial();
      tools_.statistics = statistics_;
    }
    tools_.bad_cells_may_spread = may_spread_;
    tools_.points_in_thin_gaps = in_gaps_;
  }
  void keep() {
    tools_.mesh.keep_trial();
    kept_ = true;
  }

 private:
  Toolbox& tools_;
  RefineStatistics statistics_;
  bool may_spread_, in_gaps_, kept_ = false;
};

}  // namespace geomesh::remesh

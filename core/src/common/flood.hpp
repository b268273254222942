// SPDX-License-Identifier: MIT
/// @file
/// Labels cells that can be reached from one another through faces.
#pragma once

#include <vector>

#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// Assigns `label` to `start` and to all unlabelled cells that are reached from it through faces for which
/// is_open(FaceRef) is true. `labels` has an entry per slot of `cells`: no_label if unlabelled. O(cells reached).
template <class Label, class IsOpen>
void flood_cells(const TetMesh& cells, CellIndex start, std::vector<Label>& labels, Label no_label, Label label,
                 const IsOpen& is_open) {
  std::vector<CellIndex> stack{start};
  labels[start] = label;
  while (!stack.empty()) {
    const CellIndex c = stack.back();
    stack.pop_back();
    for (unsigned i = 0; i < 4; ++i) {
      const CellIndex n = cells.neighbor_cell(c, i);
      if (labels[n] != no_label || !is_open(FaceRef(c, i))) continue;
      labels[n] = label;
      stack.push_back(n);
    }
  }
}

}  // namespace geomesh

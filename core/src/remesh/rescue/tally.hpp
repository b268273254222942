// SPDX-License-Identifier: MIT
/// @file
/// What the bad cells about a place come to, before and after a sequence of repair.
#pragma once

#include <algorithm>
#include <cstddef>

#include "remesh/operations/improve_schedule.hpp"

namespace geomesh::remesh {

struct Tally {
  std::size_t n_bad = 0;
  double worst = 1;
  double deficit = 0;  ///< sum over the bad cells of what they lack, as a share of the bad shape

  void add(double shape, double bad_shape) {
    n_bad += shape < bad_shape;
    worst = std::min(worst, shape);
    deficit += std::max(1 - shape / bad_shape, 0.0);
  }
  bool is_better_than(const Tally& other) const {
    return worst >= other.worst &&
           (n_bad < other.n_bad || (n_bad == other.n_bad && worst > rescue_limits.notable_rise * other.worst));
  }
  /// Beside cells that cannot be mended the worst says nothing. There all bad cells together count.
  bool is_less_bad_than(const Tally& other) const {
    return worst >= other.worst &&
           (n_bad < other.n_bad || (n_bad == other.n_bad && deficit < other.deficit - rescue_limits.notable_relief));
  }
};

}  // namespace geomesh::remesh

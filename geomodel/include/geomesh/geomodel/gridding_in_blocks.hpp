// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Interpolates horizons from points separately in each fault block.
#pragma once

#include <vector>

#include "geomesh/geomodel/gridding.hpp"
#include "geomesh/geomodel/model_rules.hpp"

namespace geomesh::geomodel {

/// Distances between a horizon that was interpolated again in each fault block and its points.
struct GriddedInBlocks {
  Index row;
  /// Number of fault blocks with points, and number of those blocks that keep the common surface.
  std::size_t n_blocks = 0, n_in_common = 0;
  double rms_residual = 0, largest_residual = 0;
  Vec3 largest_place;
};

/// Replaces horizons whose points lie in several fault blocks: each block gets a surface interpolated from its own
/// points, because one smooth surface through the points on both sides of a fault would form a ramp. The surface of a
/// block extends as far as the block and the common surface do. Points outside of the model belong to the block of the
/// nearest point inside. Blocks with too few points keep the common surface. Nothing changes without faults, without a
/// volume, or where continuation to the walls of blocks is switched off. Throws as BlockFramework does. Takes O((n + m)
/// log t) for n points, m nodes and t tetrahedra of the framework.
std::vector<GriddedInBlocks> grid_in_blocks(std::vector<TriangulatedSurface>& surfaces, const PointsOfHorizons& made,
                                            const ModelRules& rules);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons interpolated from points in each fault block by itself.
#pragma once

#include <vector>

#include "geomesh/geomodel/gridding.hpp"
#include "geomesh/geomodel/model_rules.hpp"

namespace geomesh::geomodel {

/// How far a horizon that was made anew is from its points.
struct GriddedInBlocks {
  Index row;
  std::size_t n_blocks = 0, n_in_common = 0;  ///< blocks with points; those of them that keep the common surface
  double rms_residual = 0, largest_residual = 0;
  Vec3 largest_place;
};

/// A smooth surface through points on both sides of a fault would be a ramp there. So where the points of a horizon lie
/// in several fault blocks, each block gets a surface from its own points, over the extent of the common one and as far
/// as the block reaches. Points outside of the model count to the block of the nearest point inside. Blocks with too
/// few points keep the common surface. Replaces these horizons; nothing changes without faults, without a volume, or
/// where continuation to the walls of blocks is switched off. Throws as BlockFramework. O((n + m) log t) for n points,
/// m nodes and t tetrahedra of the framework.
std::vector<GriddedInBlocks> grid_in_blocks(std::vector<TriangulatedSurface>& surfaces, const PointsOfHorizons& made,
                                            const ModelRules& rules);

}  // namespace geomesh::geomodel

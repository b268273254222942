// SPDX-License-Identifier: MIT
/// @file
/// Patches of coplanar triangles of one surface.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geomesh/core/plc.hpp"
#include "plc/flat_patch.hpp"
#include "plc/patch_crossings.hpp"

namespace geomesh {

/// Limit on the average number of Delaunay edges that each inner edge of plane patches crosses. Up to this limit
/// tetrahedralize() keeps the triangles, because the number of flips is then linear in the size of the model. The
/// benchmark's models have up to 3.3 (modelA4), its plates of crossing needles 10 and more.
inline constexpr double most_crossings_of_kept_edge = 4;

/// Triangles that are connected by edges, exactly coplanar and of equal provenance. A facet that is not a triangle, or
/// has points or segments inside, forms a patch of its own.
struct CoplanarPatch {
  std::vector<Index> facets;
  std::vector<FlatPatch::Edge> segments;  ///< edges inside the patch that other facets or segments share
};

/// Returns all patches if they are far from Delaunay: their inner edges cross more than `most_crossings` edges each, on
/// average over all patches, of the Delaunay triangulations of their vertices. Otherwise returns none. `provenance` has
/// an entry per facet. O(n log n).
std::vector<CoplanarPatch> patches_far_from_delaunay(const PiecewiseLinearComplex& plc,
                                                     std::span<const Index> provenance, double most_crossings);

/// Makes a patch of the given triangular facets, in the given order.
std::optional<FlatPatch> flat_patch_of(const PiecewiseLinearComplex& plc, std::span<const Index> facets);

}  // namespace geomesh

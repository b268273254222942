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

/// Delaunay edges that the inner edges of plane patches cross on average over a model, up to which tetrahedralize()
/// keeps its triangles: the work of flips for them is linear in the model then. The benchmark's models have up to 3.3
/// (modelA4), its plates of crossing needles 10 and more.
inline constexpr double most_crossings_of_kept_edge = 4;

/// Triangles that are joined by edges, exactly coplanar and of equal provenance. A facet that is no triangle, or has
/// inner items, is alone.
struct CoplanarPatch {
  std::vector<Index> facets;
  std::vector<FlatPatch::Edge> segments;  ///< inner edges at which anything else lies
};

/// All patches, if they are far from Delaunay: their inner edges cross more than `most_crossings` edges each, on
/// average over all patches, of the Delaunay triangulations of their vertices. Else none. `provenance`: by facet. O(n
/// log n).
std::vector<CoplanarPatch> patches_far_from_delaunay(const PiecewiseLinearComplex& plc,
                                                     std::span<const Index> provenance, double most_crossings);

/// The triangles given, which are a patch, in their order.
std::optional<FlatPatch> flat_patch_of(const PiecewiseLinearComplex& plc, std::span<const Index> facets);

}  // namespace geomesh

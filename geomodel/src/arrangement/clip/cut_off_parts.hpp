// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What walls cut off from the given part of a surface.
#pragma once

#include <array>
#include <functional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "common/edge_uses.hpp"
#include "geomesh/geomodel/arrangement.hpp"

namespace geomesh::geomodel::arrangement {

/// Facets of an arrangement; all that is referred to outlives its use.
struct FacetsWithOrigins {
  std::span<const Triangle> facets;
  const std::vector<EdgeUse>& uses;  ///< of all facets, sorted
  std::function<std::span<const PolygonSoup::Origin>(Index)> origins_of;
};

/// Facet, row of the surface and its triangle, for each part of a facet that was found to be cut off.
using LostParts = std::set<std::array<Index, 3>>;

/// A surface in parts: the first were given, each other one continues them. A part shares the points (by row) where
/// it begins with what it continues; sheets of several blocks may have equal points that are none of these.
struct SurfaceInParts {
  const TriangulatedSurface& surface;
  Index row;                        ///< as in Origin::surface
  const std::vector<Index>& part;   ///< per triangle
  const std::vector<Index>& walls;  ///< rows of the surfaces at which the parts end, ascending
  const LostParts& lost;            ///< of walls: nothing ends there
  Index n_given = 1;                ///< parts below this one were given
};

/// Facets, each with a triangle of the surface for which it stands, that walls cut off from what was given; ascending.
/// A part hangs together with what was given where both share a point of the surface, and with no other part:
/// continuations from both sides of a fault cross each other beyond it. O(n log m) for n facets of the surface among m,
/// and one pass over these.
std::vector<std::pair<Index, Index>> parts_cut_off(const FacetsWithOrigins& of, const SurfaceInParts& in);

}  // namespace geomesh::geomodel::arrangement

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the parts of a surface that walls cut off from its given part.
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

/// Facets of an arrangement and their edges. All references must outlive its use.
struct FacetsWithOrigins {
  std::span<const Triangle> facets;
  const std::vector<EdgeUse>& uses;  ///< edge uses of all facets, sorted
  std::function<std::span<const PolygonSoup::Origin>(Index)> origins_of;
};

/// Facet, row of the surface and its triangle, for each part of a facet that is cut off.
using LostParts = std::set<std::array<Index, 3>>;

/// A surface in parts: the first were given, each other one continues them. A part shares the points (by row) where
/// it begins with what it continues; sheets of several blocks may have equal points that are none of these.
struct SurfaceInParts {
  const TriangulatedSurface& surface;
  Index row;                        ///< as in Origin::surface
  const std::vector<Index>& part;   ///< per triangle
  const std::vector<Index>& walls;  ///< rows of the surfaces at which the parts end, ascending
  const LostParts& lost;            ///< removed parts of walls, at which nothing ends
  Index n_given = 1;                ///< parts below this one were given
};

/// Returns facets, each with the triangle of the surface to which it belongs, that walls cut off from the given part;
/// ascending. A part is connected with the given one only at shared points of the surface, and with no other part:
/// continuations from both sides of a fault cross each other beyond it. O(n log m) for n facets of the surface among m,
/// and one pass over these.
std::vector<std::pair<Index, Index>> parts_cut_off(const FacetsWithOrigins& of, const SurfaceInParts& in);

}  // namespace geomesh::geomodel::arrangement

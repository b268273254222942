// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the parts of a continued surface that bounding surfaces separate from its original part.
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

/// Facets of an arrangement and their edges. Holds references, which must stay valid.
struct FacetsWithOrigins {
  std::span<const Triangle> facets;
  const std::vector<EdgeUse>& uses;  ///< edges of all facets, each with a facet at it, sorted
  std::function<std::span<const PolygonSoup::Origin>(Index)> origins_of;
};

/// Parts of facets that are cut off, each given by the facet, the surface and the surface's triangle.
using LostParts = std::set<std::array<Index, 3>>;

/// A surface in parts: part 0 is the original one, the others are its continuations. A continuation shares those points
/// (by index) at which it begins; equal points of different continuations need not be shared.
struct SurfaceInParts {
  const TriangulatedSurface& surface;
  Index row;                        ///< as in Origin::surface
  const std::vector<Index>& part;   ///< per triangle
  const std::vector<Index>& walls;  ///< surfaces at which the continuations of surface `row` end, ascending
  const LostParts& lost;            ///< removed parts of the surfaces in `walls`, at which no continuation ends
};

/// Returns the facets that bounding surfaces separate from the original part of the surface, each with the surface's
/// triangle to which it belongs, in ascending order. A continuation is connected with the original part only at shared
/// points, and never with other continuations, because those from both sides of a fault cross each other beyond it. O(n
/// log m) for n facets of the surface among m facets, and one pass over all m.
std::vector<std::pair<Index, Index>> parts_cut_off(const FacetsWithOrigins& of, const SurfaceInParts& in);

}  // namespace geomesh::geomodel::arrangement

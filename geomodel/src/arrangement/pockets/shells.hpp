// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the walls of the spaces that facets enclose, without a mesh of the volume.
#pragma once

#include <vector>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// A facet seen from one side: 2 f + 0 from where its corners are counter-clockwise, 2 f + 1 from behind.
using FacetSide = std::size_t;
inline Index facet_of(FacetSide side) { return static_cast<Index>(side / 2); }
inline bool is_front(FacetSide side) { return side % 2 == 0; }

/// Facets by shared edges; the facets of an edge are stored consecutively.
struct EdgeFacets {
  struct Use {
    VertexIndex a, b;  ///< a < b
    Index facet;
    bool forward;  ///< whether the facet traverses the edge from a to b
  };
  std::vector<Use> uses;             ///< sorted by edge, then by facet
  std::vector<std::size_t> offsets;  ///< first use of each edge, and the end
};
EdgeFacets edge_facets(const Complex& complex);

/// Returns connected sets of sides of facets that bound one space, ascending. A space with separate parts in it has
/// several shells. Exact: facets meet in shared vertices and edges only. O(n log n).
std::vector<std::vector<FacetSide>> shells_of(const Complex& complex, const EdgeFacets& edges);

}  // namespace geomesh::geomodel::arrangement

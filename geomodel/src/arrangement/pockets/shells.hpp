// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the walls of the spaces that facets enclose, without a mesh of the volume.
#pragma once

#include <vector>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// A side of facet f: 2 f is the side from which its corners are counter-clockwise, 2 f + 1 the other one.
using FacetSide = std::size_t;
inline Index facet_of(FacetSide side) { return static_cast<Index>(side / 2); }
inline bool is_front(FacetSide side) { return side % 2 == 0; }

/// Facets at each edge; the facets of one edge are stored consecutively.
struct EdgeFacets {
  struct Use {
    VertexIndex a, b;  ///< a < b
    Index facet;
    bool forward;  ///< whether the facet traverses the edge from a to b
  };
  std::vector<Use> uses;             ///< edges of facets, each with one facet at it, sorted by edge, then by facet
  std::vector<std::size_t> offsets;  ///< index in `uses` of each edge's first entry, followed by the number of entries
};
EdgeFacets edge_facets(const Complex& complex);

/// Returns shells: ascending connected sets of facet sides that bound one space. A space that contains separate parts
/// has several shells. Exact. Precondition: facets meet in shared vertices and edges only. O(n log n).
std::vector<std::vector<FacetSide>> shells_of(const Complex& complex, const EdgeFacets& edges);

}  // namespace geomesh::geomodel::arrangement

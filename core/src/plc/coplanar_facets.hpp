// SPDX-License-Identifier: MIT
/// @file
/// Merges triangles of one surface that lie exactly in one plane into polygons, so that recovery need not make edges
/// that nobody requested. Two triangulations of a plate by long needles can cross each other everywhere; a mesh with
/// all of their edges has as many tetrahedra as there are crossings, which is quadratic in the input.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh {

/// A complex in which some patches of coplanar triangles are one facet each, or an empty complex if nothing is merged.
/// Points, segments and seeds are those of the original complex, in the same rows.
struct MergedFacets {
  PiecewiseLinearComplex plc;
  std::vector<Index> first{0};  ///< merged facet m is made of members[first[m]] .. members[first[m + 1] - 1]
  /// Facets of the complex before merging. The first of each patch is the smallest, and orients the merged facet.
  std::vector<Index> members;

  bool has_merged() const { return plc.n_facets() < members.size(); }
  std::span<const Index> members_of(Index m) const {
    return {members.data() + first[m], members.data() + first[m + 1]};
  }
};

/// Merges each patch of triangles that are connected by edges, exactly coplanar and of equal provenance, if the patches
/// are far from Delaunay: their inner edges cross more than `most_crossings` edges each, on average over all patches,
/// of the Delaunay triangulations of their vertices. The two triangles of each quadrilateral on the sides of a plate
/// are then merged, too, because their diagonals would cost Steiner points if flips cannot create them. All other
/// facets are kept. An edge remains a segment of the merged facet if the complex lists it as one or if another facet
/// ends on it. `provenance` has an entry per facet. Precondition: validate_plc finds no fault. A patch that is not a
/// valid polygon is kept as triangles, so that recovery reports the fault. O(n log n).
MergedFacets merge_coplanar_facets(const PiecewiseLinearComplex& plc, std::span<const Index> provenance,
                                   double most_crossings);

}  // namespace geomesh

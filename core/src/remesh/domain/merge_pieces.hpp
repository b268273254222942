// SPDX-License-Identifier: MIT
/// @file
/// Joins the pieces into which intersections have cut one input triangle, so that the triangle is one facet again.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh::remesh {

struct MergedFacets {
  PiecewiseLinearComplex plc;       ///< the original points, segments and seeds, with merged facets
  std::vector<Index> row_of_facet;  ///< for each original facet, the facet of `plc` that contains it
};

/// Merges triangles that are pieces of one input triangle (the same number in `parent`, which is no_index if there is
/// none; empty: nothing is merged). They must be connected across edges without other facets, and be coplanar within
/// two ulps of the largest coordinate. A group is merged if its border passes no point twice and it can be triangulated
/// with everything inside. Within a merged facet, edges at which other facets end become inner segments, and vertices
/// that other items use become inner points; vertices that nothing else uses are in no facet of the result. O(n log n).
MergedFacets merge_pieces(const PiecewiseLinearComplex& plc, std::span<const Index> parent);

/// Removes the parent of each original facet that was merged with others into one of the facets `rows` of merged.plc,
/// so that it will not be merged again. Returns whether there was any. O(n log m) for m rows.
bool take_apart(const MergedFacets& merged, std::vector<Index> rows, std::vector<Index>& parent);

/// Copies the complex without its facets and their contents.
PiecewiseLinearComplex without_facets(const PiecewiseLinearComplex& plc);

/// Calls visit(facet, a, b) for each edge (a, b) of each loop of each facet, in the order of the facets.
template <class Visit>
void for_each_side(const PiecewiseLinearComplex& plc, const Visit& visit) {
  for (Index f = 0; f < plc.n_facets(); ++f)
    for (Index l = plc.facet_loops[f]; l < plc.facet_loops[f + 1]; ++l)
      for (std::size_t i = 0, n = plc.loop(l).size(); i < n; ++i) visit(f, plc.loop(l)[i], plc.loop(l)[(i + 1) % n]);
}

}  // namespace geomesh::remesh

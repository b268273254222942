// SPDX-License-Identifier: MIT
/// @file
/// Facets as users gave them: the pieces into which crossings have cut one triangle of theirs count as one facet again.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh::remesh {

struct MergedFacets {
  PiecewiseLinearComplex plc;       ///< points, segments and seeds as they were; facets merged
  std::vector<Index> row_of_facet;  ///< per facet as it was: its row in `plc`
};

/// Merges triangles of equal parent (`parent` per facet, no_index: none; empty: nothing is merged) that join across
/// edges where nothing else is, and lie in one plane within two ulps of the largest coordinate. What joins is merged
/// where its border passes no point twice and can be triangulated with what is inside. Sides within a merged facet at
/// which others end are kept as its inner segments, and vertices that others use as its inner points; vertices that
/// nothing else uses are in no facet any more. O(n log n).
MergedFacets merge_pieces(const PiecewiseLinearComplex& plc, std::span<const Index> parent);

/// Takes the parent from each facet that was merged with others to one of `rows`, so that it is not merged again.
/// Whether there was any. O(n log m) for m rows.
bool take_apart(const MergedFacets& merged, std::vector<Index> rows, std::vector<Index>& parent);

/// The complex but for its facets and what is inside them.
PiecewiseLinearComplex without_facets(const PiecewiseLinearComplex& plc);

/// visit(facet, a, b) for each side of each loop, in the order of the facets.
template <class Visit>
void for_each_side(const PiecewiseLinearComplex& plc, const Visit& visit) {
  for (Index f = 0; f < plc.n_facets(); ++f)
    for (Index l = plc.facet_loops[f]; l < plc.facet_loops[f + 1]; ++l)
      for (std::size_t i = 0, n = plc.loop(l).size(); i < n; ++i) visit(f, plc.loop(l)[i], plc.loop(l)[(i + 1) % n]);
}

}  // namespace geomesh::remesh

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The parts into which the surfaces of a polygon soup cut each other.
#pragma once

#include <vector>

#include "common/union_find.hpp"
#include "geomesh/geomodel/arrangement.hpp"

namespace geomesh::geomodel::arrangement {

/// Divides each surface into parts along its edges with other surfaces. To find what one of these surfaces cuts off,
/// parts that only the others separate are united again.
class SurfaceParts {
 public:
  /// Near-linear.
  SurfaceParts(const PolygonSoup& soup, std::size_t n_surfaces);

  /// Returns the area of surface `a` that its curves with surface `b` separate from its largest piece: the part beyond
  /// `b` if the two cross over a patch. 0 if `b` separates nothing. Linear in the edges at which `a` meets other
  /// surfaces.
  double area_parted(Index a, Index b) const;

 private:
  /// The surfaces at an edge, if there are several, as ascending (surface, part) pairs.
  using SharedEdge = std::vector<std::pair<Index, Index>>;
  void add_edge(const PolygonSoup& soup, const std::vector<Index>& facets);

  UnionFind joined_;          ///< rows of soup.origins
  std::vector<double> area_;  ///< per representative
  std::vector<SharedEdge> shared_;
  /// For each surface: indices in shared_ of its edges with other surfaces; and the indices of its parts, ascending.
  std::vector<std::vector<Index>> shared_of_, parts_of_;
};

}  // namespace geomesh::geomodel::arrangement

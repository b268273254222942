// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sheets of a horizon: triangles that hang together by edges.
#pragma once

#include <utility>
#include <vector>

#include "common/union_find.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

Vec3 centre_of(const TriangulatedSurface& surface, const Triangle& triangle);
double area_of(const TriangulatedSurface& surface, Index triangle);

/// Pairs of triangles with an edge in common (equal coordinates merged).
std::vector<std::pair<Index, Index>> neighbours_in(const TriangulatedSurface& surface);

/// Sheets joined across the pairs that `joins` accepts, as the least triangle of each.
template <class F>
std::vector<Index> sheets_of(std::size_t n_triangles, const std::vector<std::pair<Index, Index>>& neighbours,
                             F&& joins) {
  UnionFind joined(n_triangles);
  for (const auto& [a, b] : neighbours)
    if (joins(a, b)) joined.unite(a, b);
  std::vector<Index> sheet(n_triangles);
  for (Index t = 0; t < sheet.size(); ++t) sheet[t] = joined.find(t);
  return sheet;
}

/// Whether a sheet runs on across a fault as given: triangles that cross it hang together, and have neighbours that do
/// not cross it on both of its sides. O((n + m) log m) for n triangles of the horizon and m of the fault.
bool runs_across(const TriangulatedSurface& horizon, const TriangulatedSurface& fault);

}  // namespace geomesh::geomodel

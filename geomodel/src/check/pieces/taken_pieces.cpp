// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/pieces/taken_pieces.hpp"

#include <map>

#include "common/union_find.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Returns ids of the corners of each triangle, equal for equal coordinates, because files may repeat points.
std::vector<std::array<Index, 3>> corners_by_place(const TriangulatedSurface& surface,
                                                   const std::vector<UncoveredTriangle>& uncovered) {
  std::map<std::array<double, 3>, Index> rows;
  std::vector<std::array<Index, 3>> corners;
  for (const UncoveredTriangle& u : uncovered) {
    std::array<Index, 3>& c = corners.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = surface.points[surface.triangles[u.triangle][i]];
      c[i] = rows.try_emplace({p.x, p.y, p.z}, static_cast<Index>(rows.size())).first->second;
    }
  }
  return corners;
}

UnionFind pieces_of(const TriangulatedSurface& surface, const std::vector<UncoveredTriangle>& uncovered) {
  const auto corners = corners_by_place(surface, uncovered);
  std::map<std::array<Index, 2>, Index> first_at;  // first triangle at each uncovered side, given by the side's ends
  UnionFind pieces(uncovered.size());
  for (Index row = 0; row < uncovered.size(); ++row)
    for (std::size_t i = 0; i < 3; ++i) {
      if (!uncovered[row].goes_on[i]) continue;
      const Index a = corners[row][i], b = corners[row][(i + 1) % 3];
      const auto [at, is_new] = first_at.try_emplace({std::min(a, b), std::max(a, b)}, row);
      if (!is_new) pieces.unite(at->second, row);
    }
  return pieces;
}

}  // namespace

std::vector<Index> not_taken_as_pieces(const TriangulatedSurface& surface,
                                       const std::vector<UncoveredTriangle>& uncovered) {
  UnionFind pieces = pieces_of(surface, uncovered);
  struct Sum {
    double beyond = 0, within = 0;
    bool ends_at_cutters = true;
  };
  std::vector<Sum> sums(uncovered.size());
  for (Index row = 0; row < uncovered.size(); ++row) {
    Sum& sum = sums[pieces.find(row)];
    sum.beyond += uncovered[row].beyond;
    sum.within += uncovered[row].within;
    sum.ends_at_cutters = sum.ends_at_cutters && uncovered[row].ends_at_cutters;
  }
  std::vector<Index> rows;
  for (Index row = 0; row < uncovered.size(); ++row) {
    const Sum& sum = sums[pieces.find(row)];
    if (uncovered[row].within > 0 && !(sum.ends_at_cutters && sum.beyond > sum.within)) rows.push_back(row);
  }
  return rows;
}

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/equal_points.hpp"

#include <algorithm>
#include <numeric>

#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel {

std::vector<VertexIndex> merge_equal_points(const std::vector<Vec3>& points) {
  std::vector<VertexIndex> order(points.size()), merged(points.size());
  std::iota(order.begin(), order.end(), VertexIndex{0});
  std::sort(order.begin(), order.end(), [&](VertexIndex i, VertexIndex j) {
    const int c = compare_lexicographic(points[i], points[j]);
    return c != 0 ? c < 0 : i < j;
  });
  for (std::size_t k = 0; k < order.size(); ++k)
    merged[order[k]] = k > 0 && points[order[k]] == points[order[k - 1]] ? merged[order[k - 1]] : order[k];
  return merged;
}

std::vector<Triangle> merged_triangles(const TriangulatedSurface& surface) {
  return merged_triangles(surface, merge_equal_points(surface.points));
}

std::vector<Triangle> merged_triangles(const TriangulatedSurface& surface, const std::vector<VertexIndex>& merged) {
  std::vector<Triangle> triangles;
  triangles.reserve(surface.triangles.size());
  for (const Triangle& t : surface.triangles) {
    const Triangle w{merged[t[0]], merged[t[1]], merged[t[2]]};
    const bool has_area = w[0] != w[1] && w[1] != w[2] && w[2] != w[0];
    triangles.push_back(has_area ? w : Triangle{w[0], w[0], w[0]});
  }
  return triangles;
}

}  // namespace geomesh::geomodel

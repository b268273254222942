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

}  // namespace geomesh::geomodel

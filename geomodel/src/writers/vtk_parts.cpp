// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtk_parts.hpp"

#include <utility>

namespace geomesh::geomodel {

VtkSection vtk_cells(const char* tag, std::vector<std::vector<VertexIndex>> lists) {
  std::vector<VertexIndex> corners;
  std::vector<std::size_t> ends;
  for (const std::vector<VertexIndex>& list : lists) {
    corners.insert(corners.end(), list.begin(), list.end());
    ends.push_back(corners.size());
  }
  const std::size_t n = ends.size(), n_corners = corners.size();
  const auto corner = [corners = std::move(corners)](std::size_t i) { return corners[i]; };
  const auto end = [ends = std::move(ends)](std::size_t i) { return ends[i]; };
  return {tag,
          "",
          {vtk_array<std::int32_t>("connectivity", n_corners, corner), vtk_array<std::int32_t>("offsets", n, end)}};
}

VtkSection vtk_points(const std::vector<Vec3>& points) {
  const auto coordinate = [&points](std::size_t i) { return points[i / 3][i % 3]; };
  return {"Points", "", {vtk_array<double>("Points", 3 * points.size(), coordinate, 3)}};
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/throw/sheets.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "naming/sheets.hpp"
#include "naming/sums.hpp"
#include "rules/framework/walls.hpp"

namespace geomesh::geomodel {

Vec3 centre_of(const TriangulatedSurface& s, const Triangle& t) {
  return (1.0 / 3) * (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]);
}

double area_of(const TriangulatedSurface& s, Index t) {
  const Triangle& v = s.triangles[t];
  return triangle_area(s.points[v[0]], s.points[v[1]], s.points[v[2]]);
}

std::vector<std::pair<Index, Index>> neighbours_in(const TriangulatedSurface& s) {
  const std::vector<Triangle> triangles = merged_triangles(s);
  std::map<std::pair<VertexIndex, VertexIndex>, Index> first;
  std::vector<std::pair<Index, Index>> pairs;
  for (Index t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexIndex a = triangles[t][i], b = triangles[t][(i + 1) % 3];
      if (a == b) continue;
      const auto [at, is_new] = first.emplace(std::pair(std::min(a, b), std::max(a, b)), t);
      if (!is_new) pairs.emplace_back(at->second, t);
    }
  return pairs;
}

bool runs_across(const TriangulatedSurface& horizon, const TriangulatedSurface& fault) {
  const Walls walls({fault}, {0}, {});
  const std::vector<Triangle> triangles = merged_triangles(horizon);
  // Sides of the corners of triangles that cross the fault: 1 above, -1 below, 0 where no edge from there crosses it.
  std::map<Index, std::array<int, 3>> crossing;
  for (Index t = 0; t < triangles.size(); ++t) {
    std::array<int, 3> sides{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const auto hit = walls.first_surface(horizon.points[triangles[t][i]], horizon.points[triangles[t][j]], no_index);
      if (!hit) continue;
      sides[i] = hit->from_above ? 1 : -1;
      sides[j] = -sides[i];
    }
    if (sides != std::array<int, 3>{0, 0, 0}) crossing[t] = sides;
  }
  const auto pairs = neighbours_in(horizon);
  const std::vector<Index> place = sheets_of(
      triangles.size(), pairs, [&](Index a, Index b) { return crossing.contains(a) && crossing.contains(b); });
  std::map<Index, std::array<bool, 2>> beside;  // by place: below, above
  for (const auto& [a, b] : pairs)
    for (const auto& [t, other] : {std::pair(a, b), std::pair(b, a)}) {
      const auto at = crossing.find(t);
      if (at == crossing.end() || crossing.contains(other)) continue;
      for (std::size_t i = 0; i < 3; ++i)
        if (at->second[i] != 0 && std::ranges::count(triangles[other], triangles[t][i]) > 0)
          beside[place[t]][at->second[i] > 0 ? 1 : 0] = true;
    }
  return std::ranges::any_of(beside, [](const auto& entry) { return entry.second[0] && entry.second[1]; });
}

}  // namespace geomesh::geomodel

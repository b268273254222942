// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/names/sheet_sides.hpp"

#include <array>
#include <map>

namespace geomesh::geomodel::checking {
namespace {

using Place = std::array<double, 3>;

struct Use {
  Index triangle;
  bool forward;  ///< whether the triangle traverses the edge from the smaller vertex index to the larger
};

/// Returns the triangles at each edge of a surface. Edges are identified by coordinates: duplicate points count as one.
std::map<std::array<Place, 2>, std::vector<Use>> edge_uses(const TriangulatedSurface& s) {
  std::map<std::array<Place, 2>, std::vector<Use>> uses;
  const auto place = [&](VertexIndex v) { return Place{s.points[v].x, s.points[v].y, s.points[v].z}; };
  for (Index t = 0; t < s.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const Place a = place(s.triangles[t][i]), b = place(s.triangles[t][(i + 1) % 3]);
      if (a != b) uses[{std::min(a, b), std::max(a, b)}].push_back({t, a < b});
    }
  return uses;
}

double area_in_map(const TriangulatedSurface& s, Index t) {
  const Vec3 &a = s.points[s.triangles[t][0]], &b = s.points[s.triangles[t][1]], &c = s.points[s.triangles[t][2]];
  return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

}  // namespace

std::vector<int> upper_sides(const TriangulatedSurface& surface) {
  struct Neighbour {
    Index triangle;
    int same;  ///< +1 if the normals of both triangles at an edge point to the same side of the surface, else -1
  };
  std::vector<std::vector<Neighbour>> across(surface.triangles.size());
  for (const auto& [ends, at] : edge_uses(surface)) {
    if (at.size() != 2 || at[0].triangle == at[1].triangle) continue;
    const int same = at[0].forward != at[1].forward ? 1 : -1;
    across[at[0].triangle].push_back({at[1].triangle, same});
    across[at[1].triangle].push_back({at[0].triangle, same});
  }
  std::vector<int> side(surface.triangles.size(), 0);
  for (Index first = 0; first < side.size(); ++first) {
    if (side[first] != 0) continue;
    std::vector<Index> sheet{first};
    side[first] = 1;
    bool orientable = true;
    double up = 0;
    for (std::size_t k = 0; k < sheet.size(); ++k) {
      const Index t = sheet[k];
      up += side[t] * area_in_map(surface, t);
      for (const Neighbour& n : across[t]) {
        const int wanted = side[t] * n.same;
        orientable = orientable && (side[n.triangle] == 0 || side[n.triangle] == wanted);
        if (side[n.triangle] != 0) continue;
        side[n.triangle] = wanted;
        sheet.push_back(n.triangle);
      }
    }
    for (const Index t : sheet)
      side[t] = orientable ? (up < 0 ? -side[t] : side[t]) : (area_in_map(surface, t) >= 0 ? 1 : -1);
  }
  return side;
}

}  // namespace geomesh::geomodel::checking

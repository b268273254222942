// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/sheets.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "geomesh/core/predicates.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {

namespace {

/// A directed edge of a triangle after merging equal points; `forward` if it runs from the smaller index to the larger.
struct DirectedEdge {
  VertexIndex a, b;
  Index triangle;
  bool forward;
};

std::vector<DirectedEdge> sorted_directed_edges(const TriangulatedSurface& surface) {
  const std::vector<Triangle> triangles = merged_triangles(surface);
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * triangles.size());
  for (Index t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexIndex p = triangles[t][i], q = triangles[t][(i + 1) % 3];
      if (p != q) edges.push_back({std::min(p, q), std::max(p, q), t, p < q});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const DirectedEdge& x, const DirectedEdge& y) {
    return std::tie(x.a, x.b, x.triangle, x.forward) < std::tie(y.a, y.b, y.triangle, y.forward);
  });
  return edges;
}

template <class F>
void for_each_group(const std::vector<DirectedEdge>& edges, F&& visit) {
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].a == edges[begin].a && edges[end].b == edges[begin].b) ++end;
    visit(begin, end);
    begin = end;
  }
}

struct Link {
  Index to;
  bool same_side;  ///< whether the normals of both triangles at an edge point to the same side of the surface
};

std::vector<std::vector<Link>> sheet_links(const TriangulatedSurface& surface) {
  std::vector<std::vector<Link>> links(surface.triangles.size());
  const std::vector<DirectedEdge> edges = sorted_directed_edges(surface);
  for_each_group(edges, [&](std::size_t begin, std::size_t end) {
    if (end - begin != 2 || edges[begin].triangle == edges[begin + 1].triangle) return;
    const DirectedEdge &p = edges[begin], &q = edges[begin + 1];
    links[p.triangle].push_back({q.triangle, p.forward != q.forward});
    links[q.triangle].push_back({p.triangle, p.forward != q.forward});
  });
  return links;
}

double map_area(const TriangulatedSurface& surface, Index t) {
  const Triangle& v = surface.triangles[t];
  return cross(surface.points[v[1]] - surface.points[v[0]], surface.points[v[2]] - surface.points[v[0]]).z / 2;
}

}  // namespace

bool is_closed(const TriangulatedSurface& surface) {
  if (surface.triangles.empty()) return false;
  bool closed = true;
  const std::vector<DirectedEdge> edges = sorted_directed_edges(surface);
  for_each_group(edges, [&](std::size_t begin, std::size_t end) {
    std::ptrdiff_t balance = 0;
    for (std::size_t i = begin; i < end; ++i) balance += edges[i].forward ? 1 : -1;
    closed = closed && balance == 0;
  });
  return closed;
}

UpwardSides orient_upward(const TriangulatedSurface& surface) {
  const std::vector<std::vector<Link>> links = sheet_links(surface);
  UpwardSides result;
  result.as_stored.assign(surface.triangles.size(), 1);
  std::vector<bool> seen(surface.triangles.size(), false);
  std::vector<Index> sheet;
  for (Index seed = 0; seed < surface.triangles.size(); ++seed) {
    if (seen[seed]) continue;
    sheet.assign(1, seed);
    seen[seed] = true;
    bool orientable = true;
    CompensatedSum up;
    for (std::size_t k = 0; k < sheet.size(); ++k) {
      const Index t = sheet[k];
      up.add(result.as_stored[t] ? map_area(surface, t) : -map_area(surface, t));
      for (const Link& link : links[t]) {
        const bool side = (result.as_stored[t] != 0) == link.same_side;
        if (seen[link.to]) {
          orientable = orientable && (result.as_stored[link.to] != 0) == side;
        } else {
          seen[link.to] = true;
          result.as_stored[link.to] = side;
          sheet.push_back(link.to);
        }
      }
    }
    if (!orientable) ++result.n_unorientable_sheets;
    for (Index t : sheet) {
      if (!orientable) {
        result.as_stored[t] = map_area(surface, t) >= 0;
      } else if (up.value() < 0) {
        result.as_stored[t] = !result.as_stored[t];
      }
    }
  }
  return result;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the parts of one surface and measures its borders and defects, declared in geomesh/geomodel/info.hpp.
#include <algorithm>
#include <cmath>

#include "common/union_find.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/geomodel/info.hpp"
#include "naming/sheets.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {
namespace {

struct DirectedEdge {
  VertexIndex low, high;
  bool forward;  ///< whether the triangle traverses the edge from the lower to the higher vertex
};

std::size_t count_sets(UnionFind& sets, std::vector<VertexIndex> vertices) {
  for (VertexIndex& v : vertices) v = sets.find(v);
  std::sort(vertices.begin(), vertices.end());
  return static_cast<std::size_t>(std::unique(vertices.begin(), vertices.end()) - vertices.begin());
}

/// Finds border edges and defects of a surface from its sorted directed edges. Returns the vertices on borders.
std::vector<VertexIndex> measure_edges(std::vector<DirectedEdge>& edges, const std::vector<Vec3>& points,
                                       SurfaceInfo& info) {
  std::sort(edges.begin(), edges.end(), [](const DirectedEdge& a, const DirectedEdge& b) {
    return std::tie(a.low, a.high, a.forward) < std::tie(b.low, b.high, b.forward);
  });
  UnionFind borders(points.size());
  std::vector<VertexIndex> border_vertices;
  CompensatedSum length;
  bool odd = false;
  for (std::size_t i = 0, j; i < edges.size(); i = j) {
    for (j = i; j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high;) ++j;
    const Vec3 middle = 0.5 * (points[edges[i].low] + points[edges[i].high]);
    odd = odd || (j - i) % 2 != 0;
    if (j - i == 1) {
      if (info.n_border_edges++ == 0) info.border_place = middle;
      length.add(
          std::sqrt(dot(points[edges[i].high] - points[edges[i].low], points[edges[i].high] - points[edges[i].low])));
      borders.unite(edges[i].low, edges[i].high);
      border_vertices.push_back(edges[i].low);
    } else if (j - i > 2) {
      if (info.n_non_manifold_edges++ == 0) info.non_manifold_place = middle;
    } else if (edges[i].forward == edges[i + 1].forward) {
      ++info.n_misoriented_edges;
    }
  }
  info.border_length = length.value();
  info.n_borders = count_sets(borders, border_vertices);
  info.closed = !odd && !edges.empty();
  return border_vertices;
}

}  // namespace

SurfaceInfo measure_surface(const TriangulatedSurface& surface) {
  SurfaceInfo info;
  info.name = surface.name;
  info.n_points = surface.points.size();
  info.n_triangles = surface.triangles.size();
  for (const Vec3& p : surface.points) info.bounds.add(p);
  const std::vector<VertexIndex> first = merge_equal_points(surface.points);
  for (VertexIndex v = 0; v < first.size(); ++v) info.n_distinct_points += first[v] == v;

  std::vector<DirectedEdge> edges;
  std::vector<Triangle> keys;
  UnionFind pieces(surface.points.size());
  std::vector<VertexIndex> used;
  CompensatedSum area, volume;
  const Vec3 origin = surface.points.empty() ? Vec3{} : surface.points.front();
  for (const Triangle& t : surface.triangles) {
    Triangle key{first[t[0]], first[t[1]], first[t[2]]};
    const Vec3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    if (collinear(a, b, c)) {
      ++info.n_degenerate;
      continue;
    }
    const Vec3 normal = cross(b - a, c - a);
    area.add(0.5 * std::sqrt(dot(normal, normal)));
    volume.add(dot(a - origin, cross(b - origin, c - origin)) / 6);
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexIndex v = key[i], w = key[(i + 1) % 3];
      edges.push_back({std::min(v, w), std::max(v, w), v < w});
      pieces.unite(v, w);
    }
    used.push_back(key[0]);
    std::sort(key.begin(), key.end());
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 1; i < keys.size(); ++i) info.n_repeated += keys[i] == keys[i - 1];
  info.n_components = count_sets(pieces, std::move(used));
  info.area = area.value();
  const std::vector<VertexIndex> on_borders = measure_edges(edges, surface.points, info);
  info.n_holes = info.n_borders - count_sets(pieces, on_borders);
  if (info.closed && info.n_misoriented_edges == 0) info.volume = std::abs(volume.value());
  return info;
}

}  // namespace geomesh::geomodel

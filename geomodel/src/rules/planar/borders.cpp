// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/planar/borders.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "naming/sheets.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {
namespace {

Vec3 area_vector(const TriangulatedSurface& s, const Triangle& t) {
  return 0.5 * cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]);
}

}  // namespace

std::vector<BorderEdge> border_edges(const TriangulatedSurface& surface) {
  const std::vector<Triangle> triangles = merged_triangles(surface);
  using Ends = std::pair<VertexIndex, VertexIndex>;
  const auto for_each = [&](auto&& visit) {
    for (Index t = 0; t < triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexIndex a = triangles[t][i], b = triangles[t][(i + 1) % 3];
        if (a != b) visit(a, b, t);
      }
  };
  std::vector<Ends> uses, once;
  for_each([&](VertexIndex a, VertexIndex b, Index) { uses.push_back(std::minmax(a, b)); });
  std::ranges::sort(uses);
  for (auto at = uses.begin(); at != uses.end();) {
    const auto next = std::find_if(at, uses.end(), [&](const Ends& e) { return e != *at; });
    if (next - at == 1) once.push_back(*at);
    at = next;
  }
  std::vector<BorderEdge> edges;
  for_each([&](VertexIndex a, VertexIndex b, Index t) {
    if (std::ranges::binary_search(once, Ends(std::minmax(a, b)))) edges.push_back({a, b, t});
  });
  return edges;
}

BorderLoops border_loops(const std::vector<BorderEdge>& edges) {
  std::map<VertexIndex, std::vector<std::size_t>> from;
  for (std::size_t e = 0; e < edges.size(); ++e) from[edges[e].a].push_back(e);
  std::vector<bool> used(edges.size(), false);
  BorderLoops result;
  for (std::size_t start = 0; start < edges.size(); ++start) {
    if (used[start]) continue;
    std::vector<VertexIndex> path;          // of the walk
    std::map<VertexIndex, std::size_t> at;  // position of each vertex on the path of the walk along border edges
    for (std::size_t e = start;;) {
      used[e] = true;
      at[edges[e].a] = path.size();
      path.push_back(edges[e].a);
      const VertexIndex next = edges[e].b;
      // The walk along border edges has closed a loop, which is removed from the path.
      if (const auto closed = at.find(next); closed != at.end()) {
        const std::size_t first = closed->second;
        result.loops.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(first), path.end());
        for (std::size_t k = first; k < path.size(); ++k) at.erase(path[k]);
        path.resize(first);
      }
      const auto& out = from[next];
      const auto free = std::find_if(out.begin(), out.end(), [&](std::size_t k) { return !used[k]; });
      if (free == out.end()) break;
      e = *free;
    }
    result.n_edges_left += path.size();
  }
  return result;
}

Frame frame_of_normal(const Vec3& origin, const Vec3& normal) {
  Frame frame;
  const double length = norm(normal);
  if (!(length > 0)) return frame;
  frame.is_map = false;
  frame.origin = origin;
  frame.w = (1 / length) * normal;
  const bool steep = std::abs(frame.w.z) < 0.9;
  Vec3 u = cross(steep ? Vec3{0, 0, 1} : Vec3{1, 0, 0}, frame.w);
  frame.u = (1 / norm(u)) * u;
  frame.v = cross(frame.w, frame.u);
  return frame;
}

Frame frame_of(const TriangulatedSurface& surface) {
  if (surface.kind == SurfaceKind::horizon) return {};
  Vec3 mean{0, 0, 0};
  for (const Triangle& t : surface.triangles) {
    const Vec3 a = area_vector(surface, t);
    mean = mean + (dot(a, mean) < 0 ? -1.0 : 1.0) * a;
  }
  return frame_of_normal(surface.points[surface.triangles.front()[0]], mean);
}

bool faces_up(const TriangulatedSurface& surface, const Frame& frame) {
  CompensatedSum up;
  for (const Triangle& t : surface.triangles) {
    const Vec3 a = area_vector(surface, t);
    up.add(frame.is_map ? a.z : dot(a, frame.w));
  }
  return up.value() >= 0;
}

double area_from(const TriangulatedSurface& surface, std::size_t first) {
  CompensatedSum sum;
  for (std::size_t t = first; t < surface.triangles.size(); ++t)
    sum.add(norm(area_vector(surface, surface.triangles[t])));
  return sum.value();
}

}  // namespace geomesh::geomodel

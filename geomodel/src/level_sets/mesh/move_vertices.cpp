// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/mesh/move_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geomesh::geomodel {
namespace {

/// Largest distance, as a share of an edge's length, from which the edge's end is moved to a root of an isovalue on it.
constexpr double reach = 0.25;
/// Least share of its volume that every cell keeps when vertices are moved, so that none is inverted.
constexpr double least_volume_share = 0.1;

struct Target {
  double distance2 = std::numeric_limits<double>::infinity();
  Vec3 place;
  double value = 0, shift = 0;
};

double volume(const std::vector<Vec3>& points, const BackgroundMesh::Cell& cell) {
  const Vec3& o = points[cell.v[0]];
  return dot(cross(points[cell.v[1]] - o, points[cell.v[2]] - o), points[cell.v[3]] - o);
}

void offer(Target& target, double edge2, const Target& root) {
  if (root.distance2 <= reach * reach * edge2 && root.distance2 < target.distance2) target = root;
}

/// Calls visit(vertex, other end, root, isovalue) for each root on an edge, once for each end of the edge.
template <class Visit>
void for_each_root(const CrossedEdges& edges, const std::vector<double>& values, const MovedVertices& vertices,
                   Visit&& visit) {
  for (std::size_t e = 0; e < edges.edges().size(); ++e) {
    const CrossedEdges::Edge& edge = edges.edges()[e];
    for (std::size_t v = 0; v < values.size(); ++v) {
      if (!CrossedEdges::crosses(edge, values[v], vertices)) continue;
      visit(edge.below, edge.above, edges.root(v, e), values[v]);
      visit(edge.above, edge.below, edges.root(v, e), values[v]);
    }
  }
}

std::vector<Target> find_targets(const BackgroundMesh& mesh, const CrossedEdges& edges,
                                 const std::vector<double>& values, const MovedVertices& vertices) {
  std::vector<Target> targets(mesh.n_points());
  for_each_root(edges, values, vertices, [&](VertexIndex from, VertexIndex to, const Vec3& root, double value) {
    if ((mesh.sides(from) & ~mesh.sides(to)) != 0) return;
    const Vec3 edge = mesh.point(to) - mesh.point(from), way = root - mesh.point(from);
    const double edge2 = dot(edge, edge), distance2 = dot(way, way), share = std::sqrt(distance2 / edge2);
    const double shift = vertices.shift[from] + share * (vertices.shift[to] - vertices.shift[from]);
    offer(targets[from], edge2, {distance2, root, value, shift});
  });
  // A vertex between two parts of one isosurface is not moved, because moving it to one part would connect both.
  for_each_root(edges, values, vertices, [&](VertexIndex from, VertexIndex, const Vec3& root, double value) {
    Target& target = targets[from];
    if (value != target.value || !std::isfinite(target.distance2)) return;
    if (dot(root - mesh.point(from), target.place - mesh.point(from)) < 0) target = {};
  });
  return targets;
}

}  // namespace

void move_vertices(const BackgroundMesh& mesh, const CrossedEdges& edges, const std::vector<double>& values,
                   MovedVertices& vertices) {
  const std::vector<Target> targets = find_targets(mesh, edges, values, vertices);
  const auto has_target = [&](VertexIndex v) { return std::isfinite(targets[v].distance2); };
  // For each mesh vertex that will be moved: where its cells begin in `about`, the concatenated lists of cells.
  std::vector<std::size_t> begin(mesh.n_points() + 1, 0);
  for (const BackgroundMesh::Cell& cell : mesh.cells())
    for (const VertexIndex v : cell.v) begin[v + 1] += has_target(v);
  for (std::size_t v = 0; v < mesh.n_points(); ++v) begin[v + 1] += begin[v];
  std::vector<std::size_t> about(begin.back()), end(begin.begin(), begin.end() - 1);
  for (std::size_t c = 0; c < mesh.cells().size(); ++c)
    for (const VertexIndex v : mesh.cells()[c].v)
      if (has_target(v)) about[end[v]++] = c;
  const std::vector<Vec3> before = vertices.points;
  for (VertexIndex v = 0; v < mesh.n_points(); ++v) {
    if (!has_target(v)) continue;
    vertices.points[v] = targets[v].place;
    const bool keeps_cells =
        std::all_of(about.begin() + static_cast<std::ptrdiff_t>(begin[v]),
                    about.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]), [&](std::size_t c) {
                      const BackgroundMesh::Cell& cell = mesh.cells()[c];
                      return volume(vertices.points, cell) / volume(before, cell) >= least_volume_share;
                    });
    if (!keeps_cells) {
      vertices.points[v] = before[v];
      continue;
    }
    vertices.values[v] = targets[v].value;
    vertices.shift[v] = targets[v].shift;
    vertices.is_moved[v] = 1;
  }
}

}  // namespace geomesh::geomodel

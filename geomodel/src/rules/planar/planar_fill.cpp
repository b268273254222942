// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/planar/planar_fill.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <deque>

namespace geomesh::geomodel {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

/// Computes for each face the least number of constraints that a path from outside (the infinite face) crosses.
void find_depths(Triangulation& triangulation) {
  for (auto face : triangulation.all_face_handles()) face->info() = -1;
  std::deque<Triangulation::Face_handle> queue{triangulation.infinite_face()};
  triangulation.infinite_face()->info() = 0;
  while (!queue.empty()) {  // breadth-first search with edge weights 0 and 1
    const auto face = queue.front();
    queue.pop_front();
    for (int i = 0; i < 3; ++i) {
      const auto next = face->neighbor(i);
      const bool crosses = triangulation.is_constrained({face, i});
      const int depth = face->info() + (crosses ? 1 : 0);
      if (next->info() >= 0 && next->info() <= depth) continue;
      next->info() = depth;
      if (crosses) {
        queue.push_back(next);
      } else {
        queue.push_front(next);
      }
    }
  }
}

/// Returns the indices of the points along a space-filling curve, so that each is inserted near the previous one.
std::vector<Index> spatial_order(const std::vector<Vec2>& points) {
  std::vector<std::pair<Kernel::Point_2, Index>> rows;
  for (Index i = 0; i < points.size(); ++i) rows.push_back({{points[i].x, points[i].y}, i});
  using Map = CGAL::First_of_pair_property_map<std::pair<Kernel::Point_2, Index>>;
  CGAL::spatial_sort(rows.begin(), rows.end(), CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>());
  std::vector<Index> order;
  for (const auto& [_, row] : rows) order.push_back(row);
  return order;
}

/// Makes the Delaunay triangulation unique where four points are cocircular, so that both diagonals between them are
/// Delaunay. The diagonal is chosen that avoids the last of the points, by y and then x, as if later points lay
/// slightly outside the circle. The squares of a grid then have parallel diagonals, and the flips terminate.
void settle_ties(Triangulation& triangulation) {
  const auto is_before = [](const Triangulation::Vertex_handle& v, const Triangulation::Vertex_handle& w) {
    const auto &p = v->point(), &q = w->point();
    return p.y() != q.y() ? p.y() < q.y() : p.x() < q.x();
  };
  // Faces are visited in the order of their creation. CGAL visits edges by the addresses of faces in memory, which
  // would make the order of the triangles vary.
  std::vector<Triangulation::Edge> queue;
  for (auto face : triangulation.finite_face_handles())
    for (int k = 0; k < 3; ++k) queue.emplace_back(face, k);
  while (!queue.empty()) {
    auto [face, i] = queue.back();
    queue.pop_back();
    const Triangulation::Face_handle other = face->neighbor(i);
    if (triangulation.is_constrained({face, i}) || triangulation.is_infinite(face) || triangulation.is_infinite(other))
      continue;
    const int j = other->index(face);
    const auto a = face->vertex(Triangulation::cw(i)), b = face->vertex(Triangulation::ccw(i)), c = face->vertex(i),
               d = other->vertex(j);
    const auto last = std::max({a, b, c, d}, is_before);
    if (last != a && last != b) continue;
    if (triangulation.side_of_oriented_circle(face, d->point(), false) != CGAL::ON_ORIENTED_BOUNDARY) continue;
    triangulation.flip(face, i);
    for (const auto& f : {face, other})
      for (int k = 0; k < 3; ++k) queue.emplace_back(f, k);
  }
}

}  // namespace

std::optional<std::vector<PlanarTriangle>> triangulate_plane(const std::vector<Vec2>& points,
                                                             const std::vector<std::pair<Index, Index>>& constraints) {
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices(points.size());
  Triangulation::Face_handle near;
  for (const Index i : spatial_order(points)) {
    const std::size_t n_before = triangulation.number_of_vertices();
    vertices[i] = triangulation.insert({points[i].x, points[i].y}, near);
    if (triangulation.number_of_vertices() == n_before) return std::nullopt;
    vertices[i]->info() = i;
    near = vertices[i]->face();
  }
  try {
    for (const auto& [a, b] : constraints) triangulation.insert_constraint(vertices[a], vertices[b]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return std::nullopt;
  }
  if (triangulation.dimension() < 2) return std::nullopt;
  settle_ties(triangulation);
  for (const auto& [a, b] : constraints) {
    Triangulation::Face_handle face;
    int at = 0;
    if (!triangulation.is_edge(vertices[a], vertices[b], face, at)) return std::nullopt;
  }
  find_depths(triangulation);
  std::vector<PlanarTriangle> result;
  for (auto face : triangulation.finite_face_handles())
    result.push_back({{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()}, face->info()});
  return result;
}

}  // namespace geomesh::geomodel

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
#include <numeric>

namespace geomesh::geomodel {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

/// Fewest constraints between each face and the infinite one.
void find_depths(Triangulation& triangulation) {
  for (auto face : triangulation.all_face_handles()) face->info() = -1;
  std::deque<Triangulation::Face_handle> queue{triangulation.infinite_face()};
  triangulation.infinite_face()->info() = 0;
  while (!queue.empty()) {  // breadth first with weights 0 and 1
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

/// Vertices by the row of their point; none where two points are one. The points are inserted along a curve that fills
/// the plane: row by row of a long grid, each would flip a row of edges.
std::optional<std::vector<Triangulation::Vertex_handle>> insert_points(Triangulation& triangulation,
                                                                       const std::vector<Vec2>& points) {
  std::vector<Kernel::Point_2> places;
  for (const Vec2& p : points) places.emplace_back(p.x, p.y);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto place_of = CGAL::make_property_map(places);
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(place_of)>(place_of));
  std::vector<Triangulation::Vertex_handle> vertices(points.size());
  Triangulation::Face_handle near;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto vertex = triangulation.insert(places[order[k]], near);
    if (triangulation.number_of_vertices() != k + 1) return std::nullopt;
    vertex->info() = static_cast<Index>(order[k]);
    vertices[order[k]] = vertex;
    near = vertex->face();
  }
  return vertices;
}

}  // namespace

std::optional<std::vector<PlanarTriangle>> triangulate_plane(const std::vector<Vec2>& points,
                                                             const std::vector<std::pair<Index, Index>>& constraints) {
  Triangulation triangulation;
  const auto inserted = insert_points(triangulation, points);
  if (!inserted) return std::nullopt;
  const std::vector<Triangulation::Vertex_handle>& vertices = *inserted;
  try {
    for (const auto& [a, b] : constraints) triangulation.insert_constraint(vertices[a], vertices[b]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return std::nullopt;
  }
  if (triangulation.dimension() < 2) return std::nullopt;
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

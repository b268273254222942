// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/planar/planar_fill.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

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

}  // namespace

std::optional<std::vector<PlanarTriangle>> triangulate_plane(const std::vector<Vec2>& points,
                                                             const std::vector<std::pair<Index, Index>>& constraints) {
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (Index i = 0; i < points.size(); ++i) {
    vertices.push_back(triangulation.insert({points[i].x, points[i].y}));
    if (triangulation.number_of_vertices() != i + 1) return std::nullopt;
    vertices.back()->info() = i;
  }
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

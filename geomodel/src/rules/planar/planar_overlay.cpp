// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/planar/planar_overlay.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <map>

namespace geomesh::geomodel {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default, CGAL::Exact_predicates_tag>;

}  // namespace

PlanarOverlay overlay_in_map(const std::vector<const TriangulatedSurface*>& surfaces) {
  Triangulation triangulation;
  for (const TriangulatedSurface* s : surfaces) {
    std::vector<Triangulation::Vertex_handle> vertices;
    Triangulation::Face_handle near;
    for (const Vec3& p : s->points) {
      vertices.push_back(triangulation.insert({p.x, p.y}, near));
      near = vertices.back()->face();
    }
    for (const Triangle& t : s->triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexIndex a = t[i], b = t[(i + 1) % 3];
        if (vertices[a] != vertices[b]) triangulation.insert_constraint(vertices[a], vertices[b]);
      }
  }
  PlanarOverlay overlay;
  std::map<Triangulation::Vertex_handle, VertexIndex> row;
  for (auto v : triangulation.finite_vertex_handles()) {
    row.emplace(v, static_cast<VertexIndex>(overlay.points.size()));
    overlay.points.push_back({v->point().x(), v->point().y()});
  }
  for (auto f : triangulation.finite_face_handles())
    overlay.triangles.push_back({row.at(f->vertex(0)), row.at(f->vertex(1)), row.at(f->vertex(2))});
  return overlay;
}

}  // namespace geomesh::geomodel

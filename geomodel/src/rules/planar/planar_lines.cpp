// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/planar/planar_lines.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace geomesh::geomodel {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Structure = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<VertexIndex, Kernel>,
                                                       CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;

}  // namespace

LinedTriangulation triangulate_lines(const std::vector<Vec2>& points, const std::vector<std::vector<Vec2>>& lines) {
  Triangulation triangulation;
  Triangulation::Face_handle near;
  const auto insert = [&](const Vec2& p) {
    const auto v = triangulation.insert({p.x, p.y}, near);
    near = v->face();
    return v;
  };
  for (const Vec2& p : points) insert(p);
  for (const std::vector<Vec2>& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) {
      const auto a = insert(line[i - 1]), b = insert(line[i]);
      if (a == b) continue;
      triangulation.insert_constraint(a, b);
      // Face handles become invalid, because inserting a constraint removes the faces that it crosses.
      near = b->face();
    }
  LinedTriangulation result;
  for (auto v : triangulation.finite_vertex_handles()) {
    v->info() = static_cast<VertexIndex>(result.points.size());
    result.points.push_back({v->point().x(), v->point().y()});
  }
  for (auto f : triangulation.finite_face_handles()) {
    result.triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    std::uint8_t sides = 0;
    for (int i = 0; i < 3; ++i)
      if (f->is_constrained(i)) sides = static_cast<std::uint8_t>(sides | 1U << i);
    result.lined_sides.push_back(sides);
  }
  return result;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the surface of the union of a regular dodecahedron and a regular icosahedron as triangles (OFF on standard
// output): the model of Figure 3 of Cavalcanti and Mello (1999). Computed exactly, rounded to doubles, and checked for
// crossings after rounding. Build: c++ -std=c++17 -O2 make_dodecahedron_icosahedron.cpp -lgmp -lmpfr
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <cmath>
#include <cstdio>
#include <vector>

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Plain = CGAL::Exact_predicates_inexact_constructions_kernel;
using ExactMesh = CGAL::Surface_mesh<Exact::Point_3>;
using PlainMesh = CGAL::Surface_mesh<Plain::Point_3>;

int main() {
  const double g = (1 + std::sqrt(5.0)) / 2, h = 1 / g;
  std::vector<Exact::Point_3> dodecahedron, icosahedron;
  for (int i = 0; i < 8; ++i) dodecahedron.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  for (double a : {-1.0, 1.0})
    for (double b : {-1.0, 1.0}) {
      const double p = a * h, q = b * g, r = a * 0.9, s = b * 0.9 * g;
      dodecahedron.insert(dodecahedron.end(), {{0, p, q}, {p, q, 0}, {q, 0, p}});
      icosahedron.insert(icosahedron.end(), {{0, s, r}, {s, r, 0}, {r, 0, s}});
    }
  ExactMesh first, second, joined;
  CGAL::convex_hull_3(dodecahedron.begin(), dodecahedron.end(), first);
  CGAL::convex_hull_3(icosahedron.begin(), icosahedron.end(), second);
  if (!CGAL::Polygon_mesh_processing::corefine_and_compute_union(first, second, joined)) return 1;
  joined.collect_garbage();
  PlainMesh rounded;
  for (auto v : joined.vertices()) {
    const auto& p = joined.point(v);
    rounded.add_vertex({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }
  std::printf("OFF\n%zu %zu 0\n", static_cast<std::size_t>(rounded.number_of_vertices()),
              static_cast<std::size_t>(joined.number_of_faces()));
  for (auto v : rounded.vertices())
    std::printf("%.17g %.17g %.17g\n", rounded.point(v).x(), rounded.point(v).y(), rounded.point(v).z());
  for (auto f : joined.faces()) {
    std::vector<PlainMesh::Vertex_index> corners;
    for (auto v : CGAL::vertices_around_face(joined.halfedge(f), joined))
      corners.emplace_back(static_cast<PlainMesh::size_type>(v));
    rounded.add_face(corners);
    std::printf("3 %u %u %u\n", unsigned(corners[0]), unsigned(corners[1]), unsigned(corners[2]));
  }
  return CGAL::Polygon_mesh_processing::does_self_intersect(rounded) ? 1 : 0;
}

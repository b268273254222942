// SPDX-License-Identifier: MIT
#include "geomesh/core/dual_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/geometry.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "geomesh/core/voronoi_dual.hpp"
#include "mesh/circumcentre.hpp"
#include "quality/measure/shape.hpp"

namespace geomesh {

namespace {

struct Part {
  std::array<VertexIndex, 2> edge;
  double area;
};

/// The piece of the dual of edge a-b in a cell, next to face a,b,c: a right triangle from the edge's middle over the
/// face's circumcentre to the cell's. Each leg has a sign: towards c in the face, towards the apex off it.
double dual_piece(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& apex, const Vec3& cell_centre) {
  const auto face_centre = circumcentre(a, b, c);
  const Vec3 u = b - a, n = cross(u, c - a);
  if (!face_centre || dot(n, n) == 0) return 0;
  const Vec3 middle = 0.5 * (a + b), in_face = cross(n, u);  // points towards c
  const double along = dot(*face_centre - middle, in_face) / length(in_face);
  const double up = dot(cell_centre - *face_centre, n) / length(n) * (dot(apex - a, n) > 0 ? 1 : -1);
  return 0.5 * along * up;
}

void add_parts(std::span<const Vec3> points, const Tetrahedron& t, std::vector<Part>& parts) {
  const auto centre = circumcentre(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
  if (!centre) return;
  for (const auto& e : edge_vertices) {
    std::array<unsigned, 2> rest{};
    unsigned n = 0;
    for (unsigned k = 0; k < 4; ++k)
      if (k != e[0] && k != e[1]) rest[n++] = k;
    const Vec3 &a = points[t[e[0]]], &b = points[t[e[1]]], &c = points[t[rest[0]]], &d = points[t[rest[1]]];
    parts.push_back({{std::min(t[e[0]], t[e[1]]), std::max(t[e[0]], t[e[1]])},
                     dual_piece(a, b, c, d, *centre) + dual_piece(a, b, d, c, *centre)});
  }
}

/// Edges of faces that only one tetrahedron has, sorted.
std::vector<std::array<VertexIndex, 2>> border_edges(std::span<const Tetrahedron> tetrahedra) {
  std::vector<Triangle> faces;
  for (const Tetrahedron& t : tetrahedra)
    for (const auto& l : face_vertices) {
      Triangle f{t[l[0]], t[l[1]], t[l[2]]};
      std::sort(f.begin(), f.end());
      faces.push_back(f);
    }
  std::sort(faces.begin(), faces.end());
  std::vector<std::array<VertexIndex, 2>> edges;
  for (std::size_t i = 0, j = 0; i < faces.size(); i = j) {
    for (j = i; j < faces.size() && faces[j] == faces[i];) ++j;
    if (j - i == 1)
      for (const auto& e : {std::array{faces[i][0], faces[i][1]}, std::array{faces[i][0], faces[i][2]},
                            std::array{faces[i][1], faces[i][2]}})
        edges.push_back(e);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

std::vector<DualFace> dual_faces(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra) {
  std::vector<Part> parts;
  parts.reserve(6 * tetrahedra.size());
  for (const Tetrahedron& t : tetrahedra) add_parts(points, t, parts);
  std::stable_sort(parts.begin(), parts.end(), [](const Part& x, const Part& y) { return x.edge < y.edge; });
  const auto border = border_edges(tetrahedra);
  std::vector<DualFace> faces;
  for (std::size_t i = 0, j = 0; i < parts.size(); i = j) {
    double area = 0;
    for (j = i; j < parts.size() && parts[j].edge == parts[i].edge; ++j) area += parts[j].area;
    faces.push_back(
        {parts[i].edge[0], parts[i].edge[1], area, std::binary_search(border.begin(), border.end(), parts[i].edge)});
  }
  return faces;
}

VoronoiDual measure_voronoi_dual(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra) {
  VoronoiDual dual;
  for (const DualFace& face : dual_faces(points, tetrahedra)) {
    const double relative = face.area / squared_distance(points[face.a], points[face.b]);
    dual.least = dual.edges == 0 ? relative : std::min(dual.least, relative);
    ++dual.edges;
    if (relative >= -1e-12) continue;
    ++dual.negative;
    dual.negative_on_border += face.on_border;
  }
  return dual;
}

}  // namespace geomesh

// SPDX-License-Identifier: MIT
#include "remesh/rescue/neighbourhood.hpp"

#include <algorithm>
#include <limits>

#include "quality/measure/shape.hpp"

namespace geomesh::remesh {

namespace {

template <class T>
void sort_unique(std::vector<T>& v) {
  std::sort(v.begin(), v.end());
  v.erase(std::unique(v.begin(), v.end()), v.end());
}

}  // namespace

Vec3 centroid(const DomainMesh& mesh, CellIndex c) {
  const Tetrahedron& t = mesh.vertices(c);
  return 0.25 * (mesh.point(t[0]) + mesh.point(t[1]) + mesh.point(t[2]) + mesh.point(t[3]));
}

std::vector<CellIndex> cells_about(Toolbox& tools, const Tetrahedron& t) {
  std::vector<CellIndex> star, cells;
  for (const VertexIndex v : t) {
    tools.mesh.star(v, tools.work.marks, star);
    for (const CellIndex c : star)
      if (std::count_if(t.begin(), t.end(), [&](VertexIndex w) { return tools.mesh.topology().has_vertex(c, w); }) > 1)
        cells.push_back(c);
  }
  sort_unique(cells);
  return cells;
}

std::vector<VertexIndex> movable_about(Toolbox& tools, const Tetrahedron& t) {
  std::vector<CellIndex> star;
  std::vector<VertexIndex> about;
  for (const VertexIndex v : t) {
    tools.mesh.star(v, tools.work.marks, star);
    for (const CellIndex c : star)
      for (const VertexIndex w : tools.mesh.vertices(c))
        if (tools.mesh.kind(w) != VertexKind::corner) about.push_back(w);
  }
  sort_unique(about);
  return about;
}

VertexIndex nearest_neighbour(Toolbox& tools, VertexIndex u) {
  const DomainMesh& mesh = tools.mesh;
  std::vector<CellIndex> star;
  mesh.star(u, tools.work.marks, star);
  VertexIndex nearest = no_vertex;
  double least = std::numeric_limits<double>::infinity();
  for (const CellIndex c : star)
    for (const VertexIndex w : mesh.vertices(c)) {
      const double d = squared_distance(mesh.point(u), mesh.point(w));
      if (w != u && (d < least || (d == least && w < nearest))) least = d, nearest = w;
    }
  return nearest;
}

std::vector<std::array<VertexIndex, 2>> edges_to_collapse(Toolbox& tools, const Tetrahedron& t) {
  std::vector<std::array<VertexIndex, 2>> edges;
  for (const VertexIndex u : movable_about(tools, t)) edges.push_back({u, nearest_neighbour(tools, u)});
  for (const VertexIndex u : t)
    for (const VertexIndex v : t)
      if (u != v && tools.mesh.kind(u) != VertexKind::corner) edges.push_back({u, v});
  return edges;
}

}  // namespace geomesh::remesh

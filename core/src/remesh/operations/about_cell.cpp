// SPDX-License-Identifier: MIT
// Operations on one cell that try all its edges and faces until one improves shapes. Declared in
// remesh/operations/improve.hpp.
#include "remesh/operations/improve.hpp"

namespace geomesh::remesh {

bool flip_about_cell(Toolbox& tools, CellIndex c) {
  const Tetrahedron t = tools.mesh.vertices(c);
  for (const auto& e : edge_vertices)
    if (remove_edge(tools, c, t[e[0]], t[e[1]])) return true;
  for (unsigned i = 0; i < 4; ++i)
    if (remove_face(tools, c, i)) return true;
  return false;
}

bool collapse_about_cell(Toolbox& tools, CellIndex c) {
  const Tetrahedron t = tools.mesh.vertices(c);
  for (const auto& e : edge_vertices)
    for (const auto& [u, v] : {std::pair(t[e[0]], t[e[1]]), std::pair(t[e[1]], t[e[0]])})
      if (try_collapse(tools, u, v, CollapseRule::improve)) return true;
  return false;
}

bool add_point_about_cell(Toolbox& tools, CellIndex c, double room) {
  const Tetrahedron t = tools.mesh.vertices(c);
  for (const auto& e : edge_vertices)
    if (split_to_improve(tools, c, t[e[0]], t[e[1]], room)) return true;
  return insert_to_improve(tools, c, room);
}

}  // namespace geomesh::remesh

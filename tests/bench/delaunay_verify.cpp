// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay_verify.hpp"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <vector>

#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/validate.hpp"

namespace geomesh::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<VertexIndex, Kernel>;
using Oracle = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex>>;

std::vector<Tetrahedron> sorted(std::vector<Tetrahedron> cells) {
  for (Tetrahedron& c : cells) std::sort(c.begin(), c.end());
  std::sort(cells.begin(), cells.end());
  return cells;
}

std::vector<Tetrahedron> finite_cells(const TetMesh& mesh) {
  std::vector<Tetrahedron> cells;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    if (mesh.is_live(c) && !mesh.is_ghost(c)) cells.push_back(mesh.vertices(c));
  return sorted(std::move(cells));
}

/// Equal points must have been left out.
std::vector<Tetrahedron> oracle_cells(std::span<const Vec3> points, const std::vector<VertexIndex>& representative) {
  std::vector<std::pair<Kernel::Point_3, VertexIndex>> input;
  for (VertexIndex v = 0; v < points.size(); ++v)
    if (representative[v] == v) input.emplace_back(Kernel::Point_3(points[v].x, points[v].y, points[v].z), v);
  const Oracle oracle(input.begin(), input.end());
  std::vector<Tetrahedron> cells;
  for (auto c = oracle.finite_cells_begin(); c != oracle.finite_cells_end(); ++c)
    cells.push_back({c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()});
  return sorted(std::move(cells));
}

bool same_slots(const TetMesh& a, const TetMesh& b) {
  bool same = a.n_slots() == b.n_slots();
  for (CellIndex c = 0; same && c < a.n_slots(); ++c)
    same = a.vertices(c) == b.vertices(c) && a.cells()[c].neighbors == b.cells()[c].neighbors;
  return same;
}

}  // namespace

Verification verify(std::span<const Vec3> points) {
  RunContext context;
  context.threads = 1;
  const DelaunayTetrahedralization cavity = delaunay_tetrahedralization(points, {}, context);
  Verification r;
  r.faults = validate_topology(cavity.mesh).size() + validate_geometry(cavity.mesh, points).size() +
             validate_delaunay(cavity.mesh, points).size();
  context.threads = 2;
  r.threads_agree = same_slots(cavity.mesh, delaunay_tetrahedralization(points, {}, context).mesh);
  const std::vector<Tetrahedron> cells = finite_cells(cavity.mesh);
  r.tetrahedra = cells.size();
  DelaunayOptions flips;
  flips.algorithm = DelaunayAlgorithm::flip;
  const DelaunayTetrahedralization flipped = delaunay_tetrahedralization(points, flips, context);
  r.flips_agree = flipped.statistics.stuck_faces == 0 && flipped.representative == cavity.representative &&
                  finite_cells(flipped.mesh) == cells;
  r.cgal_agrees = oracle_cells(points, cavity.representative) == cells;
  return r;
}

}  // namespace geomesh::bench

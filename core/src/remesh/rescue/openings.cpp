// SPDX-License-Identifier: MIT
#include "remesh/rescue/openings.hpp"

#include <algorithm>

#include "common/geometry.hpp"
#include "common/sort_unique.hpp"
#include "remesh/operations/improve.hpp"

namespace geomesh::remesh {

namespace {

class Opening {
 public:
  Opening(Toolbox& tools, CellIndex c, Random& choose) : tools_(tools), mesh_(tools.mesh), choose_(choose), seed_(c) {}

  bool run() {
    const CellIndex c = choose_cell();
    switch (choose_.below(7)) {
      case 0:
      case 1:
        return remove_vertex(mesh_.vertices(c)[choose_.below(4)]);
      case 2:
        return split(c);
      case 3:
        return insert(c);
      case 4:
        return insert_on_face(c);
      case 5:
        return flip_edge(c);
      default:
        return remove_face_above(tools_, c, choose_.below(4), opening_shape);
    }
  }

 private:
  /// Returns the bad cell itself, or a random cell that shares an edge or a vertex with it.
  CellIndex choose_cell() {
    if (choose_.below(3) == 0) return seed_;
    const Tetrahedron& t = mesh_.vertices(seed_);
    if (choose_.below(3) == 0) return one_of_star(t[choose_.below(4)]);
    const auto& e = edge_vertices[choose_.below(6)];
    std::vector<CellIndex> cells;
    std::vector<VertexIndex> ring;
    turn_about_edge(mesh_.cells(), seed_, t[e[0]], t[e[1]], cells, ring);
    return cells[choose_.below(static_cast<unsigned>(cells.size()))];
  }
  CellIndex one_of_star(VertexIndex v) {
    std::vector<CellIndex> star;
    mesh_.star(v, tools_.work.marks, star);
    return star[choose_.below(static_cast<unsigned>(star.size()))];
  }

  /// Contracts an edge from u to the first of its neighbours for which this is possible, beginning with a random one.
  bool remove_vertex(VertexIndex u) {
    if (mesh_.kind(u) == VertexKind::corner) return false;
    std::vector<CellIndex> star;
    mesh_.star(u, tools_.work.marks, star);
    std::vector<VertexIndex> neighbours;
    for (const CellIndex c : star)
      for (const VertexIndex v : mesh_.vertices(c))
        if (v != u && (mesh_.kind(u) != VertexKind::curve || mesh_.curve_of(u, v) != no_index)) neighbours.push_back(v);
    sort_unique(neighbours);
    if (neighbours.empty()) return false;
    std::rotate(neighbours.begin(), neighbours.begin() + choose_.below(static_cast<unsigned>(neighbours.size())),
                neighbours.end());
    return try_collapse_into_any(tools_, u, neighbours, CollapseRule::coarsen, opening_shape);
  }

  bool split(CellIndex c) {
    const Tetrahedron t = mesh_.vertices(c);
    const auto& e = edge_vertices[choose_.below(6)];
    const double s = choose_.between(0.25, 0.75);
    const Vec3 &a = mesh_.point(t[e[0]]), &b = mesh_.point(t[e[1]]), p = a + s * (b - a);
    return split_edge(tools_, c, t[e[0]], t[e[1]], opening_shape, &p).has_value();
  }

  /// Returns a random point inside a tetrahedron or triangle; each barycentric weight is at least 0.03.
  template <std::size_t n>
  Vec3 place_in(const std::array<Vec3, n>& corners) {
    std::array<double, n> weights;
    double sum = 0;
    for (double& w : weights) sum += w = choose_.between(0.1, 1);
    Vec3 p;
    for (std::size_t k = 0; k < n; ++k) p = p + (weights[k] / sum) * corners[k];
    return p;
  }

  bool insert(CellIndex c) {
    return insert_inside(tools_, place_in(mesh_.places(mesh_.vertices(c))), c, {.min_shape = opening_shape})
        .has_value();
  }

  bool insert_on_face(CellIndex c) {
    const auto first = choose_.below(4);
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned i = (first + k) & 3u;
      if (!mesh_.tag(c, i).constrained()) continue;
      const Vec3 p = place_in(mesh_.places(mesh_.face(c, i)));
      return insert_on_surface(tools_, p, FaceRef(c, i), {.min_shape = opening_shape}).has_value();
    }
    return false;
  }

  bool flip_edge(CellIndex c) {
    const Tetrahedron t = mesh_.vertices(c);
    const auto& e = edge_vertices[choose_.below(6)];
    return remove_edge_above(tools_, c, t[e[0]], t[e[1]], opening_shape);
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  Random& choose_;
  CellIndex seed_;
};

}  // namespace

bool open_about_cell(Toolbox& tools, CellIndex c, Random& choose) { return Opening(tools, c, choose).run(); }

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
  std::pair<double, VertexIndex> nearest{std::numeric_limits<double>::infinity(), no_vertex};
  for (const CellIndex c : star)
    for (const VertexIndex w : mesh.vertices(c))
      if (w != u) nearest = std::min(nearest, {squared_distance(mesh.point(u), mesh.point(w)), w});
  return nearest.second;
}

bool clear_about(Toolbox& tools, const Tetrahedron& t) {
  std::size_t n = 0;
  for (const VertexIndex u : movable_about(tools, t))
    if (tools.mesh.kind(u) == VertexKind::inside)
      n += try_collapse(tools, u, nearest_neighbour(tools, u), CollapseRule::coarsen, opening_shape);
  return n > 0;
}

}  // namespace geomesh::remesh

// SPDX-License-Identifier: MIT
#include "remesh/rescue/openings.hpp"

#include <algorithm>

#include "common/sort_unique.hpp"
#include "remesh/operations/improve.hpp"

namespace geomesh::remesh {

namespace {

class Opening {
 public:
  Opening(Toolbox& tools, CellIndex c, Chooser& choose) : tools_(tools), mesh_(tools.mesh), choose_(choose), seed_(c) {}

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
        return remove_face_above(tools_, c, static_cast<unsigned>(choose_.below(4)), opening_shape);
    }
  }

 private:
  /// The cell itself, or one about one of its vertices.
  CellIndex choose_cell() {
    if (choose_.below(3) == 0) return seed_;
    const Tetrahedron& t = mesh_.vertices(seed_);
    if (choose_.below(3) == 0) return one_of_star(t[choose_.below(4)]);
    const auto& e = edge_vertices[choose_.below(6)];
    std::vector<CellIndex> cells;
    std::vector<VertexIndex> ring;
    edge_ring(mesh_, seed_, t[e[0]], t[e[1]], cells, ring);
    return cells[choose_.below(cells.size())];
  }
  CellIndex one_of_star(VertexIndex v) {
    std::vector<CellIndex> star;
    mesh_.star(v, tools_.work.marks, star);
    return star[choose_.below(star.size())];
  }

  /// Into the first neighbour that takes it, from a chosen one on.
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
    std::rotate(neighbours.begin(), neighbours.begin() + static_cast<std::ptrdiff_t>(choose_.below(neighbours.size())),
                neighbours.end());
    return std::any_of(neighbours.begin(), neighbours.end(),
                       [&](VertexIndex v) { return try_collapse(tools_, u, v, CollapseRule::coarsen, opening_shape); });
  }

  bool split(CellIndex c) {
    const Tetrahedron t = mesh_.vertices(c);
    const auto& e = edge_vertices[choose_.below(6)];
    const double s = choose_.between(0.25, 0.75);
    const Vec3 &a = mesh_.point(t[e[0]]), &b = mesh_.point(t[e[1]]), p = a + s * (b - a);
    return split_edge(tools_, c, t[e[0]], t[e[1]], opening_shape, &p).has_value();
  }

  /// Weights of at least a twentieth that sum to one.
  template <std::size_t n>
  std::array<double, n> weights() {
    std::array<double, n> w;
    double sum = 0;
    for (double& x : w) sum += x = choose_.between(0.1, 1);
    for (double& x : w) x /= sum;
    return w;
  }

  bool insert(CellIndex c) {
    const Tetrahedron& t = mesh_.vertices(c);
    const auto w = weights<4>();
    const Vec3 p =
        w[0] * mesh_.point(t[0]) + w[1] * mesh_.point(t[1]) + w[2] * mesh_.point(t[2]) + w[3] * mesh_.point(t[3]);
    return insert_inside(tools_, p, c, {0, opening_shape}).has_value();
  }

  bool insert_on_face(CellIndex c) {
    const auto first = static_cast<unsigned>(choose_.below(4));
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned i = (first + k) & 3u;
      if (!mesh_.tag(c, i).constrained()) continue;
      const Tetrahedron& t = mesh_.vertices(c);
      const auto& f = face_vertices[i];
      const auto w = weights<3>();
      const Vec3 p = w[0] * mesh_.point(t[f[0]]) + w[1] * mesh_.point(t[f[1]]) + w[2] * mesh_.point(t[f[2]]);
      return insert_on_surface(tools_, p, FaceRef(c, i), {0, opening_shape}).has_value();
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
  Chooser& choose_;
  CellIndex seed_;
};

}  // namespace

bool open_about_cell(Toolbox& tools, CellIndex c, Chooser& choose) { return Opening(tools, c, choose).run(); }

}  // namespace geomesh::remesh

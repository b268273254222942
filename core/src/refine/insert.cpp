// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "geomesh/core/predicates.hpp"
#include "quality/shape.hpp"
#include "refine/operations.hpp"

namespace geomesh::remesh {

Sphere circumsphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const Vec3 vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const Vec3 offset = (0.5 / dot(u, vw)) * (dot(u, u) * vw + dot(v, v) * wu + dot(w, w) * uv);
  return {a + offset, length(offset)};
}

namespace {

/// Walks towards p; stops at constrained faces and after a bounded number of steps.
std::optional<CellIndex> locate(const DomainMesh& mesh, const Vec3& p, CellIndex start) {
  CellIndex c = start;
  for (unsigned step = 0; step < 1000; ++step) {
    const Tetrahedron& t = mesh.vertices(c);
    unsigned leave = 4;
    for (unsigned k = 0; k < 4 && leave == 4; ++k) {
      const unsigned i = (k + step) & 3u;  // turns the order, so that the walk cannot cycle for long
      const auto& f = face_vertices[i];
      if (!is_positive(mesh.point(t[f[0]]), mesh.point(t[f[1]]), mesh.point(t[f[2]]), p) &&
          orient3d(mesh.point(t[f[0]]), mesh.point(t[f[1]]), mesh.point(t[f[2]]), p) == Sign::negative)
        leave = i;
    }
    if (leave == 4) return c;
    if (mesh.tag(c, leave).constrained()) return std::nullopt;
    c = mesh.topology().neighbor_cell(c, leave);
  }
  return std::nullopt;
}

class Insertion {
 public:
  Insertion(Toolbox& tools, const Vec3& p) : tools_(tools), mesh_(tools.mesh), p_(p) {}

  std::optional<VertexIndex> attempt(CellIndex start, const InsertionRule& rule) {
    const std::optional<CellIndex> home = locate(mesh_, p_, start);
    if (!home) return std::nullopt;
    for (const VertexIndex v : mesh_.vertices(*home))
      if (squared_distance(mesh_.point(v), p_) < rule.spacing * rule.spacing) return std::nullopt;
    grow(*home);
    if (!shrink_until_visible(*home) || !keeps_spacing(rule.spacing) || !keeps_constraints()) return std::nullopt;
    StarCavity& cavity = tools_.work.cavity;
    if (rule.min_shape > 0 && !(star_shape(mesh_, cavity, p_, rule.min_shape) > rule.min_shape)) return std::nullopt;
    const VertexIndex v = mesh_.add_vertex(p_, VertexKind::inside);
    fill_with_star(mesh_, cavity, v, tools_.work);
    ++tools_.statistics.points_inside;
    return v;
  }

 private:
  bool in_circumsphere(CellIndex c) const {
    const Tetrahedron& t = mesh_.vertices(c);
    const Sphere s = circumsphere(mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2]), mesh_.point(t[3]));
    return squared_distance(s.centre, p_) < s.radius * s.radius;
  }

  /// A shape criterion in doubles decides which cells to take; validity is decided later and exactly.
  void grow(CellIndex home) {
    auto& cells = tools_.work.cells;
    CellMarks& marks = tools_.work.marks;
    cells.assign(1, home);
    marks.begin(mesh_.n_slots());
    marks.mark(home);
    for (std::size_t k = 0; k < cells.size() && cells.size() < 400; ++k)
      for (unsigned i = 0; i < 4; ++i) {
        if (mesh_.tag(cells[k], i).constrained()) continue;
        const CellIndex n = mesh_.topology().neighbor_cell(cells[k], i);
        if (marks.marked(n) || !in_circumsphere(n)) continue;
        marks.mark(n);
        cells.push_back(n);
      }
  }

  bool sees_border(CellIndex c) const {
    const Tetrahedron& t = mesh_.vertices(c);
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef n = mesh_.topology().neighbor(c, i);
      if (n.valid() && tools_.work.marks.marked(n.cell()) && !mesh_.tag(c, i).constrained()) continue;
      const auto& f = face_vertices[i];
      if (!is_positive(mesh_.point(t[f[0]]), mesh_.point(t[f[1]]), mesh_.point(t[f[2]]), p_)) return false;
    }
    return true;
  }

  /// Gives up cells whose border face p does not see, then those cut off from home by that, until all is seen.
  bool shrink_until_visible(CellIndex home) {
    auto& cells = tools_.work.cells;
    CellMarks& marks = tools_.work.marks;
    for (bool shrunk = true; shrunk;) {
      shrunk = false;
      for (const CellIndex c : cells)
        if (marks.marked(c) && !sees_border(c)) {
          if (c == home) return false;
          marks.unmark(c);
          shrunk = true;
        }
      if (shrunk) keep_connected(home);
    }
    tools_.work.created.assign(cells.begin(), cells.end());  // gather_cells uses the marks anew
    gather_cells(mesh_, marks, tools_.work.created, tools_.work.cavity);
    return true;
  }

  void keep_connected(CellIndex home) {
    auto& cells = tools_.work.cells;
    CellMarks& marks = tools_.work.marks;
    std::vector<CellIndex> kept{home};
    marks.unmark(home);
    for (std::size_t k = 0; k < kept.size(); ++k)
      for (unsigned i = 0; i < 4; ++i) {
        if (mesh_.tag(kept[k], i).constrained()) continue;
        const CellIndex n = mesh_.topology().neighbor_cell(kept[k], i);
        if (!marks.marked(n)) continue;
        marks.unmark(n);
        kept.push_back(n);
      }
    for (const CellIndex c : cells) marks.unmark(c);
    for (const CellIndex c : kept) marks.mark(c);
    cells = std::move(kept);
  }

  bool keeps_spacing(double spacing) const {
    const double limit = spacing * spacing;
    for (const LinkFace& f : tools_.work.cavity.link)
      for (const VertexIndex v : f.vertices)
        if (squared_distance(mesh_.point(v), p_) < limit) return false;
    return true;
  }

  bool on_link(VertexIndex a, VertexIndex b) const {
    for (const LinkFace& f : tools_.work.cavity.link) {
      const auto has = [&](VertexIndex v) { return f.vertices[0] == v || f.vertices[1] == v || f.vertices[2] == v; };
      if (has(a) && has(b)) return true;
    }
    return false;
  }

  /// No vertex, no constrained face and no curve edge may be swallowed.
  bool keeps_constraints() const {
    for (const CellIndex c : tools_.work.cavity.cells) {
      const Tetrahedron& t = mesh_.vertices(c);
      for (unsigned i = 0; i < 4; ++i) {
        if (!on_link(t[i], t[i])) return false;
        if (!mesh_.tag(c, i).constrained()) continue;
        const FaceRef n = mesh_.topology().neighbor(c, i);
        const auto& cells = tools_.work.cavity.cells;
        if (n.valid() && std::find(cells.begin(), cells.end(), n.cell()) != cells.end()) return false;
      }
      for (const auto& e : edge_vertices)
        if (mesh_.curve_of(t[e[0]], t[e[1]]) != no_index && !on_link(t[e[0]], t[e[1]])) return false;
    }
    return true;
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  Vec3 p_;
};

}  // namespace

std::optional<VertexIndex> insert_inside(Toolbox& tools, const Vec3& p, CellIndex start, const InsertionRule& rule) {
  return Insertion(tools, p).attempt(start, rule);
}

}  // namespace geomesh::remesh

// SPDX-License-Identifier: MIT
// Declared in operations.hpp.
#include <algorithm>

#include "common/epoch_marks.hpp"
#include "geomesh/core/predicates.hpp"
#include "mesh/cavity.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

Sphere circumsphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const Vec3 vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const Vec3 offset = (0.5 / dot(u, vw)) * (dot(u, u) * vw + dot(v, v) * wu + dot(w, w) * uv);
  return {a + offset, length(offset)};
}

Sphere circumsphere(const DomainMesh& mesh, CellIndex c) {
  const Tetrahedron& t = mesh.vertices(c);
  return circumsphere(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]), mesh.point(t[3]));
}

std::optional<CellIndex> locate(const DomainMesh& mesh, const Vec3& p, CellIndex start) {
  unsigned turn = 0;  // of the order of faces, so that the walk cannot cycle for long
  const auto end = mesh.walk(
      p, start, 1000, [&] { return turn++ & 3u; },
      [&](FaceRef f) { return mesh.tag(f.cell(), f.face()).constrained(); });
  return end.end == DomainMesh::Walk::End::found ? std::optional(end.cell) : std::nullopt;
}

namespace {

/// A constrained Delaunay cavity without anything on surfaces, and its star. A shape criterion in doubles decides which
/// cells to take; what p sees is decided exactly.
class InsideInsertion {
 public:
  InsideInsertion(Toolbox& tools, const Vec3& p, const InsertionRule& rule)
      : mesh_(tools.mesh), work_(tools.work), rule_(rule), p_(p) {}

  /// `home` has p.
  bool find_cavity(CellIndex home) {
    constexpr std::size_t most_cells = 400;
    if (!keeps_spacing(mesh_.vertices(home))) return false;
    const std::array bases{home};
    Cavity cavity(mesh_.topology(), work_.marks, work_.cells, bases);
    const auto may_cross = [&](FaceRef f) { return !mesh_.tag(f.cell(), f.face()).constrained(); };
    cavity.grow(most_cells, may_cross, [&](CellIndex c) { return in_circumsphere(c); });
    collect_border(cavity);
    const auto sees = [&](FaceRef f) { return sees_face(f); };
    if (!std::all_of(border().begin(), border().end(), [&](const StarFace& f) { return sees(f.inner); })) {
      if (!cavity.shrink(
              may_cross, [](FaceRef) { return false; }, sees))
        return false;
      collect_border(cavity);
    }
    return keeps_border_spacing() && swallows_nothing(cavity);
  }

  bool has_shapes() {
    LinkShapes& link = work_.link;
    link.clear(mesh_.measure().kernels());
    for (const StarFace& f : border())
      link.add(mesh_.point(f.vertices[0]), mesh_.point(f.vertices[1]), mesh_.point(f.vertices[2]));
    link.prepare();
    shapes_ = link.shapes(p_);
    return !(rule_.min_shape > 0) || *std::min_element(shapes_.begin(), shapes_.end()) > rule_.min_shape;
  }

  VertexIndex fill() {
    const VertexIndex v = mesh_.add_vertex(p_, VertexKind::inside);
    mesh_.replace_by_star(work_.cells, border(), v, shapes_, work_.created);
    return v;
  }

 private:
  std::vector<StarFace>& border() { return work_.star; }

  bool in_circumsphere(CellIndex c) const {
    const Sphere s = rule_.spheres ? (*rule_.spheres)[c] : circumsphere(mesh_, c);
    return squared_distance(s.centre, p_) < s.radius * s.radius;
  }
  template <class Vertices>
  bool keeps_spacing(const Vertices& vertices) const {
    return std::none_of(vertices.begin(), vertices.end(), [&](VertexIndex v) {
      return squared_distance(mesh_.point(v), p_) < rule_.spacing * rule_.spacing;
    });
  }
  bool sees_face(FaceRef f) const {
    const Tetrahedron& t = mesh_.vertices(f.cell());
    const auto& k = face_vertices[f.face()];
    return is_positive(mesh_.point(t[k[0]]), mesh_.point(t[k[1]]), mesh_.point(t[k[2]]), p_);
  }

  void collect_border(const Cavity& cavity) {
    border().clear();
    for (const CellIndex c : cavity.cells()) {
      const TetMesh::Cell& cell = mesh_.topology().cells()[c];
      for (unsigned i = 0; i < 4; ++i) {
        const FaceRef n = cell.neighbors[i];
        if (n.valid() && cavity.has(n.cell()) && !mesh_.tag(c, i).constrained()) continue;
        const auto& k = face_vertices[i];
        border().push_back({{cell.vertices[k[0]], cell.vertices[k[1]], cell.vertices[k[2]]}, FaceRef(c, i), n});
      }
    }
  }

  bool keeps_border_spacing() {
    return std::all_of(border().begin(), border().end(), [&](const StarFace& f) { return keeps_spacing(f.vertices); });
  }

  /// No vertex, no constrained face and no edge of a curve.
  bool swallows_nothing(const Cavity& cavity) {
    EpochMarks& on_border = work_.vertex_marks;
    on_border.begin(mesh_.n_vertices());
    for (const StarFace& f : border()) {
      if (f.outer.valid() && cavity.has(f.outer.cell())) return false;
      for (const VertexIndex v : f.vertices) on_border.mark(v);
    }
    return std::all_of(cavity.cells().begin(), cavity.cells().end(), [&](CellIndex c) {
      const Tetrahedron& t = mesh_.vertices(c);
      return std::all_of(t.begin(), t.end(), [&](VertexIndex v) { return on_border.marked(v); }) &&
             std::none_of(edge_vertices.begin(), edge_vertices.end(), [&](const auto& e) {
               return mesh_.curve_of(t[e[0]], t[e[1]]) != no_index && !is_on_border(t[e[0]], t[e[1]]);
             });
    });
  }
  bool is_on_border(VertexIndex a, VertexIndex b) {
    return std::any_of(border().begin(), border().end(), [&](const StarFace& f) {
      const auto has = [&](VertexIndex v) {
        return std::find(f.vertices.begin(), f.vertices.end(), v) != f.vertices.end();
      };
      return has(a) && has(b);
    });
  }

  DomainMesh& mesh_;
  Workspace& work_;
  const InsertionRule& rule_;
  Vec3 p_;
  std::span<const double> shapes_;  // of the new cells, by face of the border
};

}  // namespace

std::optional<VertexIndex> insert_inside(Toolbox& tools, const Vec3& p, CellIndex start, const InsertionRule& rule) {
  const std::optional<CellIndex> home = locate(tools.mesh, p, start);
  if (!home) return std::nullopt;
  InsideInsertion insertion(tools, p, rule);
  if (!insertion.find_cavity(*home) || !insertion.has_shapes()) return std::nullopt;
  ++tools.statistics.points_inside;
  return insertion.fill();
}

}  // namespace geomesh::remesh

// SPDX-License-Identifier: MIT
// Declared in operations.hpp.
#include <algorithm>

#include "common/geometry.hpp"
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
  const auto [p, q, r, s] = mesh.places(mesh.vertices(c));
  return circumsphere(p, q, r, s);
}

Vec3 offset_of_circumcentre(const DomainMesh& mesh, const Triangle& t) {
  const Vec3 &a = mesh.point(t[0]), u = mesh.point(t[1]) - a, v = mesh.point(t[2]) - a, n = cross(u, v);
  return (0.5 / dot(n, n)) * (dot(u, u) * cross(v, n) + dot(v, v) * cross(n, u));
}

namespace {

/// Finds the cell that contains p by a walk from `start`. Returns nothing at a constrained face, or after many cells.
std::optional<CellIndex> locate(const DomainMesh& mesh, const Vec3& p, CellIndex start) {
  unsigned turn =
      0;  // The walk to the cell of p varies the order in which it tries faces, so it cannot cycle for long.
  const auto end = mesh.walk(
      p, start, 1000, [&] { return turn++ & 3u; }, [&](FaceRef f) { return mesh.tag(f).constrained(); });
  return end.end == DomainMesh::Walk::End::found ? std::optional(end.cell) : std::nullopt;
}

/// Inserts a point by replacing a constrained Delaunay cavity, which has no part of a surface or curve inside, by the
/// star of the point. Circumspheres in floating point select the cells; visibility is decided exactly.
class InsideInsertion {
 public:
  InsideInsertion(Toolbox& tools, const Vec3& p, const InsertionRule& rule)
      : mesh_(tools.mesh), work_(tools.work), rule_(rule), p_(p) {}

  /// Finds the cavity of p, which is in the cell `home`.
  bool find_cavity(CellIndex home) {
    constexpr std::size_t most_cells = 400;
    if (!keeps_spacing(mesh_.vertices(home))) return false;
    const std::array bases{home};
    Cavity cavity(mesh_.cells(), work_.marks, work_.cells, bases);
    const auto may_cross = [&](FaceRef f) { return !mesh_.tag(f).constrained(); };
    cavity.grow(most_cells, may_cross, [&](CellIndex c) { return in_circumsphere(c); });
    collect_border(cavity);
    if (!std::all_of(border().begin(), border().end(), [&](const StarFace& f) { return mesh_.sees(p_, f.vertices); })) {
      if (!cavity.shrink(
              may_cross, [](FaceRef) { return false; }, [&](FaceRef f) { return mesh_.sees(p_, mesh_.face(f)); }))
        return false;
      collect_border(cavity);
    }
    return std::all_of(border().begin(), border().end(),
                       [&](const StarFace& f) { return keeps_spacing(f.vertices); }) &&
           !swallows_constraint(mesh_, work_, cavity.cells(), border());
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
    const Index component = mesh_.component(work_.cells[0]);
    work_.added.clear();
    for (std::size_t k = 0; k < border().size(); ++k) {
      const Triangle& f = border()[k].vertices;
      work_.added.push_back({{f[0], f[1], f[2], v}, component, {}, shapes_[k]});
    }
    mesh_.replace(work_.cells, work_.added, work_.created);
    return v;
  }

 private:
  std::vector<StarFace>& border() { return work_.star; }

  bool in_circumsphere(CellIndex c) const {
    const Sphere s = circumsphere(mesh_, c);
    return squared_distance(s.centre, p_) < s.radius * s.radius;
  }
  template <class Vertices>
  bool keeps_spacing(const Vertices& vertices) const {
    return std::none_of(vertices.begin(), vertices.end(),
                        [&](VertexIndex v) { return rule_.spacing.exceeds(mesh_.point(v) - p_); });
  }

  void collect_border(const Cavity& cavity) {
    border().clear();
    for (const CellIndex c : cavity.cells()) {
      const TetMesh::Cell& cell = mesh_.cells().cells()[c];
      for (unsigned i = 0; i < 4; ++i) {
        const FaceRef n = cell.neighbors[i];
        if (n.valid() && cavity.has(n.cell()) && !mesh_.tag(c, i).constrained()) continue;
        border().push_back({face_of(cell.vertices, i)});
      }
    }
  }

  DomainMesh& mesh_;
  Workspace& work_;
  const InsertionRule& rule_;
  Vec3 p_;
  std::span<const double> shapes_;  // shapes of the new cells, one for each face of the cavity's border
};

}  // namespace

std::optional<VertexIndex> insert_inside(Toolbox& tools, const Vec3& p, CellIndex start, const InsertionRule& rule) {
  const std::optional<CellIndex> home = locate(tools.mesh, p, start);
  InsideInsertion insertion(tools, p, rule);
  if (!home || !insertion.find_cavity(*home) || !insertion.has_shapes()) return std::nullopt;
  ++tools.statistics.points_inside;
  return insertion.fill();
}

}  // namespace geomesh::remesh

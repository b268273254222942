// SPDX-License-Identifier: MIT
#include "remesh/tolerance/cavity.hpp"

#include <algorithm>

#include "geomesh/core/predicates.hpp"
#include "quality/measure/shape.hpp"

namespace geomesh::remesh {

namespace {

Triangle face_of(const DomainMesh& mesh, CellIndex c, unsigned i) {
  const Tetrahedron& t = mesh.vertices(c);
  return {t[face_vertices[i][0]], t[face_vertices[i][1]], t[face_vertices[i][2]]};
}

/// Face i of c in the orientation of its facet: as seen from above it.
Triangle oriented_face(const DomainMesh& mesh, CellIndex c, unsigned i) {
  Triangle f = face_of(mesh, c, i);
  if (!mesh.tag(c, i).above()) std::swap(f[1], f[2]);
  return f;
}

/// A face with two cells is taken from above only, so that it is taken once.
bool takes_face(const DomainMesh& mesh, CellIndex c, unsigned i) {
  const FaceTag t = mesh.tag(c, i);
  return t.constrained() && (t.above() || !mesh.has_neighbor(c, i));
}

void add_spoke(StarCavity& cavity, const Triangle& f, VertexIndex apex, Index facet) {
  const unsigned k = f[0] == apex ? 0 : f[1] == apex ? 1 : 2;
  cavity.spokes.push_back({f[(k + 1) % 3], f[(k + 2) % 3], facet});
}

/// Curve edges from v to the vertices of its constrained faces and, for a curve in the inside of a region, to any
/// neighbour.
void add_curves(const DomainMesh& mesh, VertexIndex v, StarCavity& cavity) {
  if (mesh.kind(v) > VertexKind::curve) return;
  for (const CellIndex c : cavity.cells)
    for (const VertexIndex x : mesh.vertices(c)) {
      if (x == v) continue;
      const Index curve = mesh.curve_of(v, x);
      if (curve == no_index) continue;
      if (std::none_of(cavity.curves.begin(), cavity.curves.end(), [x](const CurveSpoke& s) { return s.a == x; }))
        cavity.curves.push_back({x, curve});
    }
}

}  // namespace

void gather_star(const DomainMesh& mesh, VertexIndex v, EpochMarks& marks, StarCavity& cavity) {
  cavity.clear();
  mesh.star(v, marks, cavity.cells);
  for (const CellIndex c : cavity.cells) {
    const unsigned k = mesh.topology().index_of(c, v);
    cavity.link.push_back({face_of(mesh, c, k), mesh.component(c)});
    if (mesh.kind(v) == VertexKind::inside) continue;
    for (unsigned i = 0; i < 4; ++i)
      if (i != k && takes_face(mesh, c, i)) add_spoke(cavity, oriented_face(mesh, c, i), v, mesh.tag(c, i).facet());
  }
  add_curves(mesh, v, cavity);
}

bool edge_ring(const DomainMesh& mesh, CellIndex c, VertexIndex a, VertexIndex b, std::vector<CellIndex>& cells,
               std::vector<VertexIndex>& ring) {
  return turn_about_edge(mesh.topology(), c, a, b, cells, ring);
}

EdgeFaces constrained_faces_of_ring(const DomainMesh& mesh, const std::vector<CellIndex>& cells,
                                    const std::vector<VertexIndex>& ring, bool closed) {
  EdgeFaces faces;
  const std::size_t n = cells.size();
  for (std::size_t k = 0; k < ring.size(); ++k) {
    // Face (a, b, ring[k]) is opposite ring[k + 1] in cell k; the last of an open ring is opposite ring[n - 1] in cell
    // n - 1.
    const bool last = !closed && k == n;
    const CellIndex c = last ? cells[n - 1] : cells[k];
    const VertexIndex opposite = last ? ring[n - 1] : ring[(k + 1) % ring.size()];
    const FaceTag t = mesh.tag(c, mesh.topology().index_of(c, opposite));
    if (!t.constrained()) continue;
    if (faces.n < 2) {
      faces.at[faces.n] = k;
      faces.tag[faces.n] = t;
    }
    ++faces.n;
  }
  return faces;
}

void gather_edge(const DomainMesh& mesh, CellIndex c, VertexIndex a, VertexIndex b, StarCavity& cavity) {
  cavity.clear();
  std::vector<VertexIndex> ring;
  edge_ring(mesh, c, a, b, cavity.cells, ring);
  for (const CellIndex k : cavity.cells) {
    const unsigned ia = mesh.topology().index_of(k, a), ib = mesh.topology().index_of(k, b);
    cavity.link.push_back({face_of(mesh, k, ia), mesh.component(k)});
    cavity.link.push_back({face_of(mesh, k, ib), mesh.component(k)});
    for (unsigned i = 0; i < 4; ++i) {
      if (i == ia || i == ib || !takes_face(mesh, k, i)) continue;
      const Triangle f = oriented_face(mesh, k, i);
      const Index facet = mesh.tag(k, i).facet();
      for (const VertexIndex replaced : {a, b}) add_spoke(cavity, f, replaced, facet);
    }
  }
  const Index curve = mesh.curve_of(a, b);
  if (curve != no_index) cavity.curves = {{a, curve}, {b, curve}};
}

void gather_cells(const DomainMesh& mesh, EpochMarks& marks, std::span<const CellIndex> cells, StarCavity& cavity) {
  cavity.clear();
  cavity.cells.assign(cells.begin(), cells.end());
  marks.begin(mesh.n_slots());
  for (const CellIndex c : cells) marks.mark(c);
  for (const CellIndex c : cells)
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef n = mesh.topology().neighbor(c, i);
      if (!n.valid() || !marks.marked(n.cell())) cavity.link.push_back({face_of(mesh, c, i), mesh.component(c)});
    }
}

bool star_is_positive(const DomainMesh& mesh, const StarCavity& cavity, const Vec3& p) {
  return std::all_of(cavity.link.begin(), cavity.link.end(), [&](const LinkFace& f) {
    return is_positive(mesh.point(f.vertices[0]), mesh.point(f.vertices[1]), mesh.point(f.vertices[2]), p);
  });
}

double star_shape(const DomainMesh& mesh, const StarCavity& cavity, const Vec3& p, double enough) {
  double worst = 1;
  for (const LinkFace& f : cavity.link) {
    worst = std::min(worst, mesh.measure().shape(mesh.point(f.vertices[0]), mesh.point(f.vertices[1]),
                                                 mesh.point(f.vertices[2]), p));
    if (worst <= enough) break;
  }
  return worst;
}

double removed_shape(const DomainMesh& mesh, const StarCavity& cavity) {
  double worst = 1;
  for (const CellIndex c : cavity.cells) worst = std::min(worst, mesh.shape_of(c));
  return worst;
}

namespace {

/// shape_of(k): of the cell over face k of the link.
template <class Shape>
bool adds_bad_cells_by(const DomainMesh& mesh, const StarCavity& cavity, const Shape& shape_of) {
  const double bad = mesh.measure().bad();
  std::size_t room = 0;
  for (const CellIndex c : cavity.cells) room += mesh.shape_of(c) < bad;
  for (std::size_t k = 0; k < cavity.link.size(); ++k)
    if (shape_of(k) < bad && room-- == 0) return true;
  return false;
}

}  // namespace

bool adds_bad_cells(const DomainMesh& mesh, const StarCavity& cavity, const Vec3& p) {
  return adds_bad_cells_by(mesh, cavity, [&](std::size_t k) {
    const Triangle& f = cavity.link[k].vertices;
    return mesh.measure().shape(mesh.point(f[0]), mesh.point(f[1]), mesh.point(f[2]), p);
  });
}

bool adds_bad_cells(const DomainMesh& mesh, const StarCavity& cavity, std::span<const double> shapes) {
  return adds_bad_cells_by(mesh, cavity, [&](std::size_t k) { return shapes[k]; });
}

void fill_with_star(DomainMesh& mesh, const StarCavity& cavity, VertexIndex apex, Workspace& work,
                    std::span<const double> shapes) {
  work.added.clear();
  for (std::size_t k = 0; k < cavity.link.size(); ++k) {
    const LinkFace& f = cavity.link[k];
    // face_vertices[3] is (0, 1, 2): the base. The face with the apex and the base's edge (i, i + 1) is opposite vertex
    // i + 2.
    NewCell n{{f.vertices[0], f.vertices[1], f.vertices[2], apex}, f.component, {}};
    if (k < shapes.size()) n.shape = shapes[k];
    for (unsigned i = 0; i < 3 && !cavity.spokes.empty(); ++i) {
      const VertexIndex x = f.vertices[i], y = f.vertices[(i + 1) % 3];
      for (const Spoke& s : cavity.spokes) {
        // (x, y, z, apex) positive: z is below the face (apex, x, y), whose normal points away from it.
        if (s.a == x && s.b == y) n.tags[(i + 2) % 3] = FaceTag(s.facet, false);
        if (s.a == y && s.b == x) n.tags[(i + 2) % 3] = FaceTag(s.facet, true);
      }
    }
    work.added.push_back(n);
  }
  mesh.replace(cavity.cells, work.added, work.created);
}

}  // namespace geomesh::remesh

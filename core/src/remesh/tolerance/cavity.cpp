// SPDX-License-Identifier: MIT
#include "remesh/tolerance/cavity.hpp"

#include <algorithm>

namespace geomesh::remesh {

namespace {

void add_spoke(StarCavity& cavity, const Triangle& f, VertexIndex apex, Index facet) {
  const unsigned k = f[0] == apex ? 0 : f[1] == apex ? 1 : 2;
  cavity.spokes.push_back({f[(k + 1) % 3], f[(k + 2) % 3], facet});
}

/// Adds the edges of curves at v: to vertices of its constrained faces or, for curves in a region, to any neighbour.
void add_curves(const DomainMesh& mesh, VertexIndex v, StarCavity& cavity) {
  if (mesh.kind(v) > VertexKind::curve) return;
  auto& asked = cavity.neighbours_asked;  // neighbours of v that were examined
  for (const CellIndex c : cavity.cells)
    for (const VertexIndex x : mesh.vertices(c)) {
      if (x == v || mesh.kind(x) > VertexKind::curve || std::ranges::find(asked, x) != asked.end()) continue;
      asked.push_back(x);
      if (const Index curve = mesh.curve_of(v, x); curve != no_index) cavity.curves.push_back({x, curve});
    }
}

}  // namespace

void gather_star(const DomainMesh& mesh, VertexIndex v, EpochMarks& marks, StarCavity& cavity) {
  cavity.clear();
  mesh.star(v, marks, cavity.cells);
  for (const CellIndex c : cavity.cells) {
    const unsigned k = mesh.cells().index_of(c, v);
    cavity.link.push_back({mesh.face(c, k), mesh.component(c)});
    if (mesh.kind(v) == VertexKind::inside) continue;
    for (unsigned i = 0; i < 4; ++i)
      if (const FaceRef f(c, i); i != k && mesh.is_surface(f))
        add_spoke(cavity, mesh.facet_face(f), v, mesh.tag(f).facet());
  }
  add_curves(mesh, v, cavity);
}

void drop_vertex(StarCavity& cavity, VertexIndex v) {
  std::erase_if(cavity.link, [&](const LinkFace& f) { return std::ranges::count(f.vertices, v) > 0; });
  std::erase_if(cavity.spokes, [&](const Spoke& s) { return s.a == v || s.b == v; });
  std::erase_if(cavity.curves, [&](const CurveSpoke& s) { return s.a == v; });
}

EdgeFaces constrained_faces_of_ring(const DomainMesh& mesh, const std::vector<CellIndex>& cells,
                                    const std::vector<VertexIndex>& ring, bool closed) {
  EdgeFaces faces;
  const std::size_t n = cells.size();
  for (std::size_t k = 0; k < ring.size(); ++k) {
    // In the ring of cells around the edge (a, b), the face (a, b, ring[k]) is opposite vertex ring[k + 1] of cell k;
    // the last face of an open ring is opposite ring[n - 1] in cell n - 1.
    const bool last = !closed && k == n;
    const CellIndex c = last ? cells[n - 1] : cells[k];
    const VertexIndex opposite = last ? ring[n - 1] : ring[(k + 1) % ring.size()];
    const FaceTag t = mesh.tag(c, mesh.cells().index_of(c, opposite));
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
  turn_about_edge(mesh.cells(), c, a, b, cavity.cells, ring);
  for (const CellIndex k : cavity.cells) {
    const unsigned ia = mesh.cells().index_of(k, a), ib = mesh.cells().index_of(k, b);
    for (const unsigned i : {ia, ib}) cavity.link.push_back({mesh.face(k, i), mesh.component(k)});
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef f(k, i);
      if (i == ia || i == ib || !mesh.is_surface(f)) continue;
      for (const VertexIndex replaced : {a, b}) add_spoke(cavity, mesh.facet_face(f), replaced, mesh.tag(f).facet());
    }
  }
  const Index curve = mesh.curve_of(a, b);
  if (curve != no_index) cavity.curves = {{a, curve}, {b, curve}};
}

void gather_cells(const DomainMesh& mesh, EpochMarks& marks, std::span<const CellIndex> cells, StarCavity& cavity) {
  cavity.clear();
  cavity.cells.assign(cells.begin(), cells.end());
  marks.begin();
  for (const CellIndex c : cells) marks.mark(c);
  for (const CellIndex c : cells)
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef n = mesh.cells().neighbor(c, i);
      if (!n.valid() || !marks.marked(n.cell())) cavity.link.push_back({mesh.face(c, i), mesh.component(c)});
    }
}

bool star_is_positive(const DomainMesh& mesh, const StarCavity& cavity, const Vec3& p) {
  return std::all_of(cavity.link.begin(), cavity.link.end(),
                     [&](const LinkFace& f) { return mesh.sees(p, f.vertices); });
}

double star_shape(const DomainMesh& mesh, const StarCavity& cavity, const Vec3& p, double enough) {
  double worst = 1;
  for (const LinkFace& f : cavity.link) {
    worst = std::min(worst, mesh.shape(f.vertices, p));
    if (worst <= enough) break;
  }
  return worst;
}

double removed_shape(const DomainMesh& mesh, const StarCavity& cavity) {
  double worst = 1;
  for (const CellIndex c : cavity.cells) worst = std::min(worst, mesh.shape_of(c));
  return worst;
}

bool adds_bad_cells(const DomainMesh& mesh, const StarCavity& cavity, std::span<const double> shapes) {
  const double bad = mesh.measure().bad();
  std::size_t room = 0;
  for (const CellIndex c : cavity.cells) room += mesh.shape_of(c) < bad;
  shapes = shapes.first(cavity.link.size());
  return std::any_of(shapes.begin(), shapes.end(), [&](double shape) { return shape < bad && room-- == 0; });
}

bool adds_bad_cells(const DomainMesh& mesh, const StarCavity& cavity, const Vec3& p) {
  std::vector<double> shapes;
  for (const LinkFace& f : cavity.link) shapes.push_back(mesh.shape(f.vertices, p));
  return adds_bad_cells(mesh, cavity, shapes);
}

void fill_with_star(DomainMesh& mesh, const StarCavity& cavity, VertexIndex apex, Workspace& work,
                    std::span<const double> shapes) {
  work.added.clear();
  for (std::size_t k = 0; k < cavity.link.size(); ++k) {
    const LinkFace& f = cavity.link[k];
    // The link face is the base of the new cell (vertices 0, 1, 2), the apex its vertex 3. The face with the apex and
    // the edge (i, i + 1) of the base is opposite vertex i + 2 of the base.
    NewCell n{{f.vertices[0], f.vertices[1], f.vertices[2], apex}, f.component, {}};
    if (k < shapes.size()) n.shape = shapes[k];
    for (unsigned i = 0; i < 3 && !cavity.spokes.empty(); ++i) {
      const VertexIndex x = f.vertices[i], y = f.vertices[(i + 1) % 3];
      for (const Spoke& s : cavity.spokes) {
        // Seen from vertex z of the positive cell (x, y, z, apex), face (apex, x, y) is clockwise: z is below it.
        if (s.a == x && s.b == y) n.tags[(i + 2) % 3] = FaceTag(s.facet, false);
        if (s.a == y && s.b == x) n.tags[(i + 2) % 3] = FaceTag(s.facet, true);
      }
    }
    work.added.push_back(n);
  }
  mesh.replace(cavity.cells, work.added, work.created);
}

}  // namespace geomesh::remesh

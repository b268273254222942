// SPDX-License-Identifier: MIT
#include "geomesh/core/locate.hpp"

#include "geomesh/core/predicates.hpp"

namespace geomesh {
namespace {

Sign side_of_face(const TetMesh& mesh, std::span<const Vec3> points, CellIndex c, unsigned face, const Vec3& p) {
  const auto& v = mesh.vertices(c);
  const auto& f = face_vertices[face];
  return orient3d(points[v[f[0]]], points[v[f[1]]], points[v[f[2]]], p);
}

/// From the faces of a finite cell whose planes hold p, none having p beyond it.
Location classify(CellIndex c, unsigned zero_faces) {
  Location at{LocationKind::inside_cell, c, 0, 0};
  unsigned off[4];  // vertices opposite the faces that do not hold p
  unsigned n_off = 0;
  for (unsigned i = 0; i < 4; ++i)
    if (!(zero_faces >> i & 1u)) off[n_off++] = i;
  switch (n_off) {
    case 4:
      return at;
    case 3:
      at.kind = LocationKind::on_face;
      for (unsigned i = 0; i < 4; ++i)
        if (zero_faces >> i & 1u) at.i = i;
      return at;
    case 2:
      at.kind = LocationKind::on_edge;
      at.i = off[0];
      at.j = off[1];
      return at;
    default:
      at.kind = LocationKind::at_vertex;
      at.i = off[0];
      return at;
  }
}

}  // namespace

Location locate(const TetMesh& mesh, std::span<const Vec3> points, const Vec3& p, CellIndex hint, WalkRandom& random,
                std::size_t* steps) {
  CellIndex c = hint;
  CellIndex previous = no_cell;
  if (const int g = mesh.ghost_index(c); g >= 0) c = mesh.neighbor_cell(c, static_cast<unsigned>(g));
  for (;;) {
    if (steps) ++*steps;
    if (mesh.is_ghost(c)) return {LocationKind::outside_hull, c, 0, 0};
    const unsigned first = random.next() & 3u;
    unsigned zero_faces = 0;
    CellIndex next = no_cell;
    for (unsigned k = 0; k < 4 && next == no_cell; ++k) {
      const unsigned i = (first + k) & 3u;
      const CellIndex neighbor = mesh.neighbor_cell(c, i);
      if (neighbor == previous) continue;
      const Sign side = side_of_face(mesh, points, c, i, p);
      if (side == Sign::negative) next = neighbor;
      if (side == Sign::zero) zero_faces |= 1u << i;
    }
    if (next == no_cell) return classify(c, zero_faces);
    previous = c;
    c = next;
  }
}

}  // namespace geomesh

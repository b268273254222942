// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/names/small_parts.hpp"

#include <algorithm>

#include "check/exact/exact.hpp"
#include "common/union_find.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Cells joined across faces of one region that are no candidates.
UnionFind parts_of(const ClaimedFaces& claimed) {
  const JudgedMesh& mesh = claimed.mesh();
  std::vector<Triangle> walls;
  for (const Triangle& t : claimed.candidates()) walls.push_back(sorted(t));
  std::sort(walls.begin(), walls.end());
  UnionFind parts(mesh.cells.size());
  for (const FacePair& face : mesh.faces)
    if (is_inner(face) && mesh.file.region[face.even] == mesh.file.region[face.odd] &&
        !std::binary_search(walls.begin(), walls.end(), face.key))
      parts.unite(face.even, face.odd);
  return parts;
}

}  // namespace

std::vector<bool> faces_of_small_parts(const ClaimedFaces& claimed) {
  std::vector<bool> small(claimed.candidates().size(), false);
  const ClaimedNames& names = claimed.claim().names;
  if (!names.merges_small || !(names.min_volume > 0)) return small;
  const JudgedMesh& mesh = claimed.mesh();
  UnionFind parts = parts_of(claimed);
  std::vector<double> volume(mesh.cells.size(), 0);  // of the part that the cell stands for
  for (Index c = 0; c < mesh.cells.size(); ++c) {
    const Tetrahedron& v = mesh.cells[c];
    volume[parts.find(c)] += six_volumes(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3])) / 6;
  }
  const FacesFile& faces = *claimed.faces();
  for (Index f = 0; f < small.size(); ++f) {
    if (faces.region_minus[f] != faces.region_plus[f]) continue;
    const FacePair* const face = find_face(mesh, sorted(claimed.candidates()[f]));
    if (!face || !is_inner(*face)) continue;
    const Index even = parts.find(face->even), odd = parts.find(face->odd);
    small[f] = even != odd && std::min(volume[even], volume[odd]) < names.min_volume;
  }
  return small;
}

}  // namespace geomesh::geomodel::checking

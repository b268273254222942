// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/names/small_parts.hpp"

#include <algorithm>
#include <map>

#include "check/exact/exact.hpp"
#include "common/union_find.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Groups mesh cells into parts, joined across faces that lie inside one region and on no surface.
UnionFind parts_of(const CheckedFaces& checked) {
  const CheckedMesh& mesh = checked.mesh();
  std::vector<Triangle> walls;
  for (const Triangle& t : checked.candidates()) walls.push_back(sorted(t));
  std::sort(walls.begin(), walls.end());
  UnionFind parts(mesh.cells.size());
  for (const FacePair& face : mesh.faces)
    if (is_inner(face) && mesh.file.region[face.even] == mesh.file.region[face.odd] &&
        !std::binary_search(walls.begin(), walls.end(), face.key))
      parts.unite(face.even, face.odd);
  return parts;
}

/// Returns for each mesh cell whether it belongs to a small part of its region.
std::vector<bool> cells_of_small_parts(const CheckedFaces& checked, double min_volume) {
  const CheckedMesh& mesh = checked.mesh();
  UnionFind parts = parts_of(checked);
  std::vector<double> volume(mesh.cells.size(), 0);  // volume of connected parts of regions, by representative cell
  for (Index c = 0; c < mesh.cells.size(); ++c) {
    const Tetrahedron& v = mesh.cells[c];
    volume[parts.find(c)] += six_volumes(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3])) / 6;
  }
  std::map<std::int32_t, double> largest;  // by region
  for (Index c = 0; c < mesh.cells.size(); ++c) {
    double& most = largest[mesh.file.region[c]];
    most = std::max(most, volume[c]);
  }
  std::vector<bool> small(mesh.cells.size());
  for (Index c = 0; c < mesh.cells.size(); ++c) {
    const double own = volume[parts.find(c)];
    small[c] = own < min_volume && own < largest[mesh.file.region[c]];
  }
  return small;
}

}  // namespace

std::vector<SmallSides> sides_in_small_parts(const CheckedFaces& checked) {
  std::vector<SmallSides> sides(checked.candidates().size());
  const SpecifiedNames& names = checked.specification().names;
  if (!names.merges_small || !(names.min_volume > 0)) return sides;
  const CheckedMesh& mesh = checked.mesh();
  const std::vector<bool> small = cells_of_small_parts(checked, names.min_volume);
  const FacesFile& faces = *checked.faces();
  for (Index f = 0; f < sides.size(); ++f) {
    const FacePair* const face = find_face(mesh, sorted(checked.candidates()[f]));
    if (!face || !is_inner(*face)) continue;
    const auto is_small_in = [&](std::int32_t region) {
      return (mesh.file.region[face->even] == region && small[face->even]) ||
             (mesh.file.region[face->odd] == region && small[face->odd]);
    };
    sides[f] = {is_small_in(faces.region_minus[f]), is_small_in(faces.region_plus[f])};
  }
  return sides;
}

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs the faces of neighbouring tetrahedra, declared in `check/mesh/checked_mesh.hpp`.
#include <algorithm>
#include <tuple>
#include <utility>

#include "check/mesh/checked_mesh.hpp"
#include "check/mesh/faults.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// A face of one tetrahedron; inner faces of the mesh occur twice, once for each side.
struct HalfFace {
  Triangle key;
  Index cell;
  bool odd;
};

std::vector<HalfFace> sorted_half_faces(const CheckedMesh& mesh) {
  std::vector<HalfFace> halves;
  halves.reserve(4 * mesh.cells.size());
  for (Index cell = 0; cell < mesh.cells.size(); ++cell)
    for (const auto& f : outward_face) {
      const Tetrahedron& v = mesh.cells[cell];
      const Triangle outward{v[f[0]], v[f[1]], v[f[2]]};
      halves.push_back({sorted(outward), cell, is_odd(outward)});
    }
  std::sort(halves.begin(), halves.end(),
            [](const HalfFace& a, const HalfFace& b) { return std::tie(a.key, a.cell) < std::tie(b.key, b.cell); });
  return halves;
}

}  // namespace

bool is_odd(const Triangle& t) { return ((t[0] > t[1]) + (t[0] > t[2]) + (t[1] > t[2])) % 2 != 0; }

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

const FacePair* find_face(const CheckedMesh& mesh, const Triangle& t) {
  const Triangle key = sorted(t);
  const auto it = std::lower_bound(mesh.faces.begin(), mesh.faces.end(), key,
                                   [](const FacePair& face, const Triangle& wanted) { return face.key < wanted; });
  return it != mesh.faces.end() && it->key == key ? &*it : nullptr;
}

void check_faces(CheckedMesh& mesh, CheckResult& result) {
  FaultCollector crowded("faces_shared_by_many"), same_side("faces_shared_from_one_side");
  const std::vector<HalfFace> halves = sorted_half_faces(mesh);
  for (std::size_t i = 0, j = 0; i < halves.size(); i = j) {
    FacePair face{halves[i].key};
    for (j = i; j < halves.size() && halves[j].key == halves[i].key; ++j)
      (halves[j].odd ? face.odd : face.even) = halves[j].cell;
    if (j - i > 2) {
      crowded.add(mesh.file.cell[halves[i].cell], centroid(mesh, face.key));
    } else if (j - i == 2 && !is_inner(face)) {
      same_side.add(mesh.file.cell[halves[i].cell], centroid(mesh, face.key));
    }
    mesh.faces.push_back(face);
  }
  mesh.sound = mesh.sound && crowded.count() == 0 && same_side.count() == 0;
  crowded.report(result, "faces are shared by more than two tetrahedra");
  same_side.report(result, "faces have both tetrahedra on one side: they overlap");
  result.checks_done.emplace_back("each face is shared by at most two tetrahedra, from opposite sides");
}

}  // namespace geomesh::geomodel::checking

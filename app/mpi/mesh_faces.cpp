// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_faces.hpp"

#include <algorithm>

#include "geomesh/core/error.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh::app {

namespace {

Triangle face_of(const RankMesh& mesh, Index code) { return face_at(mesh.tetrahedra[code / 4], code % 4); }

/// Returns whether the corners in ascending order have the orientation of the triangle.
bool is_even(const Triangle& t, const Corners& s) {
  for (unsigned i = 0; i < 3; ++i)
    if (t[i] == s[0]) return t[(i + 1) % 3] == s[1];
  return false;
}

}  // namespace

MeshFaces::MeshFaces(const RankMesh& mesh, Which which) {
  if (mesh.tetrahedra.size() >= no_index / 4) throw InternalError("a part has more tetrahedra than can be counted");
  std::vector<Use> uses;
  const bool takes_all = which == Which::all || mesh.may_be_outside.empty();
  if (takes_all) uses.reserve(4 * mesh.tetrahedra.size());
  const auto is_taken = [&](const Triangle& t) {
    return takes_all || (mesh.may_be_outside[t[0]] && mesh.may_be_outside[t[1]] && mesh.may_be_outside[t[2]]);
  };
  for (Index code = 0; code < 4 * mesh.tetrahedra.size(); ++code) {
    const Triangle t = face_of(mesh, code);
    if (!is_taken(t)) continue;
    const Corners c = sorted_corners(t);
    uses.push_back({std::uint64_t{c[0]} << 32 | c[1], c[2], code});
  }
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
    if (a.low != b.low) return a.low < b.low;
    return a.high != b.high ? a.high < b.high : a.code < b.code;
  });
  const auto is_same = [](const Use& a, const Use& b) { return a.low == b.low && a.high == b.high; };
  std::size_t n_inner = 0;
  for (std::size_t i = 0; i < uses.size();) {
    const bool is_inner = i + 1 < uses.size() && is_same(uses[i], uses[i + 1]);
    if (!is_inner) {
      const Index code = uses[i].code;
      open.push_back({code / 4, code % 4, face_of(mesh, code)});
      ++i;
      continue;
    }
    const Corners c = uses[i].corners();
    if (i + 2 < uses.size() && is_same(uses[i], uses[i + 2])) throw InternalError("a face has three tetrahedra");
    if (is_even(face_of(mesh, uses[i].code), c) == is_even(face_of(mesh, uses[i + 1].code), c))
      throw InternalError("a face has two tetrahedra on one side");
    Use use = uses[i];
    use.other = uses[i + 1].cell();
    uses[n_inner++] = use;
    i += 2;
  }
  uses.resize(n_inner);
  uses_ = std::move(uses);
  std::sort(open.begin(), open.end(), [](const OpenFace& a, const OpenFace& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.opposite < b.opposite;
  });
}

std::vector<VertexIndex> MeshFaces::open_corners() const {
  std::vector<VertexIndex> rows;
  for (const OpenFace& f : open) rows.insert(rows.end(), f.vertices.begin(), f.vertices.end());
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

}  // namespace geomesh::app

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The mesh under judgement with its faces paired, and the checks, one function a property. Every check appends to
/// `result`.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "check/claim/claim.hpp"
#include "geomesh/geomodel/check.hpp"
#include "mesh_readers/mesh_files.hpp"

namespace geomesh::geomodel::checking {

/// Face i of a positive tetrahedron is opposite vertex i; listed counter-clockwise as seen from outside.
inline constexpr std::array<std::array<int, 3>, 4> outward_face{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// A mesh face once, with the tetrahedra at it. `key` is sorted; `even` is the tetrahedron for which the sorted order
/// is counter-clockwise from outside, `odd` the one on the other side. The normal of `key` points out of `even`.
/// no_index: none.
struct FacePair {
  Triangle key;
  Index even = no_index, odd = no_index;
};

struct JudgedMesh {
  const MeshFile& file;
  std::vector<Tetrahedron> cells;  ///< as in the file, inverted ones turned round so that faces can still be paired
  std::vector<FacePair> faces;     ///< sorted by key
  bool sound = true;               ///< cells positive and faces paired: what follows may rely on it

  const Vec3& point(VertexIndex v) const { return file.points[v]; }
  std::size_t n_points() const { return file.points.size(); }
};

/// What a check says of where it looked.
Vec3 centroid(const JudgedMesh& mesh, const Tetrahedron& cell);
Vec3 centroid(const JudgedMesh& mesh, const Triangle& face);

bool is_finite(const Vec3& p);
/// True for an odd number of exchanges between `t` and its sorted order.
bool is_odd(const Triangle& t);
Triangle sorted(Triangle t);
/// The face in outward orientation of its even (odd) tetrahedron.
inline Triangle outward_of_even(const FacePair& f) { return f.key; }
inline Triangle outward_of_odd(const FacePair& f) { return {f.key[0], f.key[2], f.key[1]}; }
inline bool is_boundary(const FacePair& f) { return (f.even == no_index) != (f.odd == no_index); }
inline bool is_inner(const FacePair& f) { return f.even != no_index && f.odd != no_index; }
/// nullptr where there is no such face.
const FacePair* find_face(const JudgedMesh& mesh, const Triangle& t);

/// Coordinates finite; only tetrahedra; positive (exactly); points used and distinct. False where nothing further can
/// be judged.
bool check_cells(JudgedMesh& mesh, CheckResult& result);
/// Pairs the faces: each shared by at most two tetrahedra, from opposite sides.
void check_faces(JudgedMesh& mesh, CheckResult& result);
/// The boundary is closed and embedded, and winds about the tetrahedra once: no two tetrahedra overlap anywhere, no
/// face hangs.
void check_boundary(const JudgedMesh& mesh, CheckResult& result);
/// Point arrays of the output contract: there, and input vertices first.
void check_point_arrays(const JudgedMesh& mesh, CheckResult& result);
/// Region ids, names, exact volumes.
void check_regions(const JudgedMesh& mesh, bool contract, CheckResult& result);
/// Elements of second order: one node an edge, shared by all cells there (`wrong_midpoints`); every Bezier coefficient
/// of every Jacobian positive (`jacobian_not_positive`), decided exactly.
void check_second_order(const JudgedMesh& mesh, CheckResult& result);
/// No vertex strictly inside the circumsphere of a tetrahedron across a face.
void check_delaunay(const JudgedMesh& mesh, const FacesFile* faces, CheckResult& result);

/// Rows of faces-file points in the mesh, no_vertex where a point is not there.
std::vector<VertexIndex> match_points(const JudgedMesh& mesh, const std::vector<Vec3>& points);
/// The face set against the mesh (docs/output-files.md). Returns its triangles in mesh vertices, no_vertex where
/// unknown.
std::vector<Triangle> check_face_set(const JudgedMesh& mesh, const FacesFile& faces, CheckResult& result);

/// The volume filled (box: 1e-12 relative; others: and two ulps of the largest coordinate over its sides), every point
/// inside it.
void check_volume(const JudgedMesh& mesh, const Claim& claim, CheckResult& result);
/// Every input triangle, less what lies outside the box or inside a body that cuts, is covered by mesh faces; faces lie
/// on the triangle they name; none of a horizon or fault is inside a body that cuts. `set_faces`: from check_face_set,
/// or empty without a faces file.
void check_coverage(const JudgedMesh& mesh, const Claim& claim, const FacesFile* faces,
                    const std::vector<Triangle>& set_faces, double tolerance, CheckResult& result);

}  // namespace geomesh::geomodel::checking

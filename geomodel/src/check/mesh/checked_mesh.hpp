// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The mesh to be checked, with paired faces, and the checks of each property, which append failures to `result`.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "check/specification/specification.hpp"
#include "geomesh/geomodel/check.hpp"
#include "mesh_readers/mesh_files.hpp"

namespace geomesh::geomodel::checking {

/// Corners of a positive tetrahedron's faces. Face i is opposite vertex i, counter-clockwise as seen from outside.
inline constexpr std::array<std::array<int, 3>, 4> outward_face{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// A mesh face with the tetrahedra on its two sides. `key` holds its sorted vertices; `even` is the tetrahedron for
/// which the sorted order is counter-clockwise from outside, `odd` is the tetrahedron on the other side. The normal of
/// `key` points out of `even`. A side without tetrahedron has no_index.
struct FacePair {
  Triangle key;
  Index even = no_index, odd = no_index;
};

struct CheckedMesh {
  const MeshFile& file;
  /// Tetrahedra of the file, with inverted ones flipped so that faces can still be paired.
  std::vector<Tetrahedron> cells;
  std::vector<FacePair> faces;  ///< sorted by key
  bool sound = true;  ///< Whether all cells are positive and all faces could be paired, as later checks require.

  const Vec3& point(VertexIndex v) const { return file.points[v]; }
  std::size_t n_points() const { return file.points.size(); }
};

/// Returns the centroid of a cell or face, which checks report as its position.
Vec3 centroid(const CheckedMesh& mesh, const Tetrahedron& cell);
Vec3 centroid(const CheckedMesh& mesh, const Triangle& face);

bool is_finite(const Vec3& p);
/// Returns true if sorting the corners of `t` takes an odd number of exchanges.
bool is_odd(const Triangle& t);
Triangle sorted(Triangle t);
/// Returns the corners of the face in the order in which its normal points out of its tetrahedron `even` (`odd`).
inline Triangle outward_of_even(const FacePair& f) { return f.key; }
inline Triangle outward_of_odd(const FacePair& f) { return {f.key[0], f.key[2], f.key[1]}; }
inline bool is_boundary(const FacePair& f) { return (f.even == no_index) != (f.odd == no_index); }
inline bool is_inner(const FacePair& f) { return f.even != no_index && f.odd != no_index; }
const FacePair* find_face(const CheckedMesh& mesh, const Triangle& t);

/// Checks that coordinates are finite, that all cells are tetrahedra and (exactly) positive, and that all points are
/// used and distinct. Returns false if nothing further can be checked.
bool check_cells(CheckedMesh& mesh, CheckResult& result);
/// Pairs the faces, and checks that each is shared by at most two tetrahedra on opposite sides.
void check_faces(CheckedMesh& mesh, CheckResult& result);
/// Checks that the boundary is closed and embedded, and winds around the tetrahedra once: no two tetrahedra overlap
/// anywhere, and no face is hanging.
void check_boundary(const CheckedMesh& mesh, CheckResult& result);
/// Checks that the mesh has the point arrays of docs/output-files.md, and that input vertices come first.
void check_point_arrays(const CheckedMesh& mesh, CheckResult& result);
/// Checks region ids, names and exact volumes.
void check_regions(const CheckedMesh& mesh, bool contract, CheckResult& result);
/// Checks second-order elements: each edge has one node, shared by all of its cells (`wrong_midpoints`), and every
/// Bezier coefficient of every Jacobian is positive (`jacobian_not_positive`), decided exactly.
void check_second_order(const CheckedMesh& mesh, CheckResult& result);
/// Checks the Delaunay property: no vertex lies strictly inside the circumsphere of a tetrahedron with which its own
/// tetrahedron shares a face. Violations across constrained faces are reported separately.
void check_delaunay(const CheckedMesh& mesh, const FacesFile* faces, CheckResult& result);

/// Returns the mesh vertices that equal the points of the faces file; no_vertex for points that are not in the mesh.
std::vector<VertexIndex> match_points(const CheckedMesh& mesh, const std::vector<Vec3>& points);
/// Checks the faces file (docs/output-files.md) against the mesh. Returns the file's triangles by their mesh vertices,
/// with no_vertex for points that are not in the mesh.
std::vector<Triangle> check_face_set(const CheckedMesh& mesh, const FacesFile& faces, CheckResult& result);

/// Checks that the mesh fills the volume and that every point is inside it. For a box, the volumes may differ by 1e-12
/// relatively; for other shapes, additionally by the area of the sides times 40 ulps of the largest coordinate.
void check_volume(const CheckedMesh& mesh, const Specification& specification, CheckResult& result);
/// Checks that every input triangle, minus its parts outside the box or inside a body that cuts, is covered by mesh
/// faces; that faces lie on the triangle they name; and that no face of a horizon or fault is inside a body that cuts.
/// `set_faces` comes from check_face_set and is empty without a faces file.
void check_coverage(const CheckedMesh& mesh, const Specification& specification, const FacesFile* faces,
                    const std::vector<Triangle>& set_faces, double tolerance, CheckResult& result);

}  // namespace geomesh::geomodel::checking

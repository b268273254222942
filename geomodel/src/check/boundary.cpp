// SPDX-License-Identifier: GPL-3.0-or-later
// Proves that no tetrahedra overlap anywhere. Let tetrahedra be positive and their faces pair up from opposite sides.
// Then the number of tetrahedra over a point equals the winding number of the boundary about it. So it is enough that
// the boundary is closed and embedded (its faces meet in shared vertices and edges only: a hanging face is caught here,
// as two boundary faces that overlap) and that the winding number just outside each connected sheet is zero.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "check/exact/box_tree.hpp"
#include "check/exact/crossing.hpp"
#include "check/mesh/checked_mesh.hpp"
#include "check/mesh/faults.hpp"

namespace geomesh::geomodel::checking {
namespace {

std::vector<Triangle> outward_boundary(const CheckedMesh& mesh) {
  std::vector<Triangle> faces;
  for (const FacePair& face : mesh.faces)
    if (is_boundary(face)) faces.push_back(face.even != no_index ? outward_of_even(face) : outward_of_odd(face));
  return faces;
}

/// A directed edge of a boundary face: its sorted ends, and whether the face traverses it from the lower to the higher.
struct HalfEdge {
  VertexIndex a, b;
  Index face;
  bool forward;
};

std::vector<HalfEdge> sorted_half_edges(const std::vector<Triangle>& faces) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * faces.size());
  for (Index f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const VertexIndex a = faces[f][i], b = faces[f][(i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), f, a < b});
    }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& x, const HalfEdge& y) {
    return std::tie(x.a, x.b, x.face) < std::tie(y.a, y.b, y.face);
  });
  return edges;
}

/// Groups boundary faces into connected sheets: faces are joined across edges with exactly two faces. Reports edges
/// whose faces do not cancel in orientation.
std::vector<Index> sheets_of(const CheckedMesh& mesh, const std::vector<Triangle>& faces, CheckResult& result) {
  std::vector<Index> root(faces.size());
  std::iota(root.begin(), root.end(), Index{0});
  const auto find = [&](Index f) {
    while (root[f] != f) f = root[f] = root[root[f]];
    return f;
  };
  FaultCollector open("open_boundary");
  const std::vector<HalfEdge> edges = sorted_half_edges(faces);
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    int sum = 0;
    for (j = i; j < edges.size() && edges[j].a == edges[i].a && edges[j].b == edges[i].b; ++j)
      sum += edges[j].forward ? 1 : -1;
    if (sum != 0) open.add(edges[i].a, mesh.point(edges[i].a));
    if (j - i != 2) continue;
    const Index a = find(edges[i].face), b = find(edges[i + 1].face);
    root[std::max(a, b)] = std::min(a, b);
  }
  open.report(result, "edges of the boundary are not closed: its faces do not cancel there");
  for (Index f = 0; f < faces.size(); ++f) root[f] = find(f);
  return root;
}

BoxTree tree_over(const CheckedMesh& mesh, const std::vector<Triangle>& faces) {
  std::vector<Box3> boxes;
  for (const Triangle& t : faces) boxes.push_back(box_of(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2])));
  return BoxTree(std::move(boxes));
}

/// Returns false if boundary faces meet anywhere but in shared vertices and edges.
bool check_embedded(const CheckedMesh& mesh, const std::vector<Triangle>& faces, const BoxTree& tree,
                    CheckResult& result) {
  FaultCollector hanging("hanging_faces"), crossing("boundary_crossings");
  for (Index f = 0; f < faces.size(); ++f) {
    const Triangle& t = faces[f];
    tree.query(box_of(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2])), [&](Index g) {
      if (g <= f) return;
      switch (meeting(mesh.file.points, t, faces[g])) {
        case Meeting::proper:
          break;
        case Meeting::overlap:
          hanging.add(f, centroid(mesh, t));
          break;
        case Meeting::crossing:
          crossing.add(f, centroid(mesh, t));
          break;
      }
    });
  }
  const bool embedded = hanging.count() + crossing.count() == 0;
  hanging.report(result,
                 "pairs of boundary faces coincide in part: hanging faces (a tetrahedron whose neighbours "
                 "have its face in "
                 "pieces), or tetrahedra that overlap");
  crossing.report(
      result,
      "pairs of boundary faces meet outside shared vertices and edges: tetrahedra overlap, or touch without sharing "
      "(a hanging point)");
  return embedded;
}

void check_winding(const CheckedMesh& mesh, const std::vector<Triangle>& faces, const std::vector<Index>& sheet,
                   const BoxTree& tree, CheckResult& result) {
  FaultCollector overlapping("overlapping_tetrahedra");
  for (Index f = 0; f < faces.size(); ++f) {
    if (sheet[f] != f) continue;
    const int outside = winding_outside(mesh.file.points, faces, f, tree);
    if (outside != 0) overlapping.add(f, centroid(mesh, faces[f]));
  }
  overlapping.report(result, "sheets of the boundary lie inside the mesh: tetrahedra overlap");
}

}  // namespace

void check_boundary(const CheckedMesh& mesh, CheckResult& result) {
  const std::vector<Triangle> faces = outward_boundary(mesh);
  const std::vector<Index> sheet = sheets_of(mesh, faces, result);
  const BoxTree tree = tree_over(mesh, faces);
  const bool embedded = check_embedded(mesh, faces, tree, result);
  if (embedded && mesh.sound) check_winding(mesh, faces, sheet, tree, result);
  result.checks_done.emplace_back(
      "the boundary is closed, its faces meet in shared vertices and edges only, and it winds once: nothing overlaps "
      "(exact)");
  if (!embedded || !mesh.sound)
    result.checks_done.back() =
        "the boundary was checked face by face; overlap as a whole was not, for the faults above";
}

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the patch numbers of mesh faces, declared in check/arrays/check_arrays.hpp.
#include <algorithm>
#include <numeric>

#include "check/arrays/check_arrays.hpp"
#include "check/mesh/faults.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Returns a union-find root for each face. Faces are joined across edges with exactly two faces of the same surfaces.
std::vector<Index> joined_faces(const CheckedFaces& checked) {
  std::map<MeshEdge, std::vector<Index>> edges;
  const auto& triangles = checked.candidates();
  for (Index f = 0; f < triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexIndex a = triangles[f][i], b = triangles[f][(i + 1) % 3];
      edges[{std::min(a, b), std::max(a, b)}].push_back(f);
    }
  std::vector<Index> root(triangles.size());
  std::iota(root.begin(), root.end(), Index{0});
  const auto find = [&](Index f) {
    while (root[f] != f) f = root[f] = root[root[f]];
    return f;
  };
  for (const auto& [edge, at] : edges)
    if (at.size() == 2 && checked.set_of(at[0]) == checked.set_of(at[1])) {
      const Index a = find(at[0]), b = find(at[1]);
      root[std::max(a, b)] = std::min(a, b);
    }
  for (Index f = 0; f < root.size(); ++f) root[f] = find(f);
  return root;
}

}  // namespace

void check_patches(const CheckedFaces& checked, CheckResult& result) {
  const FacesFile& faces = *checked.faces();
  const std::vector<Index> root = joined_faces(checked);
  // If the model ends at a topography or base, faces beyond it were removed. They may have connected two parts of a
  // patch.
  const bool parts_may_be_joined_outside = checked.specification().ends_inside || !checked.specification().volume;
  std::map<Index, std::int32_t> patch_of_root;
  std::map<std::int32_t, Index> root_of_patch;
  FaultCollector wrong("wrong_patches");
  for (Index f = 0; f < root.size(); ++f) {
    const bool is_one = patch_of_root.try_emplace(root[f], faces.patch[f]).first->second == faces.patch[f];
    const Index first = root_of_patch.try_emplace(faces.patch[f], root[f]).first->second;
    const bool is_alone =
        first == root[f] || (parts_may_be_joined_outside && checked.set_of(first) == checked.set_of(f));
    if (!is_one || !is_alone) wrong.add(f, checked.corner(checked.candidates()[f], 0));
  }
  wrong.report(
      result,
      "faces bear a patch number that other faces, not joined with them, bear, or that their neighbours do not");
  result.checks_done.emplace_back("patches are the faces joined across edges where just two faces of one set meet");
}

}  // namespace geomesh::geomodel::checking

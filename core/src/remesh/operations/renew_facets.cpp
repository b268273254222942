// SPDX-License-Identifier: MIT
// Assigns to each face of a surface the facet in which it lies. Declared in remesh/operations/surface_repair.hpp.
#include <algorithm>

#include "common/geometry.hpp"
#include "remesh/operations/surface_repair.hpp"

namespace geomesh::remesh {

namespace {

/// Facets by patch.
struct Members {
  explicit Members(const DomainMesh& mesh, std::size_t n_facets) : of_patch(mesh.n_patches()) {
    for (Index f = 0; f < n_facets; ++f) of_patch[mesh.patch_of_facet(f)].push_back(f);
  }
  /// Finds the facet of the patch nearest to p. Facets that share a patch in exact mode are triangles.
  Index nearest(const PiecewiseLinearComplex& plc, Index patch, const Vec3& p) const {
    const std::vector<Index>& facets = of_patch[patch];
    if (facets.size() == 1) return facets[0];
    return std::ranges::min(facets, {}, [&](Index f) {
      const auto t = plc.outer_loop(f);
      return squared_distance(p, search::closest_on_triangle(p, plc.points[t[0]], plc.points[t[1]], plc.points[t[2]]));
    });
  }
  std::vector<std::vector<Index>> of_patch;
};

}  // namespace

void renew_facets(DomainMesh& mesh, const SurfaceGuard& guard, const PiecewiseLinearComplex& plc) {
  const Members members(mesh, guard.exact() ? plc.n_facets() : 0);
  mesh.for_each_facet_face([&](FaceRef f) {
    const FaceTag t = mesh.tag(f);
    const Vec3 middle = mesh.middle(mesh.face(f));
    const Index patch = mesh.patch_of(t),
                facet = guard.exact() ? members.nearest(plc, patch, middle) : guard.nearest_facet(patch, middle);
    if (facet == t.facet()) return;
    // In exact mode the new facet is oriented like the old one. Otherwise the cell is above the facet if the normal of
    // the face, which points into the cell, is at an acute angle to the normal of the facet.
    const bool above =
        guard.exact() ? t.above() : dot(loop_normal(plc.points, plc.outer_loop(facet)), mesh.normal(mesh.face(f))) > 0;
    mesh.set_tag(f.cell(), f.face(), FaceTag(facet, above));
    if (const FaceRef other = mesh.cells().mirror(f); other.valid())
      mesh.set_tag(other.cell(), other.face(), FaceTag(facet, !above));
  });
}

}  // namespace geomesh::remesh

// SPDX-License-Identifier: MIT
// Facets given back their own triangles, declared in remesh/operations/surface_repair.hpp.
#include "quality/measure/shape.hpp"
#include "remesh/operations/surface_repair.hpp"

namespace geomesh::remesh {

namespace {

/// Facets by patch.
struct Members {
  explicit Members(const DomainMesh& mesh, std::size_t n_facets) : of_patch(mesh.n_patches()) {
    for (Index f = 0; f < n_facets; ++f) of_patch[mesh.patch_of_facet(f)].push_back(f);
  }
  /// The one nearest to p. Facets that share a patch in exact mode are triangles.
  Index nearest(const PiecewiseLinearComplex& plc, Index patch, const Vec3& p) const {
    const std::vector<Index>& facets = of_patch[patch];
    if (facets.size() == 1) return facets[0];
    Index best = no_index;
    double least = std::numeric_limits<double>::infinity();
    for (const Index f : facets) {
      const auto t = plc.outer_loop(f);
      const double d =
          squared_distance(p, search::closest_on_triangle(p, plc.points[t[0]], plc.points[t[1]], plc.points[t[2]]));
      if (d < least) least = d, best = f;
    }
    return best;
  }
  std::vector<std::vector<Index>> of_patch;
};

Vec3 normal_of(const PiecewiseLinearComplex& plc, Index facet) {
  const auto loop = plc.outer_loop(facet);
  return cross(plc.points[loop[1]] - plc.points[loop[0]], plc.points[loop[2]] - plc.points[loop[0]]);
}

}  // namespace

void renew_facets(DomainMesh& mesh, const SurfaceGuard& guard, const PiecewiseLinearComplex& plc) {
  const Members members(mesh, guard.exact() ? plc.n_facets() : 0);
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    for (unsigned i = 0; i < 4; ++i) {
      const FaceTag t = mesh.tag(c, i);
      if (!mesh.is_live(c) || !t.constrained() || t.facet() == hull_facet || (!t.above() && mesh.has_neighbor(c, i)))
        continue;
      const Tetrahedron& v = mesh.vertices(c);
      const Vec3 &p = mesh.point(v[face_vertices[i][0]]), &q = mesh.point(v[face_vertices[i][1]]),
                 &r = mesh.point(v[face_vertices[i][2]]);
      const Vec3 middle = (1.0 / 3) * (p + q + r);
      const Index patch = mesh.patch_of(t),
                  facet = guard.exact() ? members.nearest(plc, patch, middle) : guard.nearest_facet(patch, middle);
      if (facet == t.facet()) continue;
      // Facets merged in exact mode are oriented alike. Else: the face is seen from cell c, towards which its normal
      // points.
      const bool above = guard.exact() ? t.above() : dot(normal_of(plc, facet), cross(q - p, r - p)) > 0;
      const FaceTag renewed(facet, above);
      mesh.set_tag(c, i, renewed);
      if (!mesh.has_neighbor(c, i)) continue;
      const FaceRef other = mesh.topology().neighbor(c, i);
      mesh.set_tag(other.cell(), other.face(), renewed.opposite());
    }
}

}  // namespace geomesh::remesh

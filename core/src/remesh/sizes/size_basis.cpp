// SPDX-License-Identifier: MIT
#include "remesh/sizes/size_basis.hpp"

#include <cmath>
#include <tuple>

#include "common/geometry.hpp"
#include "remesh/domain/domain_io.hpp"

namespace geomesh::remesh {

namespace {

/// Returns for each facet a number that all pieces of one input facet share: the patch, if surfaces are kept exactly.
std::vector<Index> pieces_merged(const PiecewiseLinearComplex& plc, const DomainMesh& mesh,
                                 const RefineOptions& options) {
  if (options.honour == Honour::tolerance) return merge_pieces(plc, options.facet_parent).row_of_facet;
  std::vector<Index> rows;
  for (Index f = 0; f < plc.n_facets(); ++f) rows.push_back(mesh.patch_of_facet(f));
  return rows;
}

/// Returns the lengths of the edges at each vertex. Edges between pieces of one input triangle (equal in `merged`) are
/// left out, because the user did not choose them.
std::vector<EdgesAtVertex> edges_at_vertices(const DomainMesh& mesh, const std::vector<Index>& merged) {
  struct Use {
    std::array<VertexIndex, 2> edge;
    Index facet;
  };
  std::vector<Use> uses;
  mesh.for_each_facet_face([&](FaceRef f) {
    const Triangle t = mesh.face(f);
    for (unsigned k = 0; k < 3; ++k)
      uses.push_back({sorted(std::array{t[k], t[(k + 1) % 3]}), merged[mesh.tag(f).facet()]});
  });
  for (const auto& edge : mesh.curve_edges()) uses.push_back({edge, no_index});
  std::sort(uses.begin(), uses.end(),
            [](const Use& x, const Use& y) { return std::tie(x.edge, x.facet) < std::tie(y.edge, y.facet); });
  std::vector<EdgesAtVertex> edges(mesh.n_vertices());
  for (std::size_t i = 0, j; i < uses.size(); i = j) {
    for (j = i; j < uses.size() && uses[j].edge == uses[i].edge;) ++j;
    const bool is_curve = uses[j - 1].facet == no_index;
    const std::size_t n_faces = j - i - is_curve;
    if (!is_curve && n_faces == 2 && uses[i].facet == uses[i + 1].facet) continue;
    const auto [a, b] = uses[i].edge;
    const double l = distance(mesh.point(a), mesh.point(b));
    for (const VertexIndex v : {a, b}) edges[v].add(l, static_cast<double>(std::max(n_faces, std::size_t{1})));
  }
  return edges;
}

/// Lists the edges at which surfaces bend, and the faces of these surfaces.
void add_bends(const DomainMesh& mesh, SizeBasis& basis) {
  constexpr double flat = 1e-3, crease = 0.8;  // radians
  struct Half {
    std::array<VertexIndex, 2> edge;
    Vec3 normal, centroid;
    Index patch;
  };
  std::vector<Half> halves;
  mesh.for_each_facet_face([&](FaceRef f) {
    const Index facet = mesh.tag(f).facet(), patch = facet < basis.patch.size() ? basis.patch[facet] : no_index;
    const Triangle t = mesh.face(f);
    basis.faces.push_back({mesh.places(t), patch});
    const Vec3 n = unit(mesh.normal(t));
    if (n == Vec3{}) return;
    for (unsigned k = 0; k < 3; ++k)
      halves.push_back({sorted(std::array{t[k], t[(k + 1) % 3]}), n, mesh.middle(t), patch});
  });
  const auto key = [](const Half& h) { return std::tie(h.edge, h.centroid.x, h.centroid.y, h.centroid.z); };
  std::sort(halves.begin(), halves.end(), [&](const Half& x, const Half& y) { return key(x) < key(y); });
  for (std::size_t i = 0; i + 1 < halves.size(); ++i) {
    const Half &x = halves[i], &y = halves[i + 1];
    if (x.edge != y.edge || x.patch != y.patch) continue;
    const double turn = std::acos(std::clamp(std::abs(dot(x.normal, y.normal)), 0.0, 1.0));
    if (turn < flat || turn > crease) continue;
    basis.bends.push_back({x.edge, {x.centroid, y.centroid}, distance(x.centroid, y.centroid) / turn, x.patch});
  }
}

}  // namespace

SizeBasis size_basis(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options) {
  SizeBasis basis;
  basis.patch = named_patches(plc, options);
  basis.edges = edges_at_vertices(mesh, pieces_merged(plc, mesh, options));
  if (options.honour == Honour::tolerance || options.size.curvature_angle > 0) add_bends(mesh, basis);
  return basis;
}

}  // namespace geomesh::remesh

// SPDX-License-Identifier: MIT
// Splits an edge at its middle. Declared in remesh/operations/operations.hpp.
#include "quality/measure/shape.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

Vec3 Toolbox::normal_at(VertexIndex v) {
  const Vec3& p = mesh.point(v);
  const Index patch = mesh.support(v);
  if (guard.exact()) return guard.normal(patch, p);
  NearestFacet& nearest = nearest_facet[v];
  if (nearest.patch != patch || !(nearest.place == p)) nearest = {p, patch, guard.nearest_facet(patch, p)};
  return guard.normal_of(nearest.facet, p);
}

SurfacePart surface_of(const DomainMesh& mesh, const StarCavity& cavity, const Vec3& p) {
  SurfacePart part;
  for (const Spoke& s : cavity.spokes)
    part.faces.push_back({{p, mesh.point(s.a), mesh.point(s.b)}, mesh.patch_of_facet(s.facet)});
  for (const CurveSpoke& s : cavity.curves) part.curves.push_back({p, mesh.point(s.a), s.curve});
  return part;
}

std::vector<SurfaceFace> faces_at_edge(const DomainMesh& mesh, const StarCavity& cavity, VertexIndex a, VertexIndex b) {
  std::vector<SurfaceFace> faces;
  for (const Spoke& s : cavity.spokes)
    if (s.a == a || s.a == b)
      faces.push_back({mesh.places(Triangle{s.a == a ? b : a, s.a, s.b}), mesh.patch_of_facet(s.facet)});
  return faces;
}

VertexIndex fill_from_edge(Toolbox& tools, const StarCavity& cavity, VertexIndex a, VertexIndex b, const Vec3& p) {
  DomainMesh& mesh = tools.mesh;
  const Index curve = mesh.curve_of(a, b),
              patch = cavity.spokes.empty() ? no_index : mesh.patch_of_facet(cavity.spokes[0].facet);
  const VertexIndex v = curve != no_index     ? mesh.add_vertex(p, VertexKind::curve, curve)
                        : patch == no_index   ? mesh.add_vertex(p, VertexKind::inside)
                        : patch == hull_patch ? mesh.add_vertex(p, VertexKind::corner, patch)
                                              : mesh.add_vertex(p, VertexKind::surface, patch);
  if (curve != no_index) {
    mesh.erase_curve(a, b);
    mesh.set_curve(a, v, curve);
    mesh.set_curve(v, b, curve);
  }
  fill_with_star(mesh, cavity, v, tools.work);
  return v;
}

std::optional<VertexIndex> split_edge(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, double min_shape,
                                      const Vec3* place) {
  DomainMesh& mesh = tools.mesh;
  if (mesh.is_pinched(a, b)) return std::nullopt;
  StarCavity& cavity = tools.work.cavity;
  gather_edge(mesh, c, a, b, cavity);
  if (tools.stays(cavity, mesh.curve_of(a, b))) return std::nullopt;
  const Vec3 p = place ? *place : 0.5 * (mesh.point(a) + mesh.point(b));
  if (!star_is_positive(mesh, cavity, p)) return std::nullopt;
  if (tools.guard.exact() &&
      !tools.guard.keeps_sides(faces_at_edge(mesh, cavity, a, b), surface_of(mesh, cavity, p).faces))
    return std::nullopt;
  if (min_shape > 0 && !(star_shape(mesh, cavity, p, min_shape) > min_shape)) return std::nullopt;
  const VertexIndex v = fill_from_edge(tools, cavity, a, b, p);
  const VertexKind kind = mesh.kind(v);
  ++(kind == VertexKind::curve    ? tools.statistics.points_on_curves
     : kind == VertexKind::inside ? tools.statistics.points_inside
                                  : tools.statistics.points_on_surfaces);
  return v;
}

}  // namespace geomesh::remesh

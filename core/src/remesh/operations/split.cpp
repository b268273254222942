// SPDX-License-Identifier: MIT
// Halving of an edge, declared in remesh/operations/operations.hpp.
#include "quality/measure/shape.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

double Toolbox::size_at(VertexIndex v) {
  if (v >= vertex_size.size() || vertex_size[v] < 0)
    set_size(v, size.at(mesh.point(v), mesh.component(mesh.incident_cell(v))));
  return vertex_size[v];
}

void Toolbox::set_size(VertexIndex v, double h) {
  if (v >= vertex_size.size()) vertex_size.resize(mesh.n_vertices() + mesh.n_vertices() / 4 + 1, -1);
  vertex_size[v] = h;
}

double Toolbox::size_of_cell(CellIndex c) {
  double sum = 0;
  for (const VertexIndex v : mesh.vertices(c)) sum += size_at(v);
  return sum / 4;
}

void append_surface(const DomainMesh& mesh, const StarCavity& cavity, const Vec3& p, std::vector<SurfaceFace>& faces,
                    std::vector<CurvePiece>& curves) {
  for (const Spoke& s : cavity.spokes)
    faces.push_back({{p, mesh.point(s.a), mesh.point(s.b)}, mesh.patch_of_facet(s.facet)});
  for (const CurveSpoke& s : cavity.curves) curves.push_back({p, mesh.point(s.a), s.curve});
}

std::optional<VertexIndex> split_edge(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, double min_shape,
                                      const Vec3* place) {
  DomainMesh& mesh = tools.mesh;
  if (mesh.is_pinched(a, b)) return std::nullopt;
  StarCavity& cavity = tools.work.cavity;
  gather_edge(mesh, c, a, b, cavity);
  const Vec3 p = place ? *place : 0.5 * (mesh.point(a) + mesh.point(b));
  if (!star_is_positive(mesh, cavity, p)) return std::nullopt;
  if (min_shape > 0 && !(star_shape(mesh, cavity, p, min_shape) > min_shape)) return std::nullopt;
  const Index curve = mesh.curve_of(a, b);
  VertexIndex v;
  if (curve != no_index) {
    v = mesh.add_vertex(p, VertexKind::curve, curve);
    ++tools.statistics.points_on_curves;
  } else if (!cavity.spokes.empty()) {
    const Index patch = mesh.patch_of_facet(cavity.spokes[0].facet);
    v = mesh.add_vertex(p, patch == hull_patch ? VertexKind::corner : VertexKind::surface, patch);
    ++tools.statistics.points_on_surfaces;
  } else {
    v = mesh.add_vertex(p, VertexKind::inside);
    ++tools.statistics.points_inside;
  }
  if (curve != no_index) {
    mesh.erase_curve(a, b);
    mesh.set_curve(a, v, curve);
    mesh.set_curve(v, b, curve);
  }
  fill_with_star(mesh, cavity, v, tools.work);
  return v;
}

}  // namespace geomesh::remesh

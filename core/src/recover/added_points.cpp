// SPDX-License-Identifier: MIT
/// Added points are taken away again where the mesh can do without: those on segments and facets first (boundary_points_inward.cpp, which
/// may leave points inside regions), then those inside.
#include <algorithm>

#include "recover/messages.hpp"
#include "recover/polyhedron_filling.hpp"
#include "recover/recover.hpp"

namespace geomesh::recover {

namespace {

std::vector<Triangle> link_of(const ConstrainedMesh& mesh, const std::vector<CellIndex>& star, VertexIndex x) {
  std::vector<Triangle> out;
  for (CellIndex c : star) {
    const unsigned i = mesh.cells().index_of(c, x);
    const auto& l = face_vertices[i];
    out.push_back({mesh.cells().vertex(c, l[0]), mesh.cells().vertex(c, l[1]), mesh.cells().vertex(c, l[2])});
  }
  return out;
}

std::optional<std::vector<Tetrahedron>> fill_link(ConstrainedMesh& mesh, const Constraints& constraints, std::span<const Triangle> link, const std::vector<VertexIndex>& neighbors) {
  for (VertexIndex v : neighbors)
    if (auto fan = fan_from(mesh, constraints, link, v)) return fan;
  return fill_polyhedron(mesh, constraints, link);
}

/// Removes a point that no constraint holds: by filling its link, else after flips that lower its degree.
bool remove_inner_point(Recovery& recovery, VertexIndex x) {
  ConstrainedMesh& mesh = recovery.mesh;
  EdgeRemover remover(mesh, recovery.constraints);
  std::vector<CellIndex> star;
  for (unsigned round = 0; round < 8; ++round) {
    mesh.star(x, star);
    const std::vector<VertexIndex> neighbors = mesh.neighbors(x);
    if (auto filling = fill_link(mesh, recovery.constraints, link_of(mesh, star, x), neighbors)) {
      mesh.replace(star, *filling);
      mesh.forget(x);
      return true;
    }
    bool flipped = false;
    for (VertexIndex v : neighbors)
      if (mesh.find_edge(x, v) != no_cell && remover.remove(x, v, 1, nullptr, 60)) flipped = true;
    if (!flipped) return false;
  }
  return false;
}

}  // namespace

void require_untouched_boundary(const Recovery& recovery) {
  for (VertexIndex x = static_cast<VertexIndex>(recovery.mesh.n_input() + 8); x < recovery.mesh.points().size(); ++x) {
    const VertexRecord& r = recovery.constraints.vertices[x];
    if (!recovery.mesh.in_mesh(x) || r.origin == VertexOrigin::inside) continue;
    const bool on_segment = r.origin == VertexOrigin::on_segment;
    ErrorContext context;
    context.places = {recovery.mesh.point(x)};
    if (!on_segment) context.facets = {r.owner};
    if (on_segment && recovery.constraints.segments[r.owner].row != no_index) context.segments = {recovery.constraints.segments[r.owner].row};
    const ModelSegment segment = on_segment ? recovery.constraints.segments[r.owner] : ModelSegment{};
    throw Error(ErrorKind::cannot_mesh,
                (on_segment ? "the segment " + describe_edge(recovery, segment.a, segment.b) : "facet " + std::to_string(r.owner)) +
                    " cannot be kept free of added points: mesh it without preserve_boundary",
                std::move(context));
  }
}

void remove_added_points(Recovery& recovery) {
  ConstrainedMesh& mesh = recovery.mesh;
  const VertexIndex first = static_cast<VertexIndex>(mesh.n_input() + 8);
  for (VertexIndex x = static_cast<VertexIndex>(mesh.points().size()); x-- > first;) {
    recovery.context.check_cancelled();
    if (mesh.in_mesh(x) && recovery.constraints.vertices[x].origin != VertexOrigin::inside) take_point_off_boundary(recovery, x);
  }
  for (VertexIndex x = first; x < mesh.points().size(); ++x)
    if (mesh.in_mesh(x) && recovery.constraints.vertices[x].origin == VertexOrigin::inside) remove_inner_point(recovery, x);
}

}  // namespace geomesh::recover

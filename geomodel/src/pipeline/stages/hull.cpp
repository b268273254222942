// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/stages/hull.hpp"

#include "geomesh/core/delaunay.hpp"

namespace geomesh::geomodel {

TriangulatedSurface convex_hull_surface(const std::vector<TriangulatedSurface>& surfaces, const RunContext& context) {
  std::vector<Vec3> points;
  for (const TriangulatedSurface& surface : surfaces)
    points.insert(points.end(), surface.points.begin(), surface.points.end());
  RunContext quiet;
  quiet.cancel = context.cancel;
  quiet.threads = context.threads;
  const DelaunayTetrahedralization delaunay = delaunay_tetrahedralization(points, {}, quiet);

  TriangulatedSurface hull;
  hull.name = hull_name;
  std::vector<VertexIndex> row(points.size(), no_vertex);
  const auto row_of = [&](VertexIndex v) {
    if (row[v] == no_vertex) {
      row[v] = static_cast<VertexIndex>(hull.points.size());
      hull.points.push_back(points[v]);
    }
    return row[v];
  };
  for (CellIndex c = 0; c < delaunay.mesh.n_slots(); ++c) {
    if (!delaunay.mesh.is_live(c)) continue;
    const int ghost = delaunay.mesh.ghost_index(c);
    if (ghost < 0) continue;
    // Corners of hull faces are counter-clockwise as seen from the infinite vertex, so that normals point outward.
    const auto& f = face_vertices[static_cast<std::size_t>(ghost)];
    const auto& v = delaunay.mesh.vertices(c);
    hull.triangles.push_back({row_of(v[f[0]]), row_of(v[f[1]]), row_of(v[f[2]])});
  }
  return hull;
}

}  // namespace geomesh::geomodel

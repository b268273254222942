// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A named mesh from the grid fixture without the naming room: for tests of writers and reports alone.
#pragma once

#include "grid_model.hpp"

namespace geomesh::geomodel::testing {

/// The three-layer box, regions bottom, middle, top by elevation; coordinates times `scale` plus `shift`.
inline ModelMesh three_layer_mesh(int n = 2, double scale = 1, const Vec3& shift = {0, 0, 0}) {
  const GridModel grid = three_layers(n);
  const ModelPlc plc = make_plc(grid.soup, grid.surfaces, {}, {false});
  ModelMesh mesh;
  mesh.name = "three layers";
  for (const Vec3& p : grid.mesh.points) mesh.points.push_back(scale * p + shift);
  mesh.point_kind.assign(mesh.points.size(), 0);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) mesh.input_vertex.push_back(static_cast<std::int32_t>(v));
  mesh.tetrahedra = grid.mesh.tetrahedra;
  mesh.regions = {{1, "top", {}, 0, 0}, {2, "middle layer, which is long to name", {}, 0, 0}, {3, "bottom", {}, 0, 0}};
  for (const Tetrahedron& t : mesh.tetrahedra) {
    double z = 0;
    for (VertexIndex v : t) z += grid.mesh.points[v].z / 4;
    Region& region = mesh.regions[z > 2 ? 0 : z > 1 ? 1 : 2];
    mesh.tet_region.push_back(region.id);
    ++region.n_tetrahedra;
    region.volume += scale * scale * scale / 6;
  }
  std::int32_t id = 4;
  for (const TriangulatedSurface& s : grid.surfaces) {
    mesh.surfaces.push_back({id, s.name, s.kind, scale * scale * 0.5 * static_cast<double>(s.triangles.size())});
    mesh.surface_sets.push_back({id++});
  }
  for (const auto& face : grid.mesh.faces) {
    const auto region = [&](Index t) { return t == no_index ? 0 : mesh.tet_region[t]; };
    const auto& origin = grid.soup.origins[grid.soup.origin_offsets[face.facet]];
    ModelMesh::Face out{face.vertices,
                        static_cast<std::int32_t>(4 + origin.surface),
                        static_cast<std::int32_t>(origin.surface),
                        static_cast<std::int32_t>(plc.facet_patch[face.facet]),
                        region(face.tetrahedron_below),
                        region(face.tetrahedron_above),
                        static_cast<std::int32_t>(origin.triangle)};
    if (out.region_minus == 0 || (out.region_plus != 0 && out.region_plus < out.region_minus)) {
      std::swap(out.vertices[1], out.vertices[2]);
      std::swap(out.region_minus, out.region_plus);
    }
    mesh.faces.push_back(out);
  }
  for (const SoupCurve& c : plc.curves) mesh.curves.push_back({id++, c.name, c.kind, 1});
  const std::int32_t first_curve = id - static_cast<std::int32_t>(plc.curves.size());
  for (std::size_t s = 0; s < plc.plc.segments.size(); ++s)
    mesh.curve_edges.push_back({plc.plc.segments[s].a, plc.plc.segments[s].b,
                                first_curve + static_cast<std::int32_t>(plc.segment_curves[s][0])});
  mesh.marked_points.push_back({0, id++, "gauge 1"});
  return mesh;
}

}  // namespace geomesh::geomodel::testing

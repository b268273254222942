// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Small models on a regular grid, meshed by hand (each cell into six tetrahedra about its main diagonal): input for
/// tests of naming, writers and reports that need no engine.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "geomesh/core/predicates.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel::testing {

/// A surface made of the grid's mesh faces whose three vertices satisfy `holds` (given their grid indices); `reversed`
/// stores its triangles with normals against the axis directions.
struct GridSurface {
  std::string name;
  SurfaceKind kind;
  std::function<bool(const std::array<std::array<int, 3>, 3>&)> holds;
  bool reversed = false;
};

/// Faces in the plane index[axis] == at, where `where(i, j, k)` holds for all three vertices.
inline GridSurface plane(
    std::string name, SurfaceKind kind, int axis, int at,
    std::function<bool(int, int, int)> where = [](int, int, int) { return true; }) {
  return {std::move(name), kind, [=](const auto& vertices) {
            return std::all_of(vertices.begin(), vertices.end(),
                               [&](const auto& g) { return g[axis] == at && where(g[0], g[1], g[2]); });
          }};
}

struct GridModel {
  std::vector<TriangulatedSurface> surfaces;  ///< those given, then the box sides
  PolygonSoup soup;
  ConstrainedTetrahedralization mesh;
};

/// The box [0, n * step] with the surfaces given and the six box sides.
inline GridModel make_grid_model(std::array<int, 3> n, const Vec3& step, std::vector<GridSurface> wanted) {
  const char* sides[] = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};
  for (int s = 0; s < 6; ++s)
    wanted.push_back(plane(sides[s], SurfaceKind::box, s / 2, s % 2 ? n[static_cast<std::size_t>(s / 2)] : 0));
  GridModel model;
  const auto row = [&](int i, int j, int k) { return static_cast<VertexIndex>((k * (n[1] + 1) + j) * (n[0] + 1) + i); };
  std::vector<std::array<int, 3>> grid;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {
        grid.push_back({i, j, k});
        model.mesh.points.push_back({i * step.x, j * step.y, k * step.z});
      }
  auto& mesh = model.mesh;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        std::array<int, 3> axes{0, 1, 2};
        do {
          std::array<int, 3> g{i, j, k};
          Tetrahedron t;
          t[0] = row(g[0], g[1], g[2]);
          for (std::size_t a = 0; a < 3; ++a) {
            ++g[static_cast<std::size_t>(axes[a])];
            t[a + 1] = row(g[0], g[1], g[2]);
          }
          if (orient3d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]) == Sign::negative)
            std::swap(t[2], t[3]);
          mesh.tetrahedra.push_back(t);
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  for (VertexIndex v = 0; v < mesh.points.size(); ++v) {
    mesh.input_vertex.push_back(v);
    mesh.origin.push_back(VertexOrigin::input);
    model.soup.kind.push_back(SoupVertexKind::input);
    model.soup.input_point.push_back(v);
  }
  model.soup.points = mesh.points;

  // Faces by sorted vertices: the (one or two) tetrahedra there; face i of a tetrahedron has its normal towards it.
  std::map<Triangle, std::vector<std::pair<Index, Triangle>>> faces;
  for (Index t = 0; t < mesh.tetrahedra.size(); ++t)
    for (const auto& f : face_vertices) {
      const Tetrahedron& v = mesh.tetrahedra[t];
      const Triangle inward{v[f[0]], v[f[1]], v[f[2]]};
      Triangle key = inward;
      std::sort(key.begin(), key.end());
      faces[key].push_back({t, inward});
    }
  for (const GridSurface& w : wanted) {
    model.surfaces.emplace_back();
    model.surfaces.back().name = w.name;
    model.surfaces.back().kind = w.kind;
    model.surfaces.back().points = mesh.points;
  }
  std::vector<Index> parent(mesh.tetrahedra.size());
  for (Index t = 0; t < parent.size(); ++t) parent[t] = t;
  const std::function<Index(Index)> find = [&](Index t) { return parent[t] == t ? t : parent[t] = find(parent[t]); };
  for (const auto& [key, uses] : faces) {
    const std::array<std::array<int, 3>, 3> g{grid[key[0]], grid[key[1]], grid[key[2]]};
    Index facet = no_index;
    for (Index s = 0; s < wanted.size(); ++s) {
      if (!wanted[s].holds(g)) continue;
      // Stored with the normal towards the axis directions: the sum of its components is positive (grid faces are never
      // oblique to it).
      Triangle stored = uses[0].second;
      const Vec3 normal =
          cross(mesh.points[stored[1]] - mesh.points[stored[0]], mesh.points[stored[2]] - mesh.points[stored[0]]);
      bool positive = normal.x + normal.y + normal.z > 0;
      if (normal.x + normal.y + normal.z == 0) positive = normal.z > 0 || (normal.z == 0 && normal.y > 0);
      if (positive == wanted[s].reversed) std::swap(stored[1], stored[2]);
      const Index triangle = static_cast<Index>(model.surfaces[s].triangles.size());
      model.surfaces[s].triangles.push_back(stored);
      if (facet == no_index) {
        facet = static_cast<Index>(model.soup.facets.size());
        model.soup.facets.push_back(stored);
      }
      const Triangle& f = model.soup.facets[facet];
      const bool same =
          std::find(f.begin(), f.end(), stored[0]) != f.end() &&
          f[(static_cast<std::size_t>(std::find(f.begin(), f.end(), stored[0]) - f.begin()) + 1) % 3] == stored[1];
      model.soup.origins.push_back({s, triangle, !same});
    }
    if (facet == no_index) {
      if (uses.size() == 2) parent[find(uses[0].first)] = find(uses[1].first);
      continue;
    }
    model.soup.origin_offsets.push_back(static_cast<Index>(model.soup.origins.size()));
    const Triangle& f = model.soup.facets[facet];
    ConstrainedTetrahedralization::Face out{f, facet};
    for (const auto& [t, inward] : uses) {
      const auto at = static_cast<std::size_t>(std::find(inward.begin(), inward.end(), f[0]) - inward.begin());
      (inward[(at + 1) % 3] == f[1] ? out.tetrahedron_above : out.tetrahedron_below) = t;
    }
    mesh.faces.push_back(out);
  }
  std::map<Index, Index> component_rows;
  for (Index t = 0; t < mesh.tetrahedra.size(); ++t)
    mesh.component.push_back(component_rows.emplace(find(t), static_cast<Index>(component_rows.size())).first->second);
  mesh.n_components = component_rows.size();
  mesh.component_seed.assign(mesh.n_components, no_index);
  return model;
}

/// Fills mesh.edges from the PLC's segments (each is one edge of the grid's mesh).
inline void add_segment_edges(const ModelPlc& plc, ConstrainedTetrahedralization& mesh) {
  for (Index s = 0; s < plc.plc.segments.size(); ++s)
    mesh.edges.push_back({plc.plc.segments[s].a, plc.plc.segments[s].b, s});
}

/// Three layers (bottom, middle, top, each one unit thick) in a box of n x n x 3 cells, named by a column.
inline GridModel three_layers(int n = 2) {
  return make_grid_model({n, n, 3}, {1, 1, 1},
                         {plane("upper", SurfaceKind::horizon, 2, 2), plane("lower", SurfaceKind::horizon, 2, 1)});
}
inline NamingRules three_layer_rules() { return {{"top", "upper", "middle", "lower", "bottom"}, {}, {}}; }

}  // namespace geomesh::geomodel::testing

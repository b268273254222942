// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/framework/up_to_walls.hpp"

#include "naming/sheets.hpp"
#include "rules/framework/end_at_walls.hpp"
#include "rules/framework/end_on_faults.hpp"

namespace geomesh::geomodel {
namespace {

bool is_continued_horizon(const BuiltSurfaces& built, Index row) {
  return built.surfaces[row].kind == SurfaceKind::horizon && !built.rows.part_of_triangle[row].empty();
}

/// Only what continues the horizon, and what shares a corner with that.
void keep_near_continuation(TriangulatedSurface& horizon, std::vector<Index>& part) {
  const std::vector<VertexIndex> merged = merge_equal_points(horizon.points);
  std::vector<bool> is_near(horizon.points.size(), false);
  for (Index t = 0; t < part.size(); ++t)
    if (part[t] != 0)
      for (const VertexIndex v : horizon.triangles[t]) is_near[merged[v]] = true;
  std::vector<Triangle> triangles;
  std::vector<Index> kept;
  for (Index t = 0; t < part.size(); ++t) {
    const Triangle& v = horizon.triangles[t];
    if (part[t] == 0 && !is_near[merged[v[0]]] && !is_near[merged[v[1]]] && !is_near[merged[v[2]]]) continue;
    triangles.push_back(v);
    kept.push_back(part[t]);
  }
  horizon.triangles = std::move(triangles);
  part = std::move(kept);
}

}  // namespace

std::vector<TriangulatedSurface> horizons_up_to_walls(const BuiltSurfaces& built, const ModelRules& rules) {
  BuiltSurfaces near = built;
  for (Index s = 0; s < near.surfaces.size(); ++s) {
    if (is_continued_horizon(built, s))
      keep_near_continuation(near.surfaces[s], near.rows.part_of_triangle[s]);
    else if (near.surfaces[s].kind == SurfaceKind::horizon)
      near.surfaces[s].triangles.clear();
  }
  const ArrangedWalls walls = arrange_walls(near, rules, {SurfaceKind::fault, SurfaceKind::body, SurfaceKind::horizon});
  WorkingSoup working(walls.soup);
  std::vector<double> area(walls.surfaces.size(), 0);
  std::vector<std::string> notes;  // told where the model's own soup is cut
  end_faults(working, walls.surfaces, near.rows, rules.continuation.within_of_faults, {area, notes});
  std::vector<TriangulatedSurface> cut(built.surfaces.size());
  for (Index s = 0; s < cut.size(); ++s) {
    if (!is_continued_horizon(built, s)) continue;
    end_at_walls(working, walls.surfaces, near.rows, s);
    cut[s] = built.surfaces[s];
    cut[s].triangles.clear();
    for (Index t = 0; t < built.surfaces[s].triangles.size(); ++t)
      if (built.rows.part_of_triangle[s][t] == 0) cut[s].triangles.push_back(built.surfaces[s].triangles[t]);
    const auto n_points = static_cast<VertexIndex>(cut[s].points.size());
    cut[s].points.insert(cut[s].points.end(), working.soup.points.begin(), working.soup.points.end());
    for (Index f = 0; f < working.origins.size(); ++f) {
      const PolygonSoup::Origin* origin = working.origin_of(f, s);
      if (!origin || near.rows.part_of_triangle[s][origin->triangle] == 0) continue;
      Triangle t = working.soup.facets[f];
      for (VertexIndex& v : t) v += n_points;
      cut[s].triangles.push_back(t);
    }
  }
  return cut;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "fractures/plane_polygons.hpp"

#include <algorithm>
#include <cmath>

#include "fractures/fracture.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {
namespace {

bool is_plane_polygon(const TriangulatedSurface& surface) {
  const std::vector<Vec3>& p = surface.points;
  if (surface.triangles.empty() || p.size() != surface.triangles.size() + 2) return false;
  Vec3 normal, mean;
  for (const Triangle& t : surface.triangles) normal = normal + cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
  for (const Vec3& corner : p) mean = mean + (1 / static_cast<double>(p.size())) * corner;
  double size = 0, off = 0;
  for (const Vec3& corner : p) {
    size = std::max(size, norm(corner - mean));
    off = std::max(off, std::abs(dot(normal, corner - mean)));
  }
  return off <= plane_share * size * norm(normal);
}

}  // namespace

std::vector<bool> plane_polygons(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules) {
  std::vector<bool> found;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const SurfaceRules rule = rules.of(s);
    found.push_back(surfaces[s].kind == SurfaceKind::fault && !rule.continues && rule.extend == Extend::none &&
                    is_plane_polygon(surfaces[s]));
  }
  return found;
}

bool is_fracture_network(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules) {
  const std::vector<bool> polygons = plane_polygons(surfaces, rules);
  bool any = false;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    any = any || polygons[s];
    if (!polygons[s] && surfaces[s].kind != SurfaceKind::box && !surfaces[s].triangles.empty()) return false;
  }
  return any;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/framework/block_framework.hpp"

#include <algorithm>
#include <vector>

#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/build_model.hpp"
#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "rules/framework/end_on_faults.hpp"
#include "rules/framework/fault_truncations.hpp"

namespace geomesh::geomodel {
namespace {

/// Clips a convex polygon by a face of a tetrahedron, and returns the part on the side of the face's opposite corner.
std::vector<Vec3> cut_at_face(const std::vector<Vec3>& polygon, const std::array<Vec3, 4>& t, std::size_t corner) {
  const Vec3 &a = t[(corner + 1) % 4], &b = t[(corner + 2) % 4], &c = t[(corner + 3) % 4];
  Vec3 inward = cross(b - a, c - a);
  if (dot(inward, t[corner] - a) < 0) inward = -1.0 * inward;
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = dot(inward, p - a), at_q = dot(inward, q - a);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}

bool has_area(const std::vector<Vec3>& polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i)
    if (norm(cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0])) > 0) return true;
  return false;
}

}  // namespace

BlockFramework::BlockFramework(const BuiltSurfaces& built, const ModelRules& rules) {
  const ArrangedWalls walls = arrange_walls(built, rules, {SurfaceKind::fault, SurfaceKind::body});
  WorkingSoup working(walls.soup);
  std::vector<double> area(walls.surfaces.size(), 0);
  // Notes on cut faults are discarded, because the user gets the same ones when the model's faults are cut.
  std::vector<std::string> notes;
  end_faults(working, walls.surfaces, built.rows, rules.continuation.within_of_faults, {area, notes});
  const PolygonSoup soup = working.result();
  const ModelPlc plc = make_plc(soup, walls.surfaces, {});
  ConstrainedTetrahedralization mesh = tetrahedralize(plc.plc);
  has_tip_.assign(mesh.n_components, false);
  const std::vector<Index> unconformities = truncating_horizons(built.rows.truncations);
  const auto unconformities_at = [&](Index facet) {
    std::vector<Index> at;
    const Index row = plc.facet_soup[plc.facet_soup_offsets[facet]];
    for (Index k = soup.origin_offsets[row]; k < soup.origin_offsets[row + 1]; ++k)
      if (std::ranges::binary_search(unconformities, soup.origins[k].surface)) at.push_back(soup.origins[k].surface);
    return at;
  };
  for (const auto& face : mesh.faces) {
    const Index below = component_of(mesh, face.tetrahedron_below), above = component_of(mesh, face.tetrahedron_above);
    if (below == above && below != no_index) has_tip_[below] = true;
    for (const Index horizon : unconformities_at(face.facet)) {
      const Vec3 &a = mesh.points[face.vertices[0]], &b = mesh.points[face.vertices[1]],
                 &c = mesh.points[face.vertices[2]];
      const double up = cross(b - a, c - a).z;
      side_[{above, horizon}] += up;
      side_[{below, horizon}] -= up;
    }
  }
  block_ = std::move(mesh.component);
  bounds_.resize(n_blocks());
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    for (const VertexIndex v : mesh.tetrahedra[t]) bounds_[block_[t]].add(mesh.points[v]);
  search_ = std::make_unique<TetrahedronSearch>(std::move(mesh.points), std::move(mesh.tetrahedra));
}

int BlockFramework::side_of_unconformity(Index block, Index horizon) const {
  const auto at = side_.find({block, horizon});
  return at == side_.end() || at->second == 0 ? 0 : at->second > 0 ? 1 : -1;
}

Index BlockFramework::block_at(const Vec3& p) const {
  Index last = no_index;
  return block_at(p, last);
}

Index BlockFramework::block_at(const Vec3& p, Index& last) const {
  const Index found = search_->find(p, last);
  if (found == no_index) return no_index;
  last = found;
  return block_[found];
}

bool BlockFramework::overlaps(Index block, const std::array<Vec3, 3>& triangle) const {
  Box3 box;
  for (const Vec3& p : triangle) box.add(p);
  bool found = false;
  search_->boxes().boxes_meeting(box, [&](Index t) {
    if (found || block_[t] != block) return;
    std::vector<Vec3> polygon(triangle.begin(), triangle.end());
    for (std::size_t k = 0; k < 4; ++k) polygon = cut_at_face(polygon, search_->corners(t), k);
    found = has_area(polygon);
  });
  return found;
}

}  // namespace geomesh::geomodel

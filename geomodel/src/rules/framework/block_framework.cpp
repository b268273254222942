// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/framework/block_framework.hpp"

#include <algorithm>

#include "geomesh/core/predicates.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/build_model.hpp"
#include "naming/region_facts.hpp"
#include "rules/framework/end_on_faults.hpp"
#include "rules/framework/fault_roofs.hpp"

namespace geomesh::geomodel {
namespace {

/// The side of each corner: negative where p lies beyond the face opposite to it.
bool holds(const std::array<Vec3, 4>& t, const Vec3& p) {
  return orient3d(t[0], t[1], t[2], p) != -orient3d(t[0], t[1], t[2], t[3]) &&
         orient3d(t[0], t[3], t[1], p) != -orient3d(t[0], t[3], t[1], t[2]) &&
         orient3d(t[1], t[3], t[2], p) != -orient3d(t[1], t[3], t[2], t[0]) &&
         orient3d(t[0], t[2], t[3], p) != -orient3d(t[0], t[2], t[3], t[1]);
}

}  // namespace

BlockFramework::BlockFramework(const BuiltSurfaces& built, const ModelRules& rules) {
  const ArrangedWalls walls = arrange_walls(built, rules, {SurfaceKind::fault, SurfaceKind::body});
  WorkingSoup working(walls.soup);
  std::vector<double> area(walls.surfaces.size(), 0);
  std::vector<std::string> notes;  // told where the model's own soup is cut
  end_faults(working, walls.surfaces, built.rows, rules.continuation.within_of_faults, {area, notes});
  const PolygonSoup soup = working.result();
  const ModelPlc plc = make_plc(soup, walls.surfaces, {});
  ConstrainedTetrahedralization mesh = tetrahedralize(plc.plc);
  has_tip_.assign(mesh.n_components, false);
  const std::vector<Index> roofs = horizons_of(built.rows.roofs);
  const auto roofs_at = [&](Index facet) {
    std::vector<Index> at;
    const Index row = plc.facet_soup[plc.facet_soup_offsets[facet]];
    for (Index k = soup.origin_offsets[row]; k < soup.origin_offsets[row + 1]; ++k)
      if (std::ranges::binary_search(roofs, soup.origins[k].surface)) at.push_back(soup.origins[k].surface);
    return at;
  };
  for (const auto& face : mesh.faces) {
    const Index below = component_of(mesh, face.tetrahedron_below), above = component_of(mesh, face.tetrahedron_above);
    if (below == above && below != no_index) has_tip_[below] = true;
    for (const Index roof : roofs_at(face.facet)) {
      const Vec3 &a = mesh.points[face.vertices[0]], &b = mesh.points[face.vertices[1]],
                 &c = mesh.points[face.vertices[2]];
      const double up = cross(b - a, c - a).z;
      side_[{above, roof}] += up;
      side_[{below, roof}] -= up;
    }
  }
  points_ = std::move(mesh.points);
  tetrahedra_ = std::move(mesh.tetrahedra);
  block_ = std::move(mesh.component);
  bounds_.resize(n_blocks());
  std::vector<Box3> boxes;
  for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
    Box3& box = boxes.emplace_back();
    for (const VertexIndex v : tetrahedra_[t]) {
      box.add(points_[v]);
      bounds_[block_[t]].add(points_[v]);
    }
  }
  tree_ = std::make_unique<arrangement::BoxTree>(boxes);
}

int BlockFramework::side_of_roof(Index block, Index horizon) const {
  const auto at = side_.find({block, horizon});
  return at == side_.end() || at->second == 0 ? 0 : at->second > 0 ? 1 : -1;
}

Index BlockFramework::block_at(const Vec3& p) const {
  Box3 place;
  place.add(p);
  Index found = no_index;
  tree_->boxes_meeting(place, [&](Index t) {
    const Tetrahedron& v = tetrahedra_[t];
    if (t < found && holds({points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]}, p)) found = t;
  });
  return found == no_index ? no_index : block_[found];
}

}  // namespace geomesh::geomodel

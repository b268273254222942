// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/framework/block_framework.hpp"

#include <algorithm>

#include "geomesh/core/predicates.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/build_model.hpp"
#include "naming/region_facts.hpp"
#include "rules/framework/end_on_faults.hpp"

namespace geomesh::geomodel {
namespace {

/// The side of each corner: negative where p lies beyond the face opposite to it.
bool holds(const std::array<Vec3, 4>& t, const Vec3& p) {
  return orient3d(t[0], t[1], t[2], p) != -orient3d(t[0], t[1], t[2], t[3]) &&
         orient3d(t[0], t[3], t[1], p) != -orient3d(t[0], t[3], t[1], t[2]) &&
         orient3d(t[1], t[3], t[2], p) != -orient3d(t[1], t[3], t[2], t[0]) &&
         orient3d(t[0], t[2], t[3], p) != -orient3d(t[0], t[2], t[3], t[1]);
}

/// The soup of faults, bodies and sides, with the sides after the surfaces.
PolygonSoup soup_of_walls(const BuiltSurfaces& built, const ModelRules& rules, std::vector<TriangulatedSurface>& all) {
  all = built.surfaces;
  for (TriangulatedSurface& s : all)
    if (s.kind != SurfaceKind::fault && s.kind != SurfaceKind::body) s.triangles.clear();
  ArrangementOptions options;
  if (rules.continuation.sides.size() == 1)  // a box is one surface
    options.box = rules.continuation.bounds;
  else
    options.volume = rules.continuation.sides;
  const ArrangementResult arranged = arrange(all, {}, {}, options);
  all.insert(all.end(), arranged.box_sides.begin(), arranged.box_sides.end());
  WorkingSoup working(arranged.soup);
  std::vector<double> area(all.size(), 0);
  std::vector<std::string> notes;
  end_faults(working, all, built.rows, rules.continuation.within_of_faults, {area, notes});
  return working.result();
}

}  // namespace

BlockFramework::BlockFramework(const BuiltSurfaces& built, const ModelRules& rules) {
  std::vector<TriangulatedSurface> all;
  const PolygonSoup soup = soup_of_walls(built, rules, all);
  const ModelPlc plc = make_plc(soup, all, {});
  ConstrainedTetrahedralization mesh = tetrahedralize(plc.plc);
  has_tip_.assign(mesh.n_components, false);
  for (const auto& face : mesh.faces) {
    const Index below = component_of(mesh, face.tetrahedron_below), above = component_of(mesh, face.tetrahedron_above);
    if (below == above && below != no_index) has_tip_[below] = true;
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

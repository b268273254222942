// SPDX-License-Identifier: GPL-3.0-or-later
#include "geomesh/geomodel/ask_stack.hpp"

#include <algorithm>

namespace geomesh::geomodel {
namespace {

double size_in_map(const NamedSizes& sizes, const std::vector<std::string>& column) {
  double least = sizes.base.global;
  const auto take = [&](double size) {
    if (size > 0 && (least == 0 || size < least)) least = size;
  };
  for (const std::string& name : column) {
    if (const auto at = sizes.units.find(name); at != sizes.units.end()) take(at->second.size);
    if (const auto at = sizes.surfaces.find(name); at != sizes.surfaces.end()) take(at->second.size);
  }
  return least;
}

TriangulatedSurface box_surface(const Box3& b) {
  TriangulatedSurface s;
  for (int corner = 0; corner < 8; ++corner)
    s.points.push_back(
        {corner & 1 ? b.max.x : b.min.x, corner & 2 ? b.max.y : b.min.y, corner & 4 ? b.max.z : b.min.z});
  constexpr VertexIndex quads[6][4] = {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                       {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}};
  for (const auto& q : quads) {
    s.triangles.push_back({q[0], q[1], q[2]});
    s.triangles.push_back({q[0], q[2], q[3]});
  }
  return s;
}

}  // namespace

void ask_stack(ModelRules& rules, const RefinementSettings& refinement, const ModelVolume& volume) {
  if (!refinement.refine || refinement.honour != Honour::tolerance || volume.bounds.empty()) return;
  // A surface contoured from a field continues beyond the faults that bound the field's domain until the arranged model
  // is cut there. A common triangulation of the map would treat that continuation as data, so such models have none.
  if (std::any_of(rules.surfaces.begin(), rules.surfaces.end(),
                  [](const SurfaceRules& rule) { return rule.has_fault_domain(); }))
    return;
  StackRules& stack = rules.stack;
  stack.tolerance = refinement.tolerance.left();
  // Triangles cannot be larger than the model, so the size is at most the shorter side of the model in the map.
  const Box3& b = volume.bounds;
  stack.size = std::min({size_in_map(refinement.size, rules.column), b.max.x - b.min.x, b.max.y - b.min.y});
  stack.outline_is_box = volume.box.has_value();
  if (stack.outline_is_box) {
    stack.outline = {{b.min.x, b.min.y}, {b.max.x, b.min.y}, {b.max.x, b.max.y}, {b.min.x, b.max.y}};
    return;
  }
  for (std::size_t i = 0; i + 2 < volume.sides.size(); ++i)  // the model's last two sides are zmin and zmax
    stack.outline.push_back({volume.sides[i].points[0].x, volume.sides[i].points[0].y});
}

void ask_continuation(ModelRules& rules, const RefinementSettings& refinement, const ModelVolume& volume) {
  constexpr double share_of_model = 0.05;
  if (volume.bounds.empty()) return;
  ContinuationRules& how = rules.continuation;
  how.bounds = volume.bounds;
  how.sides = volume.sides;
  if (volume.box) how.sides.push_back(box_surface(*volume.box));
  const Vec3 extent = volume.bounds.max - volume.bounds.min;
  const double shorter = std::min(extent.x, extent.y), share = share_of_model * shorter;
  const double size = refinement.refine ? std::min(size_in_map(refinement.size, rules.column), shorter) : 0;
  how.within_of_horizons = std::max(size, share);
  how.within_of_faults = size > 0 ? std::min(size, share) : share;
  if (rules.continue_within >= 0) how.within_of_horizons = how.within_of_faults = rules.continue_within;
}

}  // namespace geomesh::geomodel

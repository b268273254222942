// SPDX-License-Identifier: GPL-3.0-or-later
#include "geomesh/geomodel/ask_stack.hpp"

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

}  // namespace

void ask_stack(ModelRules& rules, const RefinementSettings& refinement, const ModelVolume& volume) {
  if (!refinement.refine || refinement.honour != Honour::tolerance || volume.bounds.empty()) return;
  StackRules& stack = rules.stack;
  stack.tolerance = refinement.tolerance;
  stack.size = size_in_map(refinement.size, rules.column);
  const Box3& b = volume.bounds;
  stack.outline_is_box = volume.box.has_value();
  if (stack.outline_is_box) {
    stack.outline = {{b.min.x, b.min.y}, {b.max.x, b.min.y}, {b.max.x, b.max.y}, {b.min.x, b.max.y}};
    return;
  }
  for (std::size_t i = 0; i + 2 < volume.sides.size(); ++i)  // zmin and zmax are the last
    stack.outline.push_back({volume.sides[i].points[0].x, volume.sides[i].points[0].y});
}

}  // namespace geomesh::geomodel

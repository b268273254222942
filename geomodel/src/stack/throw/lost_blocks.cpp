// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/throw/lost_blocks.hpp"

#include <vector>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/map_locator.hpp"
#include "rules/throw/sheet_sides.hpp"

namespace geomesh::geomodel {
namespace {

constexpr int places_across = 48;
constexpr double most_lost = 0.02;

template <class F>
void for_each_place(const MapBounds& bounds, F&& visit) {
  for (int i = 0; i < places_across; ++i)
    for (int j = 0; j < places_across; ++j)
      visit(Vec2{bounds.min.x + (i + 0.5) / places_across * (bounds.max.x - bounds.min.x),
                 bounds.min.y + (j + 0.5) / places_across * (bounds.max.y - bounds.min.y)});
}

/// Returns a horizon's blocks all of whose triangles cross a fault, or that have no triangles.
std::vector<bool> blocks_across_alone(const SidedHorizon& after, std::size_t n_blocks) {
  std::vector<bool> across(n_blocks, true);
  for (Index t = 0; t < after.n_single; ++t)
    if (after.block[t] < n_blocks) across[after.block[t]] = false;
  return across;
}

/// Returns whether the block is, at some place of the map, on its own side of every fault.
bool has_a_place(const TriangulatedSurface& block, const std::vector<bool>& sides, const BlockPlaces& places) {
  if (block.triangles.empty()) return false;
  std::vector<FaultSides> faults;
  for (const ThrowFault& fault : places.faults.faults) faults.emplace_back(*fault.surface);
  const MapLocator locator(block);
  bool found = false;
  for_each_place(places.bounds, [&](Vec2 p) {
    const auto height = locator.height(p);
    if (found || !height) return;
    const Vec2 at = places.frame.to_model(p);
    found = true;
    for (std::size_t f = 0; f < faults.size(); ++f)
      found = found && faults[f].is_above({at.x, at.y, *height}) == sides[f];
  });
  return found;
}

}  // namespace

bool loses_blocks(const BlockData& before, const SidedHorizon& after, const BlockPlaces& places) {
  std::vector<TriangulatedSurface> blocks(before.blocks.size());
  const std::vector<bool> across = blocks_across_alone(after, blocks.size());
  for (Index b = 0; b < blocks.size(); ++b) {
    if (across[b] && has_a_place(before.blocks[b], places.faults.sides[b], places)) return true;
    blocks[b].points = after.points;
    for (std::size_t t = 0; t < after.triangles.size(); ++t)
      if (after.block[t] == b || after.block[t] == BuiltRows::of_every_block)
        blocks[b].triangles.push_back(after.triangles[t]);
  }
  std::vector<MapLocator> there(blocks.begin(), blocks.end());
  const MapLocator given(before.single);
  int n = 0, lost = 0;
  for_each_place(places.bounds, [&](Vec2 p) {
    const Index t = given.find(p).triangle;
    if (t == no_index || before.block_of_single[t] >= there.size()) return;
    ++n;
    const Index block = before.block_of_single[t];
    lost += across[block] || there[block].find(p).count == 0;
  });
  return lost > most_lost * n;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/throw/lost_blocks.hpp"

#include <vector>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/map_locator.hpp"

namespace geomesh::geomodel {

bool loses_blocks(const BlockData& before, const SidedHorizon& after, const MapBounds& bounds) {
  constexpr int places_across = 48;
  constexpr double most_lost = 0.02;
  std::vector<TriangulatedSurface> blocks(before.blocks.size());
  std::vector<bool> crosses_alone(blocks.size(), true);  // no triangle of the block but those that cross faults
  for (Index t = 0; t < after.n_single; ++t)
    if (after.block[t] < blocks.size()) crosses_alone[after.block[t]] = false;
  for (Index b = 0; b < blocks.size(); ++b) {
    blocks[b].points = after.points;
    for (std::size_t t = 0; t < after.triangles.size(); ++t)
      if (after.block[t] == b || after.block[t] == BuiltRows::of_every_block)
        blocks[b].triangles.push_back(after.triangles[t]);
  }
  std::vector<MapLocator> there(blocks.begin(), blocks.end());
  const MapLocator given(before.single);
  int n = 0, lost = 0;
  for (int i = 0; i < places_across; ++i)
    for (int j = 0; j < places_across; ++j) {
      const Vec2 p{bounds.min.x + (i + 0.5) / places_across * (bounds.max.x - bounds.min.x),
                   bounds.min.y + (j + 0.5) / places_across * (bounds.max.y - bounds.min.y)};
      const Index t = given.find(p).triangle;
      if (t == no_index || before.block_of_single[t] >= there.size()) continue;
      ++n;
      const Index block = before.block_of_single[t];
      lost += crosses_alone[block] || there[block].find(p).count == 0;
    }
  return lost > most_lost * n;
}

}  // namespace geomesh::geomodel

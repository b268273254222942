// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/throw/block_data.hpp"

#include <algorithm>
#include <memory>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/map_locator.hpp"
#include "rules/planar/single_valued.hpp"

namespace geomesh::geomodel {
namespace {

/// The triangles of one block and those that belong to every block, with their indices in the horizon.
struct BlockRows {
  TriangulatedSurface surface;
  std::vector<Index> rows;
};

std::vector<BlockRows> split(const TriangulatedSurface& horizon, const std::vector<Index>& block_of) {
  TriangulatedSurface empty = horizon;
  empty.triangles.clear();
  std::vector<BlockRows> blocks(BuiltRows::n_blocks(block_of), {empty, {}});
  for (Index b = 0; b < blocks.size(); ++b)
    for (Index t = 0; t < block_of.size(); ++t)
      if (block_of[t] == b || block_of[t] == BuiltRows::of_every_block) {
        blocks[b].surface.triangles.push_back(horizon.triangles[t]);
        blocks[b].rows.push_back(t);
      }
  return blocks;
}

/// Decides whether triangles of other blocks lie above or below a triangle.
class Overlaps {
 public:
  Overlaps(const TriangulatedSurface& horizon, const std::vector<Index>& block_of, Index n_given)
      : horizon_(horizon), block_of_(block_of), n_given_(n_given), blocks_(split(horizon, block_of)) {
    for (const BlockRows& block : blocks_) locators_.push_back(std::make_unique<MapLocator>(block.surface));
  }
  std::vector<BlockRows>& blocks() { return blocks_; }

  /// Returns whether a triangle of another block lies above or below triangle t. An original triangle is compared with
  /// original ones only, a triangle made by rules with all.
  bool is_under_another(Index t) const {
    const Triangle& v = horizon_.triangles[t];
    std::array<Vec2, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = {horizon_.points[v[i]].x, horizon_.points[v[i]].y};
    const Vec2 centre{(p[0].x + p[1].x + p[2].x) / 3, (p[0].y + p[1].y + p[2].y) / 3};
    if (is_met(t, centre)) return true;
    if (t < n_given_) return false;
    constexpr double towards_corner = 0.9;
    return std::any_of(p.begin(), p.end(), [&](const Vec2& q) {
      return is_met(t, {centre.x + towards_corner * (q.x - centre.x), centre.y + towards_corner * (q.y - centre.y)});
    });
  }

 private:
  bool is_met(Index t, const Vec2& p) const {
    for (Index b = 0; b < blocks_.size(); ++b) {
      if (block_of_[t] == b) continue;
      const Index found = locators_[b]->find(p).triangle;
      if (found != no_index && (t >= n_given_ || blocks_[b].rows[found] < n_given_)) return true;
    }
    return false;
  }

  const TriangulatedSurface& horizon_;
  const std::vector<Index>& block_of_;
  Index n_given_;
  std::vector<BlockRows> blocks_;
  std::vector<std::unique_ptr<MapLocator>> locators_;
};

}  // namespace

BlockData block_data(const TriangulatedSurface& horizon, const std::vector<Index>& block_of, Index n_given) {
  BlockData data{horizon};
  if (block_of.empty()) return data;
  data.single.triangles.clear();
  Overlaps overlaps(horizon, block_of, n_given);
  for (Index t = 0; t < block_of.size(); ++t) {
    if (block_of[t] == BuiltRows::of_no_block) continue;
    if (block_of[t] != BuiltRows::of_every_block && overlaps.is_under_another(t)) continue;
    data.single.triangles.push_back(horizon.triangles[t]);
    data.block_of_single.push_back(block_of[t]);
  }
  for (BlockRows& block : overlaps.blocks()) data.blocks.push_back(std::move(block.surface));
  return data;
}

bool is_single_valued_by_block(const TriangulatedSurface& horizon, const std::vector<Index>& block_of, Index n_given) {
  if (block_of.empty()) return is_single_valued(horizon);
  const std::vector<Index> given(block_of.begin(), block_of.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(
                                                                          n_given, block_of.size())));
  const std::vector<BlockRows> blocks = split(horizon, given);
  return std::all_of(blocks.begin(), blocks.end(), [](const BlockRows& b) { return is_single_valued(b.surface); });
}

}  // namespace geomesh::geomodel

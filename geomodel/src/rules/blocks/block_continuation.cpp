// SPDX-License-Identifier: GPL-3.0-or-later
// Extends each block of a horizon on its own, declared in rules/blocks/throw_blocks.hpp. Parts of an extension that lie
// entirely beyond a fault are left out, since nearly equal extensions of all blocks would cross there and be cut off.
#include <algorithm>
#include <map>

#include "common/union_find.hpp"
#include "naming/sheets.hpp"
#include "rules/blocks/throw_blocks.hpp"
#include "rules/throw/fault_crossings.hpp"

namespace geomesh::geomodel {
namespace {

// Fraction of a block's area that must lie on one side of a fault for the fault to bound the block.
constexpr double nearly_all = 0.9;

/// For each fault, the side on which a block lies: 1 above, -1 below, 0 if the fault does not bound the block.
class BlockSides {
 public:
  BlockSides(const TriangulatedSurface& horizon, const std::vector<Index>& block, Index own,
             const std::vector<FaultSides>& faults)
      : faults_(faults), side_(faults.size(), 0) {
    const AreaSamples samples(horizon);
    for (std::size_t f = 0; f < faults.size(); ++f) {
      double above = 0, all = 0;
      for (std::size_t t = 0; t < block.size(); ++t) {
        if (block[t] != own) continue;
        samples.for_each(static_cast<Index>(t), [&](const Vec3& place, double area) {
          all += area;
          if (faults[f].is_above(place)) above += area;
        });
      }
      if (above >= nearly_all * all) side_[f] = 1;
      if (above <= (1 - nearly_all) * all) side_[f] = -1;
    }
  }
  bool is_beyond(const Vec3& p, std::size_t fault) const {
    return side_[fault] != 0 && faults_[fault].is_above(p) != (side_[fault] > 0);
  }
  bool is_beyond_any(const Vec3& p) const {
    for (std::size_t f = 0; f < side_.size(); ++f)
      if (is_beyond(p, f)) return true;
    return false;
  }
  std::size_t n_faults() const { return side_.size(); }

 private:
  const std::vector<FaultSides>& faults_;
  std::vector<int> side_;
};

using MapEdge = std::pair<VertexIndex, VertexIndex>;

template <class F>
void for_each_edge_of(const Triangle& v, F&& visit) {
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexIndex a = v[i], b = v[(i + 1) % 3];
    visit(MapEdge{std::min(a, b), std::max(a, b)});
  }
}

/// Returns the connected sets of triangles without a block that only block `own` surrounds. They lie around a fault
/// both of whose ends are inside the model, where no extension from the outer border arrives.
std::vector<Triangle> enclosed_by(const TriangulatedSurface& horizon, const std::vector<Index>& block, Index own) {
  const std::vector<Triangle> triangles = merged_triangles(horizon);
  const auto edges_of = [&](Index t, auto&& visit) {
    for_each_edge_of(triangles[t], [&](const MapEdge& e) {
      if (e.first != e.second) visit(e);
    });
  };
  std::map<MapEdge, Index> at_edge;  // triangles without a block, by edge
  UnionFind joined(block.size());
  std::map<MapEdge, bool> is_held;  // by the block
  for (Index t = 0; t < block.size(); ++t)
    edges_of(t, [&](const MapEdge& e) {
      if (block[t] == own || block[t] == BuiltRows::of_every_block) is_held[e] = true;
      if (block[t] != BuiltRows::of_no_block) return;
      const auto [at, is_new] = at_edge.emplace(e, t);
      if (!is_new) {
        joined.unite(at->second, t);
        is_held[e] = true;  // edges inside a set of triangles without a block
      }
    });
  std::map<Index, bool> is_enclosed;
  for (Index t = 0; t < block.size(); ++t) {
    if (block[t] != BuiltRows::of_no_block) continue;
    bool& all = is_enclosed.emplace(joined.find(t), true).first->second;
    edges_of(t, [&](const MapEdge& e) { all = all && is_held.count(e) > 0; });
  }
  std::vector<Triangle> enclosed;
  for (Index t = 0; t < block.size(); ++t)
    if (block[t] == BuiltRows::of_no_block && is_enclosed.at(joined.find(t))) enclosed.push_back(horizon.triangles[t]);
  return enclosed;
}

/// For each triangle from index `first` on, returns whether it lies entirely beyond a fault. All triangles connected
/// with it, without crossing another fault, must lie beyond the fault too, and none may be an original one of the
/// block.
std::vector<std::uint8_t> find_beyond(const TriangulatedSurface& part, std::size_t first,
                                      const std::vector<ThrowFault>& faults, const BlockSides& sides) {
  const std::size_t n = part.triangles.size() - first;
  const std::vector<Crossing> crossing = find_crossings(part, first, faults, everywhere);
  UnionFind joined(n + 1);  // entry n of the union-find stands for all original triangles of the block
  std::map<std::pair<VertexIndex, VertexIndex>, Index> at_edge;
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    const bool is_given = t < first;
    if (!is_given && crossing[t - first] != Crossing::none) continue;
    const auto own = static_cast<Index>(is_given ? n : t - first);
    const Triangle& v = part.triangles[t];
    if (is_given && sides.is_beyond_any(centre_of(part, v))) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexIndex a = v[i], b = v[(i + 1) % 3];
      const auto [at, is_new] = at_edge.emplace(std::pair(std::min(a, b), std::max(a, b)), own);
      if (!is_new) joined.unite(at->second, own);
    }
  }
  std::vector<std::uint8_t> beyond(n, 0);
  for (std::size_t f = 0; f < sides.n_faults(); ++f) {
    // For each connected set of triangles, whether all of them lie beyond the fault, by the set's representative.
    std::vector<std::uint8_t> is_all(n + 1, 1);
    is_all[joined.find(static_cast<Index>(n))] = 0;
    for (Index k = 0; k < n; ++k)
      if (!sides.is_beyond(centre_of(part, part.triangles[first + k]), f)) is_all[joined.find(k)] = 0;
    for (Index k = 0; k < n; ++k)
      if (crossing[k] == Crossing::none && is_all[joined.find(k)]) beyond[k] = 1;
  }
  return beyond;
}

}  // namespace

bool extend_blocks(TriangulatedSurface& horizon, std::vector<Index>& block, const BlockFaults& parting,
                   const BuildLog& log) {
  const std::vector<ThrowFault>& faults = parting.faults;
  if (block.empty()) return true;
  bool all_are_continued = true;
  const TriangulatedSurface given = horizon;
  const Index n_blocks = BuiltRows::n_blocks(block);
  const std::size_t n_sorted = block.size();
  const std::vector<Index> block_as_sorted = block;
  std::vector<FaultSides> fault_sides;
  for (const ThrowFault& fault : faults) fault_sides.emplace_back(*fault.surface);
  for (Index b = 0; b < n_blocks; ++b) {
    TriangulatedSurface part = given;
    part.triangles.clear();
    for (std::size_t t = 0; t < n_sorted; ++t)
      if (block[t] == b || block[t] == BuiltRows::of_every_block) part.triangles.push_back(given.triangles[t]);
    const std::size_t n_given = part.triangles.size();
    const std::vector<Triangle> enclosed = enclosed_by(given, block_as_sorted, b);
    part.triangles.insert(part.triangles.end(), enclosed.begin(), enclosed.end());
    all_are_continued = extend_to_box(part, parting.how, parting.box, log, {b}) && all_are_continued;
    const auto shift = static_cast<VertexIndex>(horizon.points.size() - given.points.size());
    horizon.points.insert(horizon.points.end(), part.points.begin() + static_cast<std::ptrdiff_t>(given.points.size()),
                          part.points.end());
    const std::vector<std::uint8_t> beyond =
        find_beyond(part, n_given, faults, BlockSides(given, block, b, fault_sides));
    for (std::size_t t = n_given; t < part.triangles.size(); ++t) {
      if (n_blocks > 1 && beyond[t - n_given]) continue;
      Triangle v = part.triangles[t];
      for (VertexIndex& row : v)
        if (row >= given.points.size()) row += shift;
      horizon.triangles.push_back(v);
      block.push_back(b);
    }
  }
  return all_are_continued;
}

}  // namespace geomesh::geomodel

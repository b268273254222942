// SPDX-License-Identifier: GPL-3.0-or-later
// Extends each block of a horizon on its own, declared in rules/blocks/throw_blocks.hpp. Parts of an extension that lie
// entirely beyond a fault are left out, since nearly equal extensions of all blocks would cross there and be cut off.
#include <algorithm>
#include <map>
#include <set>

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

using MapEdges = std::set<MapEdge>;

/// Returns the edges of the triangles that `counts` accepts.
template <class F>
MapEdges edges_of(const std::vector<Triangle>& triangles, F&& counts) {
  MapEdges edges;
  for (Index t = 0; t < triangles.size(); ++t)
    if (counts(t)) for_each_edge_of(triangles[t], [&](const MapEdge& e) { edges.insert(e); });
  return edges;
}

/// Returns the groups of connected triangles, among those that `counts` accepts, whose outer edges are all `held`.
template <class F>
std::vector<std::vector<Index>> enclosed_groups(const std::vector<Triangle>& triangles, const MapEdges& held,
                                                F&& counts) {
  const auto visit_edges = [&](Index t, auto&& visit) {
    for_each_edge_of(triangles[t], [&](const MapEdge& e) {
      if (e.first != e.second) visit(e);
    });
  };
  std::map<MapEdge, Index> at_edge;
  MapEdges inner;
  UnionFind joined(triangles.size());
  for (Index t = 0; t < triangles.size(); ++t)
    if (counts(t))
      visit_edges(t, [&](const MapEdge& e) {
        const auto [at, is_new] = at_edge.emplace(e, t);
        if (is_new) return;
        joined.unite(at->second, t);
        inner.insert(e);
      });
  std::map<Index, std::vector<Index>> groups;
  std::set<Index> open;
  for (Index t = 0; t < triangles.size(); ++t)
    if (counts(t)) {
      groups[joined.find(t)].push_back(t);
      visit_edges(t, [&](const MapEdge& e) {
        if (!held.contains(e) && !inner.contains(e)) open.insert(joined.find(t));
      });
    }
  std::vector<std::vector<Index>> enclosed;
  for (auto& [group, rows] : groups)
    if (!open.contains(group)) enclosed.push_back(std::move(rows));
  return enclosed;
}

/// Returns the connected sets of triangles without a block that only block `own` surrounds, where no extension from the
/// outer border arrives: those around a fault both of whose ends are inside the model, and those between the block and
/// the triangles that join it with other blocks beyond the tip of a fault.
std::vector<Triangle> enclosed_by(const TriangulatedSurface& horizon, const SortedBlocks& sorted, Index own) {
  TriangulatedSurface all = horizon;
  all.triangles.insert(all.triangles.end(), sorted.beside_joining.begin(), sorted.beside_joining.end());
  const std::vector<Triangle> triangles = merged_triangles(all);
  const std::vector<Index>& block = sorted.of_triangle;
  const auto n = static_cast<Index>(block.size());
  const auto is_own = [&](Index t) { return t < n && (block[t] == own || block[t] == BuiltRows::of_every_block); };
  const auto is_remade = [&](Index t) { return t < n && block[t] == BuiltRows::of_no_block; };
  const MapEdges held = edges_of(triangles, is_own);
  std::vector<Triangle> enclosed;
  for (const std::vector<Index>& group : enclosed_groups(triangles, held, is_remade))
    for (const Index t : group) enclosed.push_back(all.triangles[t]);
  const MapEdges joining = edges_of(triangles, [&](Index t) { return t >= sorted.first_joining && t < n; });
  const MapEdges remade = edges_of(triangles, is_remade);
  for (const std::vector<Index>& group : enclosed_groups(triangles, held, [&](Index t) { return t >= n; })) {
    bool joins = false, is_covered = false;
    for (const Index t : group)
      for_each_edge_of(triangles[t], [&](const MapEdge& e) {
        joins = joins || joining.contains(e);
        is_covered = is_covered || remade.contains(e);
      });
    if (!joins || is_covered) continue;
    for (const Index t : group) enclosed.push_back(all.triangles[t]);
  }
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
    // For each connected set of triangles, by its union-find root: whether all of them lie beyond the fault.
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

bool extend_blocks(TriangulatedSurface& horizon, SortedBlocks& sorted, const BlockFaults& parting,
                   const BuildLog& log) {
  const std::vector<ThrowFault>& faults = parting.faults;
  std::vector<Index>& block = sorted.of_triangle;
  if (block.empty()) return true;
  bool all_are_continued = true;
  const TriangulatedSurface given = horizon;
  const Index n_blocks = BuiltRows::n_blocks(block);
  const std::size_t n_sorted = block.size();
  const SortedBlocks as_sorted = sorted;
  std::vector<FaultSides> fault_sides;
  for (const ThrowFault& fault : faults) fault_sides.emplace_back(*fault.surface);
  for (Index b = 0; b < n_blocks; ++b) {
    TriangulatedSurface part = given;
    part.triangles.clear();
    for (std::size_t t = 0; t < n_sorted; ++t)
      if (block[t] == b || block[t] == BuiltRows::of_every_block) part.triangles.push_back(given.triangles[t]);
    const std::size_t n_given = part.triangles.size();
    const std::vector<Triangle> enclosed = enclosed_by(given, as_sorted, b);
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

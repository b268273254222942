// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/blocks/sheet_parts.hpp"

#include <algorithm>

#include "common/by_rounding.hpp"
#include "common/union_find.hpp"
#include "naming/sheets.hpp"
#include "rules/throw/sheets.hpp"

namespace geomesh::geomodel {

SheetParts::SheetParts(const TriangulatedSurface& horizon, const std::vector<Index>& sheet,
                       const SortingSetting& setting)
    : horizon_(horizon),
      setting_(setting),
      n_(static_cast<Index>(horizon.triangles.size())),
      triangles_(merged_triangles(horizon)),
      sheet_(sheet),
      meets_(n_, Meets::nothing),
      neighbours_(neighbours_in(horizon)) {
  for (const ThrowFault& fault : setting_.faults) find_what_they_meet(fault);
  if (sheet_.empty()) sheet_ = sheets_of(n_, neighbours_, [](Index, Index) { return true; });
  std::erase_if(neighbours_, [&](const auto& pair) {
    return sheet_[pair.first] != sheet_[pair.second] && !is_of_several(pair.first) && !is_of_several(pair.second);
  });
  add_fragments();
  find_ends();
  join_fragments();
}

bool SheetParts::touches_fault(Index t) const {
  return std::ranges::any_of(crossed_, [t](const auto& crossed) { return crossed[t] == Crossing::fault; });
}

SheetParts::Areas SheetParts::areas(const BlockFramework& finer) const {
  std::vector<Index> within;  // per block of the finer framework: that of the setting's
  for (Index b = 0; b < finer.n_blocks(); ++b) within.push_back(setting_.framework.block_at(finer.place_in(b)));
  Areas areas;
  Index last = no_index;
  for (Index t = 0; t < n_; ++t) {
    if (is_outside(t)) continue;
    if (is_whole(t)) {
      areas[part_[first_[t]]][finer.block_of(corners(t), last)] += fragments_[first_[t]].area;
      continue;
    }
    for (const auto& [block, area] : finer.areas(corners(t)))
      for (Index i = first_[t]; i < first_[t + 1]; ++i)
        if (fragments_[i].block == within[block]) areas[part_[i]][block] += area;
  }
  return areas;
}

void SheetParts::find_what_they_meet(const ThrowFault& fault) {
  crossed_.push_back(find_crossings(horizon_, 0, {fault}, everywhere));
  const std::vector<Crossing> in_box = find_crossings(horizon_, 0, {fault}, setting_.box);
  for (Index t = 0; t < n_; ++t) {
    if (crossed_.back()[t] != Crossing::none) meets_[t] = std::max(meets_[t], Meets::fault);
    if (in_box[t] == Crossing::continuation) meets_[t] = Meets::continuation;
  }
}

void SheetParts::add_fragments() {
  Index last = no_index;
  for (Index t = 0; t < n_; ++t) {
    first_.push_back(n_fragments());
    const double area = area_of(horizon_, t);
    reaches_outside_.push_back(false);
    if (meets_nothing(t)) {
      fragments_.push_back({t, setting_.framework.block_of(corners(t), last), area});
      continue;
    }
    double inside = 0;
    for (const auto& [block, size] : setting_.framework.areas(corners(t))) {
      if (size > by_rounding * area) fragments_.push_back({t, block, size});
      inside += size;
    }
    reaches_outside_.back() = inside < (1 - by_rounding) * area;
    if (first_.back() == n_fragments()) fragments_.push_back({t, no_index, area});
  }
  first_.push_back(n_fragments());
}

void SheetParts::find_ends() {
  std::map<std::pair<VertexIndex, VertexIndex>, int> n_at_edge;
  for (const Triangle& t : triangles_)
    for (std::size_t i = 0; i < 3; ++i) ++n_at_edge[std::minmax(t[i], t[(i + 1) % 3])];
  for (const auto& [edge, n] : n_at_edge)
    if (n == 1)
      for (const VertexIndex v : {edge.first, edge.second}) ends_[v];
  for (Index t = 0; t < n_; ++t)
    for (const VertexIndex v : triangles_[t])
      if (const auto at = ends_.find(v); at != ends_.end() && is_whole(t)) at->second.insert(block(t));
}

void SheetParts::join_fragments() {
  UnionFind joined(fragments_.size());
  std::vector<std::pair<Index, Index>> torn;  // fragments: what crosses a fault, and what crosses a continuation
  for (const auto& [t, other] : neighbours_) {
    const std::vector<VertexIndex> edge = shared(t, other);
    for (Index i = first_[t]; i < first_[t + 1]; ++i)
      for (Index j = first_[other]; j < first_[other + 1]; ++j) {
        if (!hang_together(fragments_[i], fragments_[j], edge)) continue;
        if (sheet_[t] != sheet_[other])
          beside_.emplace_back(i, j);
        else if (are_beside_end(t, other) && may_be_torn(edge, fragments_[i].block))
          torn.push_back(meets_[t] == Meets::fault ? std::pair(i, j) : std::pair(j, i));
        else
          joined.unite(i, j);
      }
  }
  // What crosses the fault beside a tear overshoots, unless it hangs together with whole triangles of the block.
  std::set<Index> has_whole;
  for (Index t = 0; t < n_; ++t)
    if (is_whole(t)) has_whole.insert(joined.find(first_[t]));
  std::erase_if(torn, [&](const auto& pair) { return !has_whole.contains(joined.find(pair.first)); });
  for (const auto& [i, j] : torn) joined.unite(i, j);
  for (Index i = 0; i < n_fragments(); ++i) part_.push_back(joined.find(i));
}

bool SheetParts::hang_together(const Fragment& a, const Fragment& b, const std::vector<VertexIndex>& edge) const {
  if (a.block != b.block || edge.size() < 2) return false;
  if (a.block == no_index) return meets_[a.triangle] == meets_[b.triangle];
  if (is_whole(a.triangle) && is_whole(b.triangle)) return true;
  return setting_.framework.blocks_on(horizon_.points[edge[0]], horizon_.points[edge[1]]).contains(a.block);
}

bool SheetParts::are_beside_end(Index t, Index other) const {
  const auto crosses_fault = [&](Index s) { return meets_[s] == Meets::fault && !is_whole(s); };
  const auto meets_continuation = [&](Index s) { return meets_[s] == Meets::continuation; };
  return (crosses_fault(t) && meets_continuation(other)) || (crosses_fault(other) && meets_continuation(t));
}

bool SheetParts::may_be_torn(const std::vector<VertexIndex>& edge, Index block) const {
  return std::ranges::any_of(edge, [&](VertexIndex v) {
    const auto at = ends_.find(v);
    return at != ends_.end() && at->second.contains(block) && setting_.framework.block_at(horizon_.points[v]) == block;
  });
}

std::vector<VertexIndex> SheetParts::shared(Index t, Index other) const {
  std::vector<VertexIndex> shared;
  for (const VertexIndex v : triangles_[t])
    if (std::ranges::count(triangles_[other], v) > 0) shared.push_back(v);
  return shared;
}

}  // namespace geomesh::geomodel

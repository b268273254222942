// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/blocks/sheet_parts.hpp"

#include <algorithm>

#include "common/by_rounding.hpp"
#include "common/union_find.hpp"
#include "rules/throw/sheets.hpp"

namespace geomesh::geomodel {

SheetParts::SheetParts(const TriangulatedSurface& horizon, const std::vector<Index>& sheet,
                       const SortingSetting& setting)
    : horizon_(horizon),
      setting_(setting),
      n_(static_cast<Index>(horizon.triangles.size())),
      sheet_(sheet),
      meets_(n_, Meets::nothing),
      neighbours_(neighbours_in(horizon)) {
  for (const ThrowFault& fault : setting_.faults) find_what_they_meet(fault);
  if (sheet_.empty()) sheet_ = sheets_of(n_, neighbours_, [](Index, Index) { return true; });
  std::erase_if(neighbours_, [&](const auto& pair) {
    return sheet_[pair.first] != sheet_[pair.second] && !is_of_several(pair.first) && !is_of_several(pair.second);
  });
  add_fragments();
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
    if (meets_nothing(t)) {
      fragments_.push_back({t, setting_.framework.block_of(corners(t), last), area});
      continue;
    }
    for (const auto& [block, size] : setting_.framework.areas(corners(t)))
      if (size > by_rounding * area) fragments_.push_back({t, block, size});
    if (first_.back() == n_fragments()) fragments_.push_back({t, no_index, area});
  }
  first_.push_back(n_fragments());
}

void SheetParts::join_fragments() {
  UnionFind joined(fragments_.size());
  for (const auto& [t, other] : neighbours_) {
    const bool are_whole = is_whole(t) && is_whole(other);
    const std::set<Index> blocks = are_whole ? std::set<Index>{block(t)} : blocks_of_edge(t, other);
    for (Index i = first_[t]; i < first_[t + 1]; ++i)
      for (Index j = first_[other]; j < first_[other + 1]; ++j) {
        if (!hang_together(fragments_[i], fragments_[j], blocks)) continue;
        if (sheet_[t] == sheet_[other])
          joined.unite(i, j);
        else
          beside_.emplace_back(i, j);
      }
  }
  for (Index i = 0; i < n_fragments(); ++i) part_.push_back(joined.find(i));
}

std::set<Index> SheetParts::blocks_of_edge(Index t, Index other) const {
  std::vector<Vec3> ends;
  const std::array<Vec3, 3> of_other = corners(other);
  for (const Vec3& p : corners(t))
    if (std::ranges::count(of_other, p) > 0) ends.push_back(p);
  return ends.size() < 2 ? std::set<Index>{} : setting_.framework.blocks_on(ends[0], ends[1]);
}

}  // namespace geomesh::geomodel

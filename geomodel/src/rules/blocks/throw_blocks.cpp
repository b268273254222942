// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/blocks/throw_blocks.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "common/union_find.hpp"
#include "rules/blocks/sheet_parts.hpp"

namespace geomesh::geomodel {
namespace {

/// What is larger than others at one place.
template <class At>
class Largest {
 public:
  void add(const At& at, Index part, double area) {
    const auto [found, is_new] = largest_.emplace(at, std::pair(part, area));
    if (area > found->second.second) found->second = {part, area};
  }
  Index at(const At& at) const { return largest_.at(at).first; }
  const std::map<At, std::pair<Index, double>>& all() const { return largest_; }

 private:
  std::map<At, std::pair<Index, double>> largest_;
};

/// Decides which parts of sheets count.
class Sorting {
 public:
  Sorting(const SheetParts& parts, const SortingSetting& setting) : parts_(parts) {
    const SheetParts::Areas areas = parts_.areas(setting.framework);
    find_those_that_count(areas);
    if (std::ranges::all_of(areas, [&](const auto& entry) { return counts_.contains(entry.first); })) return;
    counts_.clear();  // a fault that the list lacks may lie between a part and the sheet that has most of its block
    find_those_that_count(parts_.areas(setting.framework_of_all()));
  }

  SortedTriangles sorted(std::size_t n_faults) {
    SortedTriangles sorted{std::vector<Index>(parts_.n(), BuiltRows::of_every_block),
                           std::vector<bool>(parts_.n(), false), std::vector<bool>(n_faults, false)};
    for (Index t = 0; t < parts_.n(); ++t) {
      const std::set<Index> blocks = blocks_of(t);
      if (blocks.size() == 1) sorted.block[t] = *blocks.begin();
      if (blocks.empty() && !parts_.is_outside(t)) sorted.overshoots[t] = true;
      for (std::size_t f = 0; f < n_faults; ++f)
        if (blocks.size() > 1 && parts_.touches(t, f)) sorted.runs_across[f] = true;
    }
    sort_outside(sorted);
    for_each_pair_at_fault([&](Index t, Index other) {
      for (std::size_t f = 0; f < n_faults; ++f)
        if (!blocks_of(t).empty() && !blocks_of(other).empty() && parts_.touches(t, f) && parts_.touches(other, f))
          sorted.runs_across[f] = true;
    });
    return sorted;
  }

 private:
  /// The blocks in which the parts of a triangle count.
  std::set<Index> blocks_of(Index t) const {
    std::set<Index> blocks;
    for (Index i = parts_.first_fragment(t); i < parts_.first_fragment(t + 1); ++i)
      if (counts_.contains(parts_.part(i))) blocks.insert(parts_.fragment(i).block);
    return blocks;
  }

  /// A part outside of the model overshoots where what it meets of whole triangles does.
  void sort_outside(SortedTriangles& sorted) const {
    std::map<Index, bool> overshoots;  // by part outside
    const auto part_of = [&](Index t) { return parts_.part(parts_.first_fragment(t)); };
    parts_.for_each_neighbour([&](Index t, Index other) {
      if (!parts_.is_outside(t) || !parts_.is_whole(other) || parts_.is_outside(other)) return;
      bool& alone = overshoots.emplace(part_of(t), true).first->second;
      alone = alone && sorted.overshoots[other];
    });
    for (Index t = 0; t < parts_.n(); ++t)
      if (parts_.is_outside(t) && parts_.meets_nothing(t))
        if (const auto at = overshoots.find(part_of(t)); at != overshoots.end()) sorted.overshoots[t] = at->second;
    sort_strips_outside(sorted);
  }

  /// What crosses a fault outside of the model, in part or whole, is of the block that the triangles have that cross it
  /// inside of the model and hang together with it, or that are beside it.
  void sort_strips_outside(SortedTriangles& sorted) const {
    UnionFind strip(parts_.n());
    parts_.for_each_neighbour([&](Index t, Index other) {
      const bool both_meet = !parts_.meets_nothing(t) && !parts_.meets_nothing(other);
      if (both_meet && parts_.meets_fault(t) == parts_.meets_fault(other)) strip.unite(t, other);
    });
    std::map<Index, std::set<Index>> blocks;  // by strip
    parts_.for_each_neighbour([&](Index t, Index other) {
      if (!parts_.meets_nothing(t)) blocks[strip.find(t)].merge(blocks_of(other));
    });
    for (Index t = 0; t < parts_.n(); ++t) {
      if (parts_.meets_nothing(t) || !parts_.reaches_outside(t) || !blocks_of(t).empty()) continue;
      const std::set<Index>& at = blocks[strip.find(t)];
      if (at.size() == 1) sorted.block[t] = *at.begin();
      sorted.overshoots[t] = at.empty();
    }
  }

  /// Calls visit(t, other) for triangles that lie in different blocks, with an edge on a fault between them.
  template <class F>
  void for_each_pair_at_fault(F&& visit) const {
    parts_.for_each_neighbour([&](Index t, Index other) {
      if (parts_.block(t) != no_index && parts_.block(other) != no_index && parts_.block(t) != parts_.block(other))
        visit(t, other);
    });
  }

  Index sheet_of(Index part) const { return parts_.sheet(parts_.fragment(part).triangle); }
  bool is_of_several(Index part) const { return parts_.is_of_several(parts_.fragment(part).triangle); }

  void find_those_that_count(const SheetParts::Areas& areas) {
    find_those_that_have_blocks(areas);
    find_largest_across_faults(areas);
    std::map<Index, bool> counts;  // by part of several sheets: whether one beside it does
    for (const auto& [i, j] : parts_.beside())
      for (const auto& [own, other] : {std::pair(i, j), std::pair(j, i)})
        if (is_of_several(parts_.part(own)))
          counts[parts_.part(own)] = counts[parts_.part(own)] || counts_.contains(parts_.part(other));
    for (const auto& [part, _] : areas)
      if (is_of_several(part) && (!counts.contains(part) || counts.at(part))) counts_.insert(part);
  }

  /// The parts that have most of their area in blocks in which they are the largest of the sheet that has most there.
  void find_those_that_have_blocks(const SheetParts::Areas& all) {
    std::map<Index, std::map<Index, double>> sheets;  // area by block and sheet
    for (const auto& [part, areas] : all)
      for (const auto& [block, area] : areas)
        if (!is_of_several(part)) sheets[block][sheet_of(part)] += area;
    Largest<Index> owner, largest;
    for (const auto& [block, area] : sheets)
      for (const auto& [sheet, size] : area) owner.add(block, sheet, size);
    for (const auto& [part, areas] : all)
      for (const auto& [block, area] : areas)
        if (!is_of_several(part) && owner.at(block) == sheet_of(part)) largest.add(block, part, area);
    for (const auto& [part, areas] : all) {
      double own = 0, others = 0;
      for (const auto& [block, area] : areas)
        if (!is_of_several(part)) (largest.at(block) == part ? own : others) += area;
      if (own > others) counts_.insert(part);
    }
  }

  /// Of parts that hang together across faults the largest that has a triangle that nothing cuts. A part of cut
  /// triangles alone may be overshoot, even where it hangs together with nothing.
  void find_largest_across_faults(const SheetParts::Areas& all) {
    UnionFind linked(parts_.n_fragments());
    for (Index t = 0; t < parts_.n(); ++t)
      for (Index i = parts_.first_fragment(t) + 1; i < parts_.first_fragment(t + 1); ++i)
        if (parts_.meets_fault(t)) linked.unite(parts_.part(i - 1), parts_.part(i));
    for_each_pair_at_fault([&](Index t, Index other) {
      if (parts_.touches_fault(t) && parts_.touches_fault(other))
        linked.unite(parts_.part(parts_.first_fragment(t)), parts_.part(parts_.first_fragment(other)));
    });
    std::set<Index> has_whole;
    for (Index t = 0; t < parts_.n(); ++t)
      if (parts_.is_whole(t)) has_whole.insert(parts_.part(parts_.first_fragment(t)));
    Largest<Index> largest;
    for (const auto& [part, areas] : all) {
      double area = 0;
      for (const auto& [_, size] : areas) area += size;
      if (!is_of_several(part) && has_whole.contains(part)) largest.add(linked.find(part), part, area);
    }
    for (const auto& [_, part] : largest.all()) counts_.insert(part.first);
  }

  const SheetParts& parts_;
  std::set<Index> counts_;  ///< parts
};

}  // namespace

std::shared_ptr<const HorizonBlocks> blocks_between(const BuiltSurfaces& built, const ModelRules& rules,
                                                    const std::vector<Index>& faults) {
  BuiltSurfaces alone = built;
  for (Index s = 0; s < alone.surfaces.size(); ++s)
    if (!std::ranges::binary_search(faults, s)) {
      alone.surfaces[s].triangles.clear();
      alone.rows.part_of_triangle[s].clear();
    }
  alone.rows.truncations.clear();
  alone.rows.overshooting.clear();
  return std::make_shared<HorizonBlocks>(HorizonBlocks{BlockFramework(alone, rules),
                                                       Walls(alone.surfaces, faults, {}),
                                                       Walls(alone.surfaces, faults, rules.continuation.sides),
                                                       {}});
}

SortedTriangles sort_into_blocks(const TriangulatedSurface& horizon, const std::vector<Index>& sheet,
                                 const SortingSetting& setting) {
  const SheetParts parts(horizon, sheet, setting);
  return Sorting(parts, setting).sorted(setting.faults.size());
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/blocks/throw_blocks.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "common/by_rounding.hpp"
#include "common/union_find.hpp"
#include "naming/region_facts.hpp"
#include "naming/sheets.hpp"
#include "rules/throw/sheets.hpp"

namespace geomesh::geomodel {
namespace {

/// What a triangle meets.
enum class Meets : std::uint8_t { nothing, fault, continuation };

/// The parts of a horizon's sheets: triangles that hang together and meet alike what ends blocks. Free ones meet
/// nothing, and lie in one block each; the others are places at faults.
class SheetParts {
 public:
  SheetParts(const TriangulatedSurface& horizon, const std::vector<Index>& sheet, const SortingSetting& setting)
      : horizon_(horizon), setting_(setting), n_(static_cast<Index>(horizon.triangles.size())) {
    find_what_they_meet(sheet);
    Index last = no_index;
    for (Index t = 0; t < n_; ++t)
      own_block_.push_back(is_free(t) ? setting_.framework.block_of(corners(t), last) : no_index);
    const auto pairs = neighbours_in(horizon);
    sheet_ = sheet.empty() ? sheets_of(n_, pairs, [](Index, Index) { return true; }) : sheet;
    for (const auto& [a, b] : pairs)
      if (sheet_[a] == sheet_[b] || sheet_[a] == BuiltRows::of_every_block || sheet_[b] == BuiltRows::of_every_block)
        neighbours_.emplace_back(a, b);
    part_ = sheets_of(n_, neighbours_, [&](Index a, Index b) {
      return sheet_[a] == sheet_[b] && meets_[a] == meets_[b] && own_block_[a] == own_block_[b];
    });
    measure();
  }

  Index n() const { return n_; }
  bool is_free(Index t) const { return meets_[t] == Meets::nothing; }
  bool meets_fault(Index t) const { return meets_[t] == Meets::fault; }
  /// Whether a triangle crosses a fault as given, or touches it.
  bool crosses(Index t, std::size_t fault) const { return crossed_[fault][t] == Crossing::fault; }
  bool touches_fault(Index t) const {
    return std::ranges::any_of(crossed_, [t](const auto& crossed) { return crossed[t] == Crossing::fault; });
  }
  Index part(Index t) const { return part_[t]; }    ///< the first of its triangles
  Index sheet(Index t) const { return sheet_[t]; }  ///< BuiltRows::of_every_block: of several
  /// The block in which a free triangle lies; no_index for others and outside of the model.
  Index block(Index t) const { return own_block_[t]; }
  /// Pairs of triangles of one sheet, each way.
  template <class F>
  void for_each_neighbour(F&& visit) const {
    for (const auto& [a, b] : neighbours_) visit(a, b), visit(b, a);
  }
  /// By part its area in each block.
  const std::map<Index, std::map<Index, double>>& areas() const { return areas_; }

 private:
  void find_what_they_meet(const std::vector<Index>& sheet) {
    meets_.assign(n_, Meets::nothing);
    for (const ThrowFault& fault : setting_.faults) {
      crossed_.push_back(find_crossings(horizon_, 0, {fault}, everywhere));
      const std::vector<Crossing> in_box = find_crossings(horizon_, 0, {fault}, setting_.box);
      for (Index t = 0; t < n_; ++t) {
        if (crossed_.back()[t] != Crossing::none) meets_[t] = std::max(meets_[t], Meets::fault);
        if (in_box[t] == Crossing::continuation) meets_[t] = Meets::continuation;
      }
    }
    for (Index t = 0; t < n_; ++t)
      if (meets_[t] != Meets::nothing && lies_in_one_block(t)) meets_[t] = Meets::nothing;
    for (Index t = 0; t < sheet.size(); ++t)
      if (sheet[t] == BuiltRows::of_every_block) meets_[t] = Meets::continuation;
  }

  /// A triangle in the model that only touches a fault, or crosses what of it goes on beyond the surface on which it
  /// ends.
  bool lies_in_one_block(Index t) const {
    const std::map<Index, double> areas = areas_of(t);
    return areas.size() == 1 && areas.begin()->second >= (1 - by_rounding) * area_of(horizon_, t);
  }
  std::map<Index, double> areas_of(Index t) const {
    std::map<Index, double> areas = setting_.framework.areas(corners(t));
    std::erase_if(areas, [least = by_rounding * area_of(horizon_, t)](const auto& e) { return e.second <= least; });
    return areas;
  }
  std::array<Vec3, 3> corners(Index t) const {
    const Triangle& v = horizon_.triangles[t];
    return {horizon_.points[v[0]], horizon_.points[v[1]], horizon_.points[v[2]]};
  }

  void measure() {
    for (Index t = 0; t < n_; ++t) {
      std::map<Index, double>& area = areas_[part_[t]];
      if (own_block_[t] != no_index) area[own_block_[t]] += area_of(horizon_, t);
      if (is_free(t)) continue;
      for (const auto& [block, size] : areas_of(t)) area[block] += size;
    }
  }

  const TriangulatedSurface& horizon_;
  SortingSetting setting_;
  Index n_;
  std::vector<Index> sheet_, part_;  ///< per triangle, like own_block_ and meets_
  std::vector<Index> own_block_;
  std::vector<Meets> meets_;
  std::vector<std::pair<Index, Index>> neighbours_;
  std::vector<std::vector<Crossing>> crossed_;      ///< per fault and triangle
  std::map<Index, std::map<Index, double>> areas_;  ///< by part and block
};

/// What is larger than others at one place.
template <class At>
class Largest {
 public:
  void add(const At& at, Index part, double area) {
    const auto [found, is_new] = largest_.emplace(at, std::pair(part, area));
    if (area > found->second.second) found->second = {part, area};
  }
  bool has(const At& at) const { return largest_.contains(at); }
  Index part(const At& at) const { return largest_.at(at).first; }
  const std::map<At, std::pair<Index, double>>& all() const { return largest_; }

 private:
  std::map<At, std::pair<Index, double>> largest_;
};

/// The parts on their way to their blocks.
class Sorting {
 public:
  explicit Sorting(const SheetParts& parts) : parts_(parts) {
    std::map<Index, std::map<Index, double>> of_sheet;  // by block
    for (const auto& [part, areas] : parts.areas())
      for (const auto& [block, size] : areas) {
        if (parts.sheet(part) != BuiltRows::of_every_block) of_sheet[block][parts.sheet(part)] += size;
        if (parts.is_free(part)) largest_in_block_.add({block, parts.sheet(part)}, part, size);
      }
    for (const auto& [block, sheets] : of_sheet)
      sheet_of_block_[block] =
          std::ranges::max_element(sheets, {}, [](const auto& entry) { return entry.second; })->first;
    find_those_that_count();
  }

  SortedTriangles sorted(std::size_t n_faults) {
    SortedTriangles sorted{std::vector<Index>(parts_.n(), BuiltRows::of_every_block),
                           std::vector<bool>(parts_.n(), false), std::vector<bool>(n_faults, false)};
    const std::map<Index, std::set<Index>> blocks = blocks_of_places();
    for (Index t = 0; t < parts_.n(); ++t) {
      const Index part = parts_.part(t);
      if (parts_.is_free(t)) {
        if (parts_.block(t) != no_index) sorted.overshoots[t] = !counts_.contains(part);
        if (counts_.contains(part)) sorted.block[t] = parts_.block(t);
        continue;
      }
      const std::set<Index>& at = blocks.at(part);
      if (at.size() == 1) sorted.block[t] = *at.begin();
      if (at.empty()) sorted.overshoots[t] = true;
      for (std::size_t f = 0; f < n_faults; ++f)
        if (at.size() > 1 && parts_.crosses(t, f)) sorted.runs_across[f] = true;
    }
    leave_out_beside(sorted.overshoots);
    for_each_pair_at_fault([&](Index t, Index other) {
      for (std::size_t f = 0; f < n_faults; ++f)
        if (counts_.contains(parts_.part(t)) && counts_.contains(parts_.part(other)) && parts_.crosses(t, f) &&
            parts_.crosses(other, f))
          sorted.runs_across[f] = true;
    });
    return sorted;
  }

 private:
  /// What lies outside of the model and hangs together with overshoot alone overshoots, too.
  void leave_out_beside(std::vector<bool>& overshoots) const {
    std::map<Index, bool> all;  // by part outside
    const auto is_outside = [&](Index t) { return parts_.is_free(t) && parts_.block(t) == no_index; };
    parts_.for_each_neighbour([&](Index t, Index other) {
      if (!is_outside(t) || !parts_.is_free(other) || is_outside(other)) return;
      bool& alone = all.emplace(parts_.part(t), true).first->second;
      alone = alone && overshoots[other];
    });
    for (Index t = 0; t < parts_.n(); ++t)
      if (const auto at = all.find(parts_.part(t)); at != all.end() && at->second) overshoots[t] = true;
  }

  /// Free triangles with an edge on a fault between them.
  template <class F>
  void for_each_pair_at_fault(F&& visit) const {
    parts_.for_each_neighbour([&](Index t, Index other) {
      if (parts_.block(t) != no_index && parts_.block(other) != no_index && parts_.block(t) != parts_.block(other))
        visit(t, other);
    });
  }

  void find_those_that_count() {
    UnionFind linked(parts_.n());   // across faults
    std::map<Index, Index> beside;  // by place a free part
    parts_.for_each_neighbour([&](Index t, Index other) {
      if (!parts_.meets_fault(t) || parts_.block(other) == no_index) return;
      const auto [at, is_new] = beside.emplace(parts_.part(t), parts_.part(other));
      if (!is_new) linked.unite(at->second, parts_.part(other));
    });
    for_each_pair_at_fault([&](Index t, Index other) {
      if (parts_.touches_fault(t) && parts_.touches_fault(other)) linked.unite(parts_.part(t), parts_.part(other));
    });
    Largest<Index> largest;
    for (const auto& [part, areas] : parts_.areas())
      if (parts_.block(part) != no_index) largest.add(linked.find(part), part, areas.at(parts_.block(part)));
    for (const auto& [_, part] : largest.all()) counts_.insert(part.first);
    for (const auto& [block, sheet] : sheet_of_block_)
      if (largest_in_block_.has({block, sheet})) counts_.insert(largest_in_block_.part({block, sheet}));
  }

  /// By place at faults: the blocks of the parts that count beside it, and those in which all of its sheet meets faults
  /// and is more than any other sheet. One beside no part is of the block in which most of it lies.
  std::map<Index, std::set<Index>> blocks_of_places() {
    std::map<Index, std::set<Index>> blocks;
    std::set<Index> is_beside;  // a free part, whether it counts or not
    for (Index t = 0; t < parts_.n(); ++t)
      if (!parts_.is_free(t)) blocks[parts_.part(t)];
    parts_.for_each_neighbour([&](Index t, Index other) {
      if (parts_.is_free(t) || !parts_.is_free(other)) return;
      is_beside.insert(parts_.part(t));
      if (counts_.contains(parts_.part(other))) blocks[parts_.part(t)].insert(parts_.block(other));
    });
    for (auto& [place, at] : blocks) {
      const std::map<Index, double>& areas = parts_.areas().at(place);
      const Index sheet = parts_.sheet(place);
      for (const auto& [block, _] : areas)
        if (sheet_of_block_.contains(block) && sheet_of_block_.at(block) == sheet &&
            !largest_in_block_.has({block, sheet}))
          at.insert(block);
      if (!is_beside.contains(place) && !areas.empty())
        at.insert(std::ranges::max_element(areas, {}, [](const auto& entry) { return entry.second; })->first);
    }
    return blocks;
  }

  const SheetParts& parts_;
  std::map<Index, Index> sheet_of_block_;              ///< that of which most lies in the block
  Largest<std::pair<Index, Index>> largest_in_block_;  ///< of free parts, by block and sheet
  std::set<Index> counts_;                             ///< free parts
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
  return Sorting(parts).sorted(setting.faults.size());
}

}  // namespace geomesh::geomodel

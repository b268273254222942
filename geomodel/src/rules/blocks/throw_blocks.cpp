// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/blocks/throw_blocks.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "common/union_find.hpp"
#include "naming/region_facts.hpp"
#include "naming/sheets.hpp"
#include "naming/sums.hpp"
#include "rules/planar/map_locator.hpp"
#include "rules/throw/fault_crossings.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Fraction of the greatest throw that may remain at the end of a fault without a warning.
constexpr double most_throw_left = 0.5;
constexpr double much_alone = 0.02;  // fraction of the horizon's area in the box that may belong to no fault block

bool is_in(const Box3& box, const Vec3& p) {
  return p.x >= box.min.x && p.y >= box.min.y && p.z >= box.min.z && p.x <= box.max.x && p.y <= box.max.y &&
         p.z <= box.max.z;
}

/// Assigns triangles to blocks, by the sides of the faults on which most of the area of their connected part lies.
/// Triangles that `counts` does not accept have no block.
template <class F>
SortedBlocks blocks_of_sheets(const TriangulatedSurface& horizon, const std::vector<Index>& sheet,
                              const std::vector<ThrowFault>& faults, F&& counts) {
  // For each connected part of the horizon and each fault: area of the part above the fault minus its area below.
  std::map<Index, std::vector<double>> balance;
  std::vector<FaultSides> sides;
  for (const ThrowFault& fault : faults) sides.emplace_back(*fault.surface);
  const AreaSamples samples(horizon);
  for (Index t = 0; t < sheet.size(); ++t) {
    if (!counts(t)) continue;
    auto& sums = balance.try_emplace(sheet[t], faults.size(), 0.0).first->second;
    samples.for_each(t, [&](const Vec3& place, double area) {
      for (std::size_t f = 0; f < sides.size(); ++f) sums[f] += sides[f].is_above(place) ? area : -area;
    });
  }
  std::map<std::vector<bool>, Index> block_of_sides;
  SortedBlocks blocks{std::vector<Index>(sheet.size(), BuiltRows::of_no_block)};
  for (Index t = 0; t < sheet.size(); ++t) {
    if (!counts(t)) continue;
    std::vector<bool> key;
    for (const double sum : balance.at(sheet[t])) key.push_back(sum > 0);
    const auto [at, is_new] = block_of_sides.emplace(key, static_cast<Index>(block_of_sides.size()));
    blocks.of_triangle[t] = at->second;
    if (is_new) blocks.sides.push_back(std::move(key));
  }
  return blocks;
}

/// The parts into which the faults that end inside the model cut the connected parts ("wholes") of a horizon.
class Ends {
 public:
  Ends(const TriangulatedSurface& horizon, const BlockFaults& parting)
      : horizon_(horizon),
        neighbours_(neighbours_in(horizon)),
        crossing_(find_crossings(horizon, 0, parting.faults, everywhere)),
        in_box_(find_crossings(horizon, 0, parting.faults, parting.box)) {
    const std::size_t n = horizon.triangles.size();
    whole_ = sheets_of(n, neighbours_, [](Index, Index) { return true; });
    part_ = sheets_of(n, neighbours_, [this](Index a, Index b) { return is_free(a) && is_free(b); });
    find_kept();
    attach_overshoot();
  }
  const std::vector<Index>& parts() const { return part_; }
  /// Returns whether the triangle is kept: it belongs to the largest part of its connected part of the horizon, to a
  /// part that continues around a fault's tip, or to a group that crosses a fault beside at most one kept part.
  bool is_kept(Index t) const { return counts_[t] != 0; }
  /// Returns whether the triangle crosses a fault and does not lie around a fault's tip.
  bool is_overshoot(Index t) const { return !is_free(t) && !goes_round(t); }
  /// Returns whether the triangle lies around a fault's tip inside the box.
  bool goes_round(Index t) const { return in_box_[t] == Crossing::continuation; }

 private:
  bool is_free(Index t) const { return crossing_[t] == Crossing::none; }
  void find_kept() {
    std::map<Index, double> area;
    for (Index t = 0; t < part_.size(); ++t)
      if (is_free(t)) area[part_[t]] += area_of(horizon_, t);
    std::map<Index, Index> largest;  // largest piece that faults leave of each connected part of the horizon
    for (const auto& [part, size] : area) {
      kept_[part] = false;
      const auto [at, is_new] = largest.emplace(whole_[part], part);
      if (!is_new && size > area.at(at->second)) at->second = part;
    }
    for (const auto& [sheet, part] : largest) kept_[part] = true;
    for (const auto& [a, b] : neighbours_) {
      if (is_free(a) && goes_round(b)) kept_[part_[a]] = true;
      if (is_free(b) && goes_round(a)) kept_[part_[b]] = true;
    }
  }

  /// Assigns triangles that cross faults, except around a tip, in connected groups. A group beside one kept part is an
  /// overshoot of that part, and is cut off at the fault later. A group beside no kept part is a part of its own, as
  /// where the horizon is as narrow as its triangles. A group between two kept parts is a ramp, and is replaced.
  void attach_overshoot() {
    const std::size_t n = part_.size();
    const auto is_of_a_place = [this](Index t) { return is_overshoot(t); };
    UnionFind joined(n);
    for (const auto& [a, b] : neighbours_)
      if (is_of_a_place(a) && is_of_a_place(b)) joined.unite(a, b);
    std::map<Index, std::set<Index>> beside;  // the horizon's kept parts beside each group of triangles across faults
    for (const auto& [a, b] : neighbours_)
      for (const auto& [at, other] : {std::pair(a, b), std::pair(b, a)})
        if (is_of_a_place(at) && is_free(other) && kept_.at(part_[other])) beside[joined.find(at)].insert(part_[other]);
    counts_.resize(n);
    for (Index t = 0; t < n; ++t) {
      if (!is_of_a_place(t)) {
        counts_[t] = is_free(t) && kept_.at(part_[t]);
        continue;
      }
      const Index place = joined.find(t);
      const auto parts = beside.find(place);
      counts_[t] = parts == beside.end() || parts->second.size() == 1;
      if (counts_[t]) part_[t] = parts == beside.end() ? place : *parts->second.begin();
    }
  }

  const TriangulatedSurface& horizon_;
  std::vector<std::pair<Index, Index>> neighbours_;
  std::vector<std::uint8_t> counts_;  ///< per triangle
  std::vector<Crossing> crossing_, in_box_;
  std::vector<Index> whole_, part_;
  std::map<Index, bool> kept_;
};

/// Returns the largest height difference along those edges of the triangle that cross a fault or its extension.
double throw_across(const TriangulatedSurface& horizon, const Triangle& t, const std::vector<ThrowFault>& faults,
                    const Box3& box) {
  TriangulatedSurface edge{};
  edge.triangles = {{0, 1, 2}};
  double greatest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &p = horizon.points[t[i]], &q = horizon.points[t[(i + 1) % 3]];
    edge.points = {p, q, p};
    if (find_crossings(edge, 0, faults, box).front() != Crossing::none)
      greatest = std::max(greatest, std::abs(p.z - q.z));
  }
  return greatest;
}

/// Reports how much throw remains at the ends of the faults, where the blocks are joined.
void tell_throw(const TriangulatedSurface& horizon, std::size_t n_joining, double at_end, double greatest,
                const BuildLog& log) {
  const std::string what = "horizon " + horizon.name + ": its blocks are joined beyond the end of its faults by " +
                           std::to_string(n_joining) + " triangles (throw left there: at most " + to_text(at_end) +
                           " m)";
  if (at_end > most_throw_left * greatest) {
    log.warnings.push_back(what + "; the throw does not die out towards the end (it is at most " + to_text(greatest) +
                           " m elsewhere): should the fault reach further (extent: to_box)?");
  } else {
    log.notes.push_back(what);
  }
}

/// Extends the surface of all blocks, and appends its new triangles around the tips of faults to the horizon.
void join_round_ends(TriangulatedSurface& horizon, SortedBlocks& sorted, TriangulatedSurface joint,
                     const BlockFaults& parting, const BuildLog& log) {
  std::vector<std::string> notes, warnings;
  const std::size_t n_kept = joint.triangles.size();
  fill_holes(joint, infinite, {notes, warnings});
  extend_to_box(joint, parting.how, parting.box, {notes, warnings}, {0, false});
  if (!warnings.empty())
    log.warnings.push_back("horizon " + horizon.name + ", about the end of its faults: " + warnings.front());
  const std::vector<Crossing> crossing = find_crossings(joint, n_kept, parting.faults, parting.box);
  const std::size_t first = horizon.triangles.size();
  sorted.first_joining = static_cast<Index>(first);
  horizon.points = joint.points;
  double at_end = 0, greatest = 0;
  for (std::size_t k = 0; k < crossing.size(); ++k) {
    const Triangle& t = joint.triangles[n_kept + k];
    if (crossing[k] != Crossing::continuation) sorted.beside_joining.push_back(t);
    if (crossing[k] == Crossing::none) continue;
    const double across = throw_across(joint, t, parting.faults, parting.box);
    greatest = std::max(greatest, across);
    if (crossing[k] != Crossing::continuation) continue;
    at_end = std::max(at_end, across);
    horizon.triangles.push_back(t);
    sorted.of_triangle.push_back(BuiltRows::of_every_block);
  }
  if (horizon.triangles.size() > first) tell_throw(horizon, horizon.triangles.size() - first, at_end, greatest, log);
}

}  // namespace

bool lies_in_no_block(const TriangulatedSurface& horizon, const std::vector<Index>& block,
                      const std::vector<std::vector<bool>>& sides, const BlockFaults& parting) {
  std::vector<FaultSides> fault_sides;
  for (const ThrowFault& fault : parting.faults) fault_sides.emplace_back(*fault.surface);
  const bool one_ends_inside = std::any_of(parting.faults.begin(), parting.faults.end(),
                                           [&](const ThrowFault& f) { return ends_inside(f, parting.box); });
  if (!one_ends_inside) return false;
  const std::vector<Crossing> crossing = find_crossings(horizon, 0, parting.faults, everywhere);
  const AreaSamples samples(horizon);
  double all = 0, alone = 0;
  for (Index t = 0; t < block.size(); ++t) {
    const bool is_sorted = block[t] != BuiltRows::of_every_block && crossing[t] == Crossing::none;
    samples.for_each(t, [&](const Vec3& place, double area) {
      if (!is_in(parting.box, place)) return;
      all += area;
      if (is_sorted) return;
      std::vector<bool> key;
      for (const FaultSides& side : fault_sides) key.push_back(side.is_above(place));
      if (std::find(sides.begin(), sides.end(), key) == sides.end()) alone += area;
    });
  }
  return alone > much_alone * all;
}

SortedBlocks sort_into_blocks(TriangulatedSurface& horizon, const BlockFaults& parting, const BuildLog& log,
                              const KnownSheets& known) {
  const std::vector<ThrowFault>& faults = parting.faults;
  const bool one_ends_inside =
      std::any_of(faults.begin(), faults.end(), [&](const ThrowFault& f) { return ends_inside(f, parting.box); });
  TriangulatedSurface joint = horizon;
  SortedBlocks sorted;
  std::vector<Index>& block = sorted.of_triangle;
  if (!known.sheet.empty()) {
    const auto is_round = [&](Index t) { return known.sheet[t] == BuiltRows::of_every_block; };
    sorted = blocks_of_sheets(horizon, known.sheet, faults, [&](Index t) { return !is_round(t); });
    for (Index t = 0; t < block.size(); ++t)
      if (is_round(t)) block[t] = BuiltRows::of_every_block;
    joint.triangles = known.before;
  } else if (!one_ends_inside) {
    const auto all = [](Index, Index) { return true; };
    const std::vector<Index> joined = sheets_of(horizon.triangles.size(), neighbours_in(horizon), all);
    return blocks_of_sheets(horizon, joined, faults, [](Index) { return true; });
  } else {
    const Ends ends(horizon, parting);
    sorted = blocks_of_sheets(horizon, ends.parts(), faults, [&](Index t) { return ends.is_kept(t); });
    joint.triangles.clear();
    for (Index t = 0; t < block.size(); ++t) {
      if (ends.goes_round(t)) block[t] = BuiltRows::of_every_block;
      if (block[t] != BuiltRows::of_no_block && !ends.is_overshoot(t)) joint.triangles.push_back(horizon.triangles[t]);
    }
  }
  if (one_ends_inside) join_round_ends(horizon, sorted, std::move(joint), parting, log);
  return sorted;
}

}  // namespace geomesh::geomodel

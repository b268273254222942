// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/throw/both_sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <tuple>

#include "common/union_find.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/map_locator.hpp"
#include "rules/throw/carried_heights.hpp"
#include "rules/throw/throw_ramp.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double furthest_carried = 40;  // largest distance of extrapolation, in median edge lengths of a block
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Index no_throw = no_index - 2;  // value that stands for the block of a horizon without throw

/// Heights of the blocks of one horizon: on their triangles, and extrapolated beyond them.
class BlockHeights {
 public:
  explicit BlockHeights(const BlockData& data) : data_(data), single_(data.single) {
    for (const TriangulatedSurface& block : data.blocks) {
      locators_.push_back(std::make_unique<MapLocator>(block));
      edges_.push_back(median_map_edge(block));
      carried_.push_back(std::make_unique<CarriedHeights>(block, edges_.back()));
      std::vector<bool> used(block.points.size(), false);
      for (const Triangle& t : block.triangles)
        for (const VertexIndex v : t)
          if (!used[v]) used[v] = true, carried_.back()->add(v);
    }
  }
  std::size_t n_blocks() const { return locators_.size(); }
  bool reaches(Index block, const Vec2& p) const { return locators_[block]->find(p).count > 0; }
  double height(Index block, const Vec2& p) const {
    if (const auto on = locators_[block]->height(p)) return *on;
    return carried_[block]->at({p.x, p.y, 0}, {0, 0}, furthest_carried * edges_[block]).value_or(nan);
  }
  /// Returns the block of a place of the map at which only one block is present; no_index if there are several or none.
  Index single_block(const Vec2& p) const {
    const Index t = single_.find(p).triangle;
    return t == no_index ? no_index : data_.block_of_single[t];
  }

 private:
  const BlockData& data_;
  MapLocator single_;
  std::vector<std::unique_ptr<MapLocator>> locators_;
  std::vector<std::unique_ptr<CarriedHeights>> carried_;
  std::vector<double> edges_;
};

double area_of(const MapSheets& sheets, const Triangle& t) {
  const Vec2 &a = sheets.points[t[0]], &b = sheets.points[t[1]], &c = sheets.points[t[2]];
  return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// Determines which triangles of the map lie in strips along faults, and their blocks of one horizon with throw.
class StripTriangles {
 public:
  StripTriangles(const MapSheets& sheets, const StripInput& input) : sheets_(sheets), in_(input) {
    for (const BlockData& data : input.horizons)
      heights_.push_back(data.has_throw() ? std::make_unique<BlockHeights>(data) : nullptr);
    const std::size_t n = sheets.triangles.size();
    in_strip_.assign(n, 0);
    for (std::size_t t = 0; t < n; ++t) in_strip_[t] = input.strips.holds(centre(t)) || lacks_height(t);
    crossing_.assign(heights_.size(), {});
    blocks_.resize(heights_.size());
    for (std::size_t k = 0; k < heights_.size(); ++k) {
      if (!heights_[k]) continue;
      cross(k, {});
      find_blocks(k);
      cross(k, blocks_about(k));
      find_blocks(k);
    }
  }

  bool in_strip(std::size_t t) const { return in_strip_[t]; }
  bool has_throw(std::size_t k) const { return heights_[k] != nullptr; }
  bool is_of_every(std::size_t k, std::size_t t) const { return crossing_[k][t] == Crossing::continuation; }
  /// Returns a triangle's blocks: one, or those on both sides of a fault that it crosses; none if it belongs to all.
  const std::vector<Index>& blocks(std::size_t k, std::size_t t) const { return blocks_[k][t]; }
  const BlockHeights& heights(std::size_t k) const { return *heights_[k]; }

 private:
  Vec2 centre(std::size_t t) const {
    const Triangle& v = sheets_.triangles[t];
    const Vec2 &a = sheets_.points[v[0]], &b = sheets_.points[v[1]], &c = sheets_.points[v[2]];
    return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
  }
  bool lacks_height(std::size_t t) const {
    for (const VertexIndex v : sheets_.triangles[t])
      for (std::size_t k = 0; k < heights_.size(); ++k)
        if (heights_[k] && std::isnan(sheets_.height(v, k))) return true;
    return false;
  }

  /// Determines whether each triangle crosses a fault or a fault's extension, at the mean height of the blocks around
  /// it; for faults also at the lowest or highest height. `about` lists the blocks by vertex, if they are known.
  void cross(std::size_t k, const std::vector<std::set<Index>>& about) {
    std::array<TriangulatedSurface, 3> surfaces;
    for (TriangulatedSurface& s : surfaces) s.triangles = sheets_.triangles;
    for (VertexIndex v = 0; v < sheets_.points.size(); ++v) {
      const Vec2 p = in_.frame.to_model(sheets_.points[v]);
      const std::array<double, 3> z = mean_and_ends(k, v, about.empty() ? std::set<Index>{} : about[v]);
      for (std::size_t i = 0; i < 3; ++i) surfaces[i].points.push_back({p.x, p.y, z[i]});
    }
    crossing_[k] = find_crossings(surfaces[0], 0, in_.faults[k].faults, in_.box);
    for (std::size_t i = 1; i < 3; ++i) {
      const std::vector<Crossing> also = find_crossings(surfaces[i], 0, in_.faults[k].faults, in_.box);
      for (std::size_t t = 0; t < also.size(); ++t)
        if (also[t] != Crossing::none && crossing_[k][t] == Crossing::none) crossing_[k][t] = Crossing::fault;
    }
    for (std::size_t t = 0; t < in_strip_.size(); ++t)
      if (crossing_[k][t] == Crossing::fault) in_strip_[t] = 1;
  }

  /// Returns the mean, lowest and highest height at a vertex of the blocks in `about`, else of blocks that reach the
  /// vertex, else of all. If the horizon has a single height at the vertex, that replaces the mean.
  std::array<double, 3> mean_and_ends(std::size_t k, VertexIndex v, const std::set<Index>& about) const {
    const Vec2& p = sheets_.points[v];
    const double settled = sheets_.height(v, k);
    const bool is_single = !std::isnan(settled);
    double sum = 0, least = is_single ? settled : std::numeric_limits<double>::infinity(),
           most = is_single ? settled : -least;
    int n = 0;
    for (int way = about.empty() ? 1 : 0; way < 3 && n == 0 && !(is_single && way > 0); ++way)
      for (Index b = 0; b < heights_[k]->n_blocks(); ++b) {
        if (way == 0 ? !about.contains(b) : way == 1 && !heights_[k]->reaches(b, p)) continue;
        const double z = heights_[k]->height(b, p);
        if (std::isnan(z)) continue;
        sum += z, ++n;
        least = std::min(least, z), most = std::max(most, z);
      }
    if (is_single) return {settled, least, most};
    return n > 0 ? std::array<double, 3>{sum / n, least, most} : std::array<double, 3>{0, 0, 0};
  }

  /// Returns the blocks around each vertex of triangles that cross a fault, or of triangles next to these.
  std::vector<std::set<Index>> blocks_about(std::size_t k) const {
    std::vector<std::set<Index>> about(sheets_.points.size());
    for (int ring = 0; ring < 2; ++ring) {
      const std::vector<std::set<Index>> inner = about;
      for (std::size_t t = 0; t < in_strip_.size(); ++t) {
        std::set<Index> all;
        if (crossing_[k][t] == Crossing::fault) all.insert(blocks_[k][t].begin(), blocks_[k][t].end());
        for (const VertexIndex v : sheets_.triangles[t]) all.insert(inner[v].begin(), inner[v].end());
        for (const VertexIndex v : sheets_.triangles[t]) about[v].insert(all.begin(), all.end());
      }
    }
    return about;
  }

  void find_blocks(std::size_t k) {
    blocks_[k].assign(sheets_.triangles.size(), {});
    label_parts(k);
    share_where_crossed(k);
  }

  /// Assigns triangles connected without crossing a fault to the horizon's block that alone covers most of their area.
  void label_parts(std::size_t k) {
    const std::size_t n = sheets_.triangles.size();
    const auto counts = [&](std::size_t t) { return crossing_[k][t] == Crossing::none; };
    UnionFind joined(n);
    std::map<std::pair<VertexIndex, VertexIndex>, Index> first;
    for (Index t = 0; t < n; ++t)
      for (std::size_t i = 0; counts(t) && i < 3; ++i) {
        const VertexIndex a = sheets_.triangles[t][i], b = sheets_.triangles[t][(i + 1) % 3];
        const auto [at, is_new] = first.emplace(std::pair(std::min(a, b), std::max(a, b)), t);
        if (!is_new) joined.unite(at->second, t);
      }
    std::map<Index, std::map<Index, double>> votes;
    for (Index t = 0; t < n; ++t) {
      if (!counts(t)) continue;
      const Index block = heights_[k]->single_block(centre(t));
      if (block < BuiltRows::of_no_block) votes[joined.find(t)][block] += area_of(sheets_, sheets_.triangles[t]);
    }
    for (Index t = 0; t < n; ++t) {
      const auto found = counts(t) ? votes.find(joined.find(t)) : votes.end();
      if (found == votes.end()) continue;
      const auto most = std::max_element(found->second.begin(), found->second.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
      blocks_[k][t] = {most->first};
    }
  }

  /// Assigns a triangle that crosses a fault, or is enclosed by such triangles, to all blocks around it; where faults
  /// meet, also to those around its neighbours.
  void share_where_crossed(std::size_t k) {
    std::vector<std::size_t> crossed;
    for (std::size_t t = 0; t < in_strip_.size(); ++t)
      if (!is_of_every(k, t) && blocks_[k][t].empty()) crossed.push_back(t);
    bool any = true;
    for (int round = 0; any || round < 2; ++round) {
      any = false;
      std::vector<std::set<Index>> about(sheets_.points.size());
      for (std::size_t t = 0; t < in_strip_.size(); ++t)
        for (const VertexIndex v : sheets_.triangles[t]) about[v].insert(blocks_[k][t].begin(), blocks_[k][t].end());
      for (const std::size_t t : crossed) {
        if (round > 1 && !blocks_[k][t].empty()) continue;
        std::set<Index> all;
        for (const VertexIndex v : sheets_.triangles[t]) all.insert(about[v].begin(), about[v].end());
        any = any || (round > 0 && blocks_[k][t].empty() && !all.empty());
        blocks_[k][t].assign(all.begin(), all.end());
      }
    }
  }

  const MapSheets& sheets_;
  const StripInput& in_;
  /// Heights of each horizon's blocks; null for horizons without throw.
  std::vector<std::unique_ptr<BlockHeights>> heights_;
  std::vector<char> in_strip_;                           ///< per triangle
  std::vector<std::vector<Crossing>> crossing_;          ///< per horizon and triangle: fault or extension crossed
  std::vector<std::vector<std::vector<Index>>> blocks_;  ///< the same
};

/// One block of each horizon (no_throw for those without throw), all on the same sides of common faults.
using BlocksOnOneSide = std::vector<Index>;

class SideFinder {
 public:
  explicit SideFinder(const std::vector<HorizonFaults>& faults) : faults_(faults) {}
  /// Returns all combinations of one block per horizon, out of the given blocks, that lie on the same sides of common
  /// faults; a horizon without any block has no_index.
  std::vector<BlocksOnOneSide> sides_of(const std::vector<std::vector<Index>>& blocks) const {
    std::vector<BlocksOnOneSide> sides;
    BlocksOnOneSide side;
    extend(blocks, side, sides);
    return sides;
  }

 private:
  void extend(const std::vector<std::vector<Index>>& blocks, BlocksOnOneSide& side,
              std::vector<BlocksOnOneSide>& sides) const {
    const std::size_t k = side.size();
    if (k == blocks.size()) {
      sides.push_back(side);
      return;
    }
    bool any = false;
    for (const Index b : blocks[k]) {
      if (!fits(side, k, b)) continue;
      any = true;
      side.push_back(b);
      extend(blocks, side, sides);
      side.pop_back();
    }
    if (any) return;
    side.push_back(no_index);
    extend(blocks, side, sides);
    side.pop_back();
  }
  bool fits(const BlocksOnOneSide& side, std::size_t k, Index block) const {
    if (block == no_throw) return true;
    for (std::size_t j = 0; j < side.size(); ++j) {
      if (side[j] >= no_throw) continue;
      for (std::size_t f = 0; f < faults_[k].rows.size(); ++f)
        for (std::size_t g = 0; g < faults_[j].rows.size(); ++g)
          if (faults_[k].rows[f] == faults_[j].rows[g] && faults_[k].sides[block][f] != faults_[j].sides[side[j]][g])
            return false;
    }
    return true;
  }
  const std::vector<HorizonFaults>& faults_;
};

/// Builds all horizons with throw in the strips along their faults.
class BothSides {
 public:
  BothSides(MapSheets& sheets, const StripInput& input)
      : sheets_(sheets), in_(input), n_(sheets.n_horizons), strips_(sheets, input), finder_(input.faults), made_(n_) {}

  std::vector<SidedHorizon> make() {
    fix_single();
    collect();
    merge_thin();
    for (const auto& [v, blocks] : blocks_at_) settle(v, blocks);
    fill_means();
    for (std::size_t k = 0; k < n_; ++k)
      if (strips_.has_throw(k)) assemble(k);
    return std::move(made_);
  }

 private:
  using Key = std::tuple<VertexIndex, std::size_t, Index>;  ///< vertex, horizon, block
  struct Copy {
    double height = nan;
    bool is_fixed = false;  ///< whether the height is fixed, because triangles with a single height share the vertex
  };

  /// Keeps the single height at vertices of triangles outside the strips along faults, and beyond the ends of faults.
  void fix_single() {
    for (std::size_t k = 0; k < n_; ++k) {
      if (!strips_.has_throw(k)) continue;
      for (std::size_t t = 0; t < sheets_.triangles.size(); ++t)
        for (const VertexIndex v : sheets_.triangles[t]) {
          if (strips_.is_of_every(k, t)) of_every_.insert({v, k});
          if (!strips_.in_strip(t) && !strips_.is_of_every(k, t))
            for (const Index b : strips_.blocks(k, t)) copies_[{v, k, b}] = {sheets_.height(v, k), true};
        }
    }
  }

  /// Collects the blocks of all horizons around each vertex of the strips, and their heights there.
  void collect() {
    for (std::size_t t = 0; t < sheets_.triangles.size(); ++t) {
      if (!strips_.in_strip(t)) continue;
      for (const VertexIndex v : sheets_.triangles[t]) {
        auto& at = blocks_at_.try_emplace(v, n_).first->second;
        for (std::size_t k = 0; k < n_; ++k)
          if (strips_.has_throw(k)) at[k].insert(strips_.blocks(k, t).begin(), strips_.blocks(k, t).end());
      }
    }
    for (auto& [v, blocks] : blocks_at_)
      for (std::size_t k = 0; k < n_; ++k) {
        if (!strips_.has_throw(k)) {
          if (!std::isnan(sheets_.height(v, k))) blocks[k].insert(no_throw);
          continue;
        }
        for (const Index b : blocks[k]) set_height(v, k, b);
        join_beyond_ends(v, k, blocks[k]);
      }
  }

  void set_height(VertexIndex v, std::size_t k, Index b) {
    Copy& copy = copies_[{v, k, b}];
    if (copy.is_fixed) return;
    const Vec2& p = sheets_.points[v];
    const bool is_own = strips_.heights(k).single_block(p) == b && !std::isnan(sheets_.height(v, k));
    copy.height = is_own ? sheets_.height(v, k) : strips_.heights(k).height(b, p);
  }

  /// Gives all blocks the same height at a vertex of a triangle that belongs to every block.
  void join_beyond_ends(VertexIndex v, std::size_t k, const std::set<Index>& blocks) {
    if (!of_every_.contains({v, k})) return;
    double height = sheets_.height(v, k), sum = 0;
    int n = 0;
    for (const Index b : blocks)
      if (const double z = copies_.at({v, k, b}).height; !std::isnan(z)) sum += z, ++n;
    if (std::isnan(height) && n > 0) height = sum / n;
    for (const Index b : blocks) copies_[{v, k, b}] = {height, true};
    sheets_.heights[v * n_ + k] = height;
  }

  double height(VertexIndex v, std::size_t k, Index b) const {
    if (b == no_index) return nan;
    if (b == no_throw) return sheets_.height(v, k);
    const auto at = copies_.find({v, k, b});
    return at == copies_.end() ? nan : at->second.height;
  }
  bool is_fixed(VertexIndex v, std::size_t k, Index b) const {
    if (b == no_throw) return true;
    const auto at = copies_.find({v, k, b});
    return at != copies_.end() && at->second.is_fixed;
  }

  /// Merges the horizons of a unit whose mean thickness over a triangle is too small, separately on each side of
  /// faults.
  void merge_thin() {
    std::vector<std::vector<Index>> blocks(n_);
    for (std::size_t t = 0; t < sheets_.triangles.size(); ++t) {
      if (!strips_.in_strip(t)) continue;
      const Triangle& v = sheets_.triangles[t];
      for (std::size_t k = 0; k < n_; ++k)
        blocks[k] = strips_.has_throw(k) ? strips_.blocks(k, t) : std::vector<Index>{no_throw};
      for (const BlocksOnOneSide& side : finder_.sides_of(blocks))
        for (std::size_t k = 0; k + 1 < n_; ++k) {
          double thickness = 0;
          for (const VertexIndex w : v) thickness += (height(w, k, side[k]) - height(w, k + 1, side[k + 1])) / 3;
          const bool both_single = side[k] == no_throw && side[k + 1] == no_throw;
          if (both_single ? !(sheets_.merged[t] >> k & 1) : !(thickness < in_.options.gap)) continue;
          for (const VertexIndex w : v) merged_.insert({w, k, side[k], side[k + 1]});
        }
    }
  }

  void settle(VertexIndex v, const std::vector<std::set<Index>>& sets) {
    std::vector<std::vector<Index>> blocks;
    for (const std::set<Index>& set : sets) blocks.emplace_back(set.begin(), set.end());
    for (const BlocksOnOneSide& side : finder_.sides_of(blocks)) settle(v, side);
  }

  void settle(VertexIndex v, const BlocksOnOneSide& side) {
    std::vector<double> given(n_);
    std::vector<char> stays(n_), is_against_rule(n_, 0);
    Keepers keepers = in_.options.keepers;
    MergedPairs merged = 0;
    for (std::size_t k = 0; k < n_; ++k) {
      given[k] = height(v, k, side[k]);
      stays[k] = is_fixed(v, k, side[k]) || settled_.contains({v, k, side[k]});
    }
    for (std::size_t k = 0; k + 1 < n_; ++k) {
      for (std::size_t older = k + 1; older < n_; ++older) {
        if (stays[k] == stays[older]) continue;
        const Keeper keeper = stays[k] ? Keeper::younger : Keeper::older;
        const std::size_t fixed = stays[k] ? k : older, moving = stays[k] ? older : k;
        if (keepers.of(k, older) != keeper && is_fixed(v, fixed, side[fixed])) is_against_rule[moving] = 1;
        keepers.set(k, older, keeper);
      }
      if (merged_.contains({v, k, side[k], side[k + 1]})) merged |= MergedPairs{1} << k;
    }
    std::vector<double> heights = given;
    settle_column(heights, merged, keepers, in_.options.gap);
    hold(given, stays, heights);
    for (std::size_t k = 0; k < n_; ++k) {
      if (side[k] >= no_throw || stays[k] || std::isnan(heights[k])) continue;
      copies_.at({v, k, side[k]}) = {heights[k], false};
      settled_.insert({v, k, side[k]});
      const double move = std::abs(heights[k] - given[k]);
      if (is_against_rule[k]) made_[k].largest_against_rule = std::max(made_[k].largest_against_rule, move);
      if (move > made_[k].largest_move) {
        made_[k].largest_move = move;
        made_[k].place = {sheets_.points[v].x, sheets_.points[v].y, given[k]};
      }
    }
  }

  /// Restores the height of horizons that must not move, and puts all others between those.
  static void hold(const std::vector<double>& given, const std::vector<char>& stays, std::vector<double>& heights) {
    double most = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < heights.size(); ++k) {
      if (std::isnan(heights[k])) continue;
      heights[k] = stays[k] ? given[k] : std::min(heights[k], most);
      most = std::min(most, heights[k]);
    }
    double least = -std::numeric_limits<double>::infinity();
    for (std::size_t k = heights.size(); k-- > 0;) {
      if (std::isnan(heights[k])) continue;
      if (!stays[k]) heights[k] = std::max(heights[k], least);
      least = std::max(least, heights[k]);
    }
  }

  /// Gives vertices without a single height the mean height of their copies on the sides of faults.
  void fill_means() {
    std::vector<char> is_held(sheets_.points.size(), 0);
    for (std::size_t t = 0; t < sheets_.triangles.size(); ++t)
      for (const VertexIndex v : sheets_.triangles[t])
        if (!strips_.in_strip(t)) is_held[v] = 1;
    for (const auto& [v, blocks] : blocks_at_)
      for (std::size_t k = 0; k < n_; ++k) {
        if (!strips_.has_throw(k) || is_held[v] || of_every_.contains({v, k})) continue;
        double sum = 0;
        int n = 0;
        for (const Index b : blocks[k])
          if (const double z = height(v, k, b); !std::isnan(z)) sum += z, ++n;
        if (n > 0) sheets_.heights[v * n_ + k] = sum / n;
      }
  }

  void assemble(std::size_t k) {
    Assembly assembly{k, {}, {}};
    for (std::size_t t = 0; t < sheets_.triangles.size(); ++t) {
      if (strips_.is_of_every(k, t)) {
        add(assembly, t, BuiltRows::of_every_block);
      } else if (!strips_.in_strip(t) && !strips_.blocks(k, t).empty()) {
        add(assembly, t, strips_.blocks(k, t).front());
      }
    }
    made_[k].n_single = static_cast<Index>(made_[k].triangles.size());
    for (std::size_t t = 0; t < sheets_.triangles.size(); ++t) {
      if (!strips_.in_strip(t) || strips_.is_of_every(k, t)) continue;
      made_[k].area += area_of(sheets_, sheets_.triangles[t]);
      for (const Index b : strips_.blocks(k, t)) add(assembly, t, b);
    }
  }

  struct Assembly {
    std::size_t horizon;
    std::map<VertexIndex, VertexIndex> single;  ///< new point of each vertex at which the horizon has one height
    std::map<std::pair<VertexIndex, Index>, VertexIndex> sided;  ///< and of copies
  };

  void add(Assembly& assembly, std::size_t t, Index block) {
    SidedHorizon& made = made_[assembly.horizon];
    Triangle own = sheets_.triangles[t];
    std::array<double, 3> heights{};
    std::array<bool, 3> shares{};
    for (std::size_t i = 0; i < 3; ++i) {
      shares[i] = block == BuiltRows::of_every_block || is_fixed(own[i], assembly.horizon, block);
      heights[i] = shares[i] ? sheets_.height(own[i], assembly.horizon) : height(own[i], assembly.horizon, block);
      if (std::isnan(heights[i])) return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = static_cast<VertexIndex>(made.points.size());
      const auto [at, is_new] =
          shares[i] ? single_row(assembly, own[i], row) : sided_row(assembly, {own[i], block}, row);
      if (is_new) made.points.push_back({sheets_.points[own[i]].x, sheets_.points[own[i]].y, heights[i]});
      own[i] = at;
    }
    made.triangles.push_back(own);
    made.block.push_back(block);
  }
  static std::pair<VertexIndex, bool> single_row(Assembly& assembly, VertexIndex v, VertexIndex row) {
    const auto [at, is_new] = assembly.single.emplace(v, row);
    return {at->second, is_new};
  }
  static std::pair<VertexIndex, bool> sided_row(Assembly& assembly, std::pair<VertexIndex, Index> key,
                                                VertexIndex row) {
    const auto [at, is_new] = assembly.sided.emplace(key, row);
    return {at->second, is_new};
  }

  MapSheets& sheets_;
  const StripInput& in_;
  std::size_t n_;
  StripTriangles strips_;
  SideFinder finder_;
  std::vector<SidedHorizon> made_;
  std::map<Key, Copy> copies_;
  std::set<Key> settled_;
  std::set<std::pair<VertexIndex, std::size_t>> of_every_;  ///< vertices and horizons
  /// For each vertex of the strips along faults and each horizon, the blocks around the vertex.
  std::map<VertexIndex, std::vector<std::set<Index>>> blocks_at_;
  std::set<std::tuple<VertexIndex, std::size_t, Index, Index>> merged_;
};

}  // namespace

std::vector<SidedHorizon> make_both_sides(MapSheets& sheets, const StripInput& input) {
  return BothSides(sheets, input).make();
}

}  // namespace geomesh::geomodel

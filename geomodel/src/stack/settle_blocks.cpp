// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/settle_blocks.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <set>

#include "rules/continuation/block_sheets.hpp"
#include "rules/continuation/continue_to_walls.hpp"
#include "rules/continuation/horizon_division.hpp"
#include "rules/framework/end_at_walls.hpp"
#include "rules/planar/borders.hpp"
#include "rules/planar/single_valued.hpp"
#include "stack/horizon_group.hpp"
#include "stack/merge_stack_reports.hpp"

namespace geomesh::geomodel {
namespace {

/// The original part of a horizon and its continuations, divided by fault block.
class BlockSheets {
 public:
  BlockSheets(TriangulatedSurface continued, Index row, const BuiltRows& rows)
      : continued_(std::move(continued)),
        given_(continued_),
        part_(rows.part_of_triangle[row]),
        block_of_part_(rows.block_of_part[row]) {
    if (part_.empty()) part_.assign(continued_.triangles.size(), given_part);
    given_.triangles.clear();
    for (Index t = 0; t < part_.size(); ++t)
      if (part_[t] == given_part) {
        given_.triangles.push_back(continued_.triangles[t]);
        row_of_given_.push_back(t);
      }
  }

  /// Finds the part of the horizon that lies in each fault block, and continues it there.
  void divide(Index row, const ModelRules& rules, const HorizonBlocks& blocks) {
    const BlockFramework& framework = blocks.framework;
    const HorizonDivision division(given_, row, framework, blocks.cutters, {});
    sheets_.resize(framework.n_blocks());
    rows_.resize(framework.n_blocks());
    std::vector<std::vector<Index>> at_corner(given_.points.size());
    for (Index t = 0; t < given_.triangles.size(); ++t)
      for (const VertexIndex v : division.triangles()[t]) at_corner[v].push_back(t);
    for (Index b = 0; b < rows_.size(); ++b) {
      const std::vector<Index> sheet = division.sheet_of(b);
      std::set<Index> with_margin(sheet.begin(), sheet.end());
      for (const Index t : sheet) {
        rows_[b].push_back(row_of_given_[t]);
        if (!division.crosses_wall(t)) continue;
        for (const VertexIndex v : division.triangles()[t])
          with_margin.insert(at_corner[v].begin(), at_corner[v].end());
      }
      for (const Index t : with_margin) sheets_[b].given.push_back(t);
    }
    const bool fills = std::ranges::count(blocks.fill_blocks, row) > 0;
    if (rules.of(row).continues_by_default()) {
      const double within = rules.continuation.within_of_horizons;
      ends_at_ = lengths_before(given_, row, blocks.walls, rules.continuation.bounds, within);
      const BorderStates states = border_states(given_, row, blocks.walls, rules.continuation.bounds,
                                                reach_of_horizon(rules.continuation, fills));
      for (BlockExtension& made :
           continue_in_blocks(given_, row, states, {framework, blocks.cutters, blocks.walls, within, fills, {}, true})
               .extensions) {
        const Index block = made.block;
        sheets_[block].extension = std::move(made);
      }
    }
    for (Index t = 0; t < part_.size(); ++t)
      if (const Index block = block_of_part(part_[t]); block != no_index) rows_[block].push_back(t);
  }

  const TriangulatedSurface& continued() const { return continued_; }
  /// Returns the triangles of the continued horizon that lie in a block.
  const std::vector<Index>& rows(Index block) const { return rows_[block]; }
  const std::vector<Index>& part() const { return part_; }
  /// Returns the block in which a part continues the horizon; no_index for the original part, and for continuations
  /// along a border that belong to no block.
  Index block_of_part(Index part) const {
    return part == given_part || part > block_of_part_.size() ? no_index : block_of_part_[part - 1];
  }
  /// Returns the length in m of the horizon's border that ends at surface `other`, or shortly before it.
  double length_at(Index other) const {
    const auto at = ends_at_.find(other);
    return at == ends_at_.end() ? 0 : at->second;
  }
  /// Returns the part of the horizon in a block, with a margin beyond the block's bounds. Its points are numbered anew.
  TriangulatedSurface sheet(Index block) const {
    const std::vector<Index>& rows = sheets_[block].given;
    const BlockExtension& extension = sheets_[block].extension;
    TriangulatedSurface s = given_;
    s.points.clear();
    s.triangles.clear();
    std::vector<VertexIndex> own(given_.points.size() + extension.added.size(), no_vertex);
    const auto add = [&](Triangle t) {
      for (VertexIndex& v : t) {
        if (own[v] == no_vertex) {
          own[v] = static_cast<VertexIndex>(s.points.size());
          s.points.push_back(v < given_.points.size() ? given_.points[v] : extension.added[v - given_.points.size()]);
        }
        v = own[v];
      }
      s.triangles.push_back(t);
    };
    for (const Index t : rows) add(given_.triangles[t]);
    for (const Triangle& t : extension.triangles) add(t);
    return s;
  }

 private:
  struct Sheet {
    std::vector<Index> given;  ///< indices of the horizon's original triangles in the block, ascending
    BlockExtension extension;
  };
  TriangulatedSurface continued_, given_;
  std::vector<Index> part_, block_of_part_, row_of_given_;
  std::map<Index, double> ends_at_;
  std::vector<Sheet> sheets_;             ///< per block
  std::vector<std::vector<Index>> rows_;  ///< per block
};

struct SettledBlock {
  Index block;
  std::vector<std::size_t> horizons;  ///< indices of the horizons in the stack, in the order of the group
  std::unique_ptr<HorizonGroup> group;
};

/// A horizon that is reassembled from its blocks.
class Rebuilt {
 public:
  /// `tolerance` is how far the arrangement may move vertices of the horizon.
  Rebuilt(const BlockSheets& sheets, const HorizonBlocks& blocks, double tolerance)
      : continued_(sheets.continued()), sheets_(sheets), blocks_(blocks), tolerance_(tolerance), surface_(continued_) {
    surface_.triangles.clear();
    n_parts_ = 1 + *std::ranges::max_element(sheets.part());
  }

  /// Adds the horizon's parts in unchanged blocks. Triangles that reach into changed blocks end where these begin.
  void keep(const std::set<Index>& settled) {
    std::vector<bool> is_kept(continued_.triangles.size(), false), is_remade = is_kept;
    for (Index b = 0; b < blocks_.framework.n_blocks(); ++b)
      for (const Index t : sheets_.rows(b)) (settled.contains(b) ? is_remade : is_kept)[t] = true;
    const Index ending = n_parts_++;
    for (Index t = 0; t < is_kept.size(); ++t) {
      const Index part = sheets_.part()[t];
      if (is_remade[t] && !is_kept[t]) continue;
      add(continued_.triangles[t], 0, part == given_part && is_remade[t] ? ending : part);
    }
  }

  /// Adds the new part of the horizon in one block. Triangles that cross the block's bounding surfaces get a separate
  /// part number; those beyond the bounding surfaces are left out.
  void add(const TriangulatedSurface& sheet, Index block) {
    const Index beyond = n_parts_++;
    const auto shift = static_cast<VertexIndex>(surface_.points.size());
    surface_.points.insert(surface_.points.end(), sheet.points.begin(), sheet.points.end());
    std::vector<bool> is_inside, is_centred;
    for (const Triangle& t : sheet.triangles) {
      const Vec3 &a = sheet.points[t[0]], &b = sheet.points[t[1]], &c = sheet.points[t[2]];
      is_centred.push_back(blocks_.framework.block_at((1.0 / 3) * (a + b + c)) == block);
      is_inside.push_back(is_centred.back() && !meets_wall(a, b) && !meets_wall(b, c) && !meets_wall(c, a));
    }
    if (std::ranges::none_of(is_inside, std::identity{})) is_inside = is_centred;  // a narrow block
    const std::vector<bool> is_needed = reaches_walls(sheet, block);
    for (Index t = 0; t < sheet.triangles.size(); ++t)
      if (is_inside[t] || is_needed[t]) add(sheet.triangles[t], shift, is_inside[t] ? given_part : beyond);
  }

  void replace_in(BuiltSurfaces& built, Index row, const std::set<Index>& stack) {
    std::vector<Index>& walls = built.rows.continued_to[row];
    std::erase_if(walls, [&](Index wall) { return stack.contains(wall); });
    walls_.insert(walls.begin(), walls.end());
    walls.assign(walls_.begin(), walls_.end());
    sort_by_part();
    built.rows.n_given_triangles[row] = static_cast<Index>(std::ranges::count(part_, given_part));
    built.rows.part_of_triangle[row] = std::move(part_);
    built.surfaces[row] = std::move(surface_);
  }

 private:
  /// Sorts the horizon's triangles by part, so that original ones come first, as in all continued surfaces.
  void sort_by_part() {
    std::vector<Index> order(part_.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::stable_sort(order, {}, [&](Index t) { return part_[t]; });
    std::vector<Triangle> triangles;
    for (const Index t : order) triangles.push_back(surface_.triangles[t]);
    surface_.triangles = std::move(triangles);
    std::ranges::sort(part_);
  }
  /// For each triangle, returns whether some of it lies in the block, or it touches such a triangle so close to a
  /// bounding surface that the arrangement, which moves nearby vertices, might leave a gap without it.
  std::vector<bool> reaches_walls(const TriangulatedSurface& sheet, Index block) const {
    std::vector<bool> reaches, is_at_wall(sheet.points.size(), false);
    for (const auto& [a, b, c] : sheet.triangles) {
      reaches.push_back(blocks_.framework.overlaps(block, {sheet.points[a], sheet.points[b], sheet.points[c]}));
      for (const VertexIndex v : {a, b, c})
        if (reaches.back() && !is_at_wall[v])
          is_at_wall[v] = blocks_.cutters.meets_disc(sheet.points[v], tolerance_, {0, 0}, no_index);
    }
    for (Index t = 0; t < reaches.size(); ++t)
      for (const VertexIndex v : sheet.triangles[t])
        if (is_at_wall[v]) reaches[t] = true;
    return reaches;
  }
  bool meets_wall(const Vec3& a, const Vec3& b) {
    const std::vector<Index> walls = blocks_.cutters.surfaces_on(a, b);
    walls_.insert(walls.begin(), walls.end());
    return !walls.empty();
  }
  void add(Triangle t, VertexIndex shift, Index part) {
    for (VertexIndex& v : t) v += shift;
    surface_.triangles.push_back(t);
    part_.push_back(part);
  }

  const TriangulatedSurface& continued_;
  const BlockSheets& sheets_;
  const HorizonBlocks& blocks_;
  double tolerance_;
  TriangulatedSurface surface_;
  std::vector<Index> part_;
  Index n_parts_;
  std::set<Index> walls_;
};

class BlockStack {
 public:
  BlockStack(const Stack& stack, BuiltSurfaces& built, const ModelRules& rules, const HorizonBlocks& blocks)
      : stack_(stack),
        built_(built),
        rules_(rules),
        blocks_(blocks),
        frame_(rules.stack.outline, rules.stack.outline_is_box),
        bounds_(frame_.bounds(rules.stack.outline)) {
    for (const Index row : stack.rows) {
      sheets_.emplace_back(built.surfaces[row], row, built.rows);
      sheets_.back().divide(row, rules, blocks);
    }
  }

  /// Puts the horizons in order in all blocks, or, with a note, in none.
  bool settle() {
    for (Index b = 0; b < blocks_.framework.n_blocks(); ++b) settle_block(b);
    if (n_left_ > 0) {
      built_.notes.push_back("the stack is left as given: in " + std::to_string(n_left_) + " of " +
                             std::to_string(blocks_.framework.n_blocks()) + " fault blocks, in the first of them " +
                             why_left_);
      return false;
    }
    if (settled_.empty()) return false;
    std::set<Index> blocks;
    for (const SettledBlock& s : settled_) {
      blocks.insert(s.block);
      merge_stack_reports(s.group->told(), built_.stack);
    }
    const std::set<Index> rows(stack_.rows.begin(), stack_.rows.end());
    for (std::size_t k = 0; k < stack_.rows.size(); ++k) replace(k, blocks, rows);
    return true;
  }

 private:
  void settle_block(Index block) {
    GroupMembers members{{}, {}, {}, bounds_of(block)};
    SettledBlock settled{block, {}, nullptr};
    for (std::size_t k = 0; k < stack_.rows.size(); ++k) {
      const TriangulatedSurface sheet = sheets_[k].sheet(block);
      if (sheet.triangles.empty()) continue;
      if (!is_single_valued(sheet)) return leave(k, "has more than one height over a place of the map");
      if (ends_at_wall(sheet, block)) return leave(k, "ends at a fault or body and is not continued through it");
      settled.horizons.push_back(k);
      members.stack.rows.push_back(stack_.rows[k]);
      members.data.push_back(block_data(frame_.to_frame(sheet), {}, 0));
      members.faults.emplace_back();
    }
    if (settled.horizons.empty()) return;
    for (std::size_t i = 0; i + 1 < settled.horizons.size(); ++i) {
      std::string& unit = members.stack.units.emplace_back();
      for (std::size_t k = settled.horizons[i]; k < settled.horizons[i + 1]; ++k)
        unit += (unit.empty() ? "" : "+") + stack_.units[k];
    }
    members.stack.keepers = keepers(settled.horizons);
    members.counts = [&framework = blocks_.framework, block](const Vec3& p) { return framework.block_at(p) == block; };
    settled.group = std::make_unique<HorizonGroup>(std::move(members), built_, rules_, frame_);
    const Settling outcome = settled.group->settle();
    if (outcome == Settling::overhangs)
      leave(settled.horizons[settled.group->first_that_overhangs()],
            "has more than one height over a place of the map");
    if (outcome == Settling::settled) settled_.push_back(std::move(settled));
  }

  void leave(std::size_t horizon, const std::string& why) {
    if (n_left_++ == 0) why_left_ = "horizon " + built_.surfaces[stack_.rows[horizon]].name + " " + why;
  }

  /// Returns which horizon of each pair keeps its height: unless a rule decides, the one at which the other ends.
  Keepers keepers(const std::vector<std::size_t>& horizons) const {
    std::vector<Index> rows;
    for (const std::size_t k : horizons) rows.push_back(stack_.rows[k]);
    Keepers who = keepers_of(rules_, rows, built_.surfaces);
    if (rules_.on_crossing != OnCrossing::leave) return who;
    for (std::size_t younger = 0; younger < rows.size(); ++younger)
      for (std::size_t older = younger + 1; older < rows.size(); ++older) {
        const bool has_rule = rules_.of(rows[younger]).base == BaseRule::erode ||
                              rules_.of(rows[older]).base == BaseRule::onlap ||
                              built_.surfaces[rows[younger]].name == rules_.topography ||
                              built_.surfaces[rows[older]].name == rules_.floor;
        if (!has_rule &&
            sheets_[horizons[younger]].length_at(rows[older]) > sheets_[horizons[older]].length_at(rows[younger]))
          who.set(younger, older, Keeper::older);
      }
    return who;
  }

  /// Returns the bounds of a block in the map, enlarged by how far its horizons may extend beyond it.
  MapBounds bounds_of(Index block) const {
    const Box3& box = blocks_.framework.bounds(block);
    MapBounds b;
    for (const double x : {box.min.x, box.max.x})
      for (const double y : {box.min.y, box.max.y}) b.add(frame_.to_frame(Vec2{x, y}));
    b = b.grown(rules_.continuation.within_of_horizons);
    return {{std::max(b.min.x, bounds_.min.x), std::max(b.min.y, bounds_.min.y)},
            {std::min(b.max.x, bounds_.max.x), std::min(b.max.y, bounds_.max.y)}};
  }

  /// Returns whether the horizon's part has a border inside the block close to a bounding surface, and may therefore
  /// end at that bounding surface. A part that continues beyond the bounding surface has no border there.
  bool ends_at_wall(const TriangulatedSurface& sheet, Index block) const {
    const double radius = rules_.continuation.within_of_horizons / 2;
    for (const BorderEdge& e : border_edges(sheet)) {
      const Vec3 middle = 0.5 * (sheet.points[e.a] + sheet.points[e.b]);
      if (blocks_.framework.block_at(middle) == block && blocks_.cutters.meets_disc(middle, radius, {0, 0}, no_index))
        return true;
    }
    return false;
  }

  void replace(std::size_t k, const std::set<Index>& blocks, const std::set<Index>& rows) {
    const Index row = stack_.rows[k];
    const std::size_t n_given = built_.surfaces[row].triangles.size();
    Rebuilt rebuilt(sheets_[k], blocks_, rules_.stack.tolerance);
    rebuilt.keep(blocks);
    for (const SettledBlock& s : settled_)
      for (std::size_t i = 0; i < s.horizons.size(); ++i)
        if (s.horizons[i] == k) rebuilt.add(s.group->sheet(i), s.block);
    rebuilt.replace_in(built_, row, rows);
    for (SettledHorizon& told : built_.stack.horizons) {
      if (told.name != built_.surfaces[row].name) continue;
      told.n_triangles_given = n_given;
      told.n_triangles = built_.surfaces[row].triangles.size();
    }
  }

  const Stack& stack_;
  BuiltSurfaces& built_;
  const ModelRules& rules_;
  const HorizonBlocks& blocks_;
  MapFrame frame_;
  MapBounds bounds_;
  std::vector<BlockSheets> sheets_;
  std::vector<SettledBlock> settled_;
  std::size_t n_left_ = 0;  ///< number of fault blocks in which the horizons cannot be put in order
  std::string why_left_;    ///< reason why the horizons of the first block that failed cannot be put in order
};

}  // namespace

bool can_be_settled_in_blocks(const Stack& stack, const BuiltSurfaces& built, const ModelRules& rules) {
  return built.rows.truncations.empty() && rules.continuation.within_of_horizons > 0 &&
         std::ranges::all_of(stack.rows, [&](Index row) { return built.rows.block_of_triangle[row].empty(); });
}

bool settle_in_blocks(const Stack& stack, BuiltSurfaces& built, const ModelRules& rules, const HorizonBlocks& blocks) {
  return BlockStack(stack, built, rules, blocks).settle();
}

}  // namespace geomesh::geomodel

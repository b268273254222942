// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/continue_to_walls.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "common/equal_points.hpp"
#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "rules/continuation/apron.hpp"
#include "rules/continuation/block_sheets.hpp"
#include "rules/continuation/bridges.hpp"
#include "rules/framework/end_at_walls.hpp"
#include "rules/framework/end_on_faults.hpp"
#include "rules/framework/fault_truncations.hpp"
#include "rules/planar/borders.hpp"

namespace geomesh::geomodel {
namespace {

/// Makes triangles that meet share their points, so that a continuation shares points with the part at which it begins.
void share_points(TriangulatedSurface& surface) {
  const std::vector<VertexIndex> merged = merge_equal_points(surface.points);
  for (Triangle& t : surface.triangles)
    for (VertexIndex& v : t) v = merged[v];
}

/// Records the number and the area of the triangles from index `first` on, which fill gaps in a surface. If their area
/// exceeds that of all triangles recorded before, also records a place in the largest of them.
void book_filled(ContinuedSurface& ledger, const TriangulatedSurface& s, Index first) {
  const double area_before = ledger.area_filled;
  double largest = 0, added = 0;
  Vec3 place;
  for (Index t = first; t < s.triangles.size(); ++t) {
    const Triangle& v = s.triangles[t];
    const Vec3 &a = s.points[v[0]], &b = s.points[v[1]], &c = s.points[v[2]];
    const double area = norm(cross(b - a, c - a)) / 2;
    added += area;
    if (area > largest) largest = area, place = (1.0 / 3) * (a + b + c);
  }
  ledger.n_filled += s.triangles.size() - first;
  ledger.area_filled += added;
  if (added > area_before) ledger.place_filled = place;
}

void note(const ContinuedSurface& ledger, double within, const BuildLog& log) {
  if (ledger.n_filled > 0)
    log.notes.push_back("surface " + ledger.name + ": gaps narrower than " + to_text(2 * within) + " filled (area " +
                        to_text(ledger.area_filled) + ", the largest near " + to_text(ledger.place_filled) + ")");
  if (ledger.area > 0)
    log.notes.push_back("surface " + ledger.name + ": continued along " + to_text(ledger.length) +
                        " m of its border to " + ledger.walls + ", by up to " + to_text(ledger.farthest) + " m, near " +
                        to_text(ledger.place) + " (extend: none keeps the border open)");
}

/// State of one surface while it is continued to the faults, bodies and sides of the model that bound it.
class Continuing {
 public:
  Continuing(BuiltSurfaces& built, Index row, const Walls& walls, const ContinuationRules& rules, double within)
      : built_(built), row_(row), walls_(walls), rules_(rules), within_(within) {
    ledger_.name = surface().name;
    share_points(surface());
  }

  /// Continues a fault, with heights over its mean plane.
  void go_on() {
    begin();
    add_aprons({}, {frame_of(surface())});
    finish();
  }

  void fill_holes(const Walls& cutters, const std::function<bool(const Vec3&)>& counts) {
    const auto first = static_cast<Index>(surface().triangles.size());
    bridge_gaps(surface(), {cutters, {}, {frame_of(surface())}, rules_.bounds, within_, counts, true});
    if (surface().triangles.size() == first) return;
    open_where_pierced(surface(), row_, first, walls_, rules_.bounds);
    book_filled(ledger_, surface(), first);
  }

  /// Continues a horizon block by block, and along its border in blocks in which that is not possible.
  void go_on_in(const BorderStates& states, const BlockSetting& setting, const std::vector<FaultTip>& tips) {
    begin();
    DividedHorizon divided = continue_in_blocks(surface(), row_, states, setting);
    if (std::find(divided.is_continued.begin(), divided.is_continued.end(), false) != divided.is_continued.end()) {
      const std::vector<Frame> frames = frames_along(surface(), tips);
      const auto counts = [&](const Vec3& p) {
        const Index block = setting.framework.block_at(p);
        return block == no_index || !divided.block_is_continued[block];
      };
      const auto first = static_cast<Index>(surface().triangles.size());
      bridge_gaps(surface(), {setting.cutters, tips, frames, rules_.bounds, within_, counts});
      book_filled(ledger_, surface(), first);
      part_.resize(surface().triangles.size(), given_part);
      add_aprons(divided.is_continued, frames);
    }
    for (BlockExtension& made : divided.extensions) {
      append({std::move(made.added), std::move(made.triangles), {}, {}}, n_given_points_);
      const Index part = next_part();
      part_.resize(surface().triangles.size(), part);
      block_of_part_.resize(part, no_index);
      block_of_part_.back() = made.block;
      const std::vector<Index> before = made.walls;
      std::erase(made.walls, Walls::side_of_volume);
      book({made.length, made.farthest, made.place, before, made.walls});
    }
    finish();
  }

  void tell(const BuildLog& log) {
    note(ledger_, within_, log);
    if (ledger_.n_filled > 0 || ledger_.area > 0) built_.continued.push_back(ledger_);
  }

 private:
  TriangulatedSurface& surface() { return built_.surfaces[row_]; }

  void begin() {
    n_given_points_ = surface().points.size();
    part_.assign(surface().triangles.size(), given_part);
  }

  Index next_part() const { return 1 + *std::max_element(part_.begin(), part_.end()); }

  void add_aprons(const std::vector<bool>& done, const std::vector<Frame>& frames) {
    const std::size_t n_points = surface().points.size();
    const std::vector<BorderChain> chains = chains_before_walls(surface(), row_, walls_, rules_.bounds, within_, done);
    std::vector<Apron> aprons;
    for (const BorderChain& chain : chains) aprons.push_back(apron_of(chain, frames));
    for (std::size_t k = 0; k < aprons.size(); ++k) {
      if (aprons[k].triangles.empty()) continue;
      append(aprons[k], n_points);
      const Index n_parts = next_part();
      for (const Index side : aprons[k].side) part_.push_back(n_parts + side);
      book({chains[k].length, chains[k].farthest, chains[k].place, chains[k].walls, aprons[k].walls});
    }
  }

  /// Makes the strip beside a chain of border edges, in the first projection in which the chain does not cross itself.
  Apron apron_of(const BorderChain& chain, const std::vector<Frame>& frames) {
    for (const Frame& frame : frames) {
      Apron apron = make_apron(surface(), row_, chain, walls_, {frame, within_, rules_.bounds});
      if (!apron.crosses_itself) return apron;
    }
    return {};
  }

  void finish() {
    ledger_.area = area_from(surface(), static_cast<std::size_t>(std::find_if(part_.begin(), part_.end(),
                                                                              [](Index p) { return p != given_part; }) -
                                                                 part_.begin()));
    if (ends_on_.empty() && ledger_.area == 0) return;
    built_.rows.part_of_triangle[row_] = std::move(part_);
    built_.rows.block_of_part[row_] = std::move(block_of_part_);
    built_.rows.continued_to[row_].assign(ends_on_.begin(), ends_on_.end());
  }

  /// Appends a strip of triangles to the surface. Corners from index `first_points` on are the strip's own points.
  void append(const Apron& apron, std::size_t first_points) {
    TriangulatedSurface& s = surface();
    const auto shift = static_cast<VertexIndex>(s.points.size() - first_points);
    s.points.insert(s.points.end(), apron.added.begin(), apron.added.end());
    for (Triangle t : apron.triangles) {
      for (VertexIndex& v : t)
        if (v >= first_points) v += shift;
      s.triangles.push_back(t);
    }
  }

  /// A piece of a surface's border that is continued: one chain of edges, or the whole border in one block.
  struct Run {
    double length, farthest;
    Vec3 place;
    std::vector<Index> before;   ///< bounding surfaces in front of the surface's border
    std::vector<Index> through;  ///< bounding surfaces that the surface's continuation crosses
  };
  void book(const Run& run) {
    ledger_.length += run.length;
    if (run.farthest >= ledger_.farthest) ledger_.farthest = run.farthest, ledger_.place = run.place;
    std::set<std::string> names;
    for (const Index wall : run.before) names.insert(name_of(wall));
    for (const Index wall : run.through) {
      names.insert(name_of(wall));
      ends_on_.insert(wall);
    }
    for (const std::string& name : names)
      if ((", " + ledger_.walls + ",").find(", " + name + ",") == std::string::npos)
        ledger_.walls += (ledger_.walls.empty() ? "" : ", ") + name;
  }

  std::string name_of(Index wall) const {
    return wall == Walls::side_of_volume ? "the sides of the model" : built_.surfaces[wall].name;
  }

  BuiltSurfaces& built_;
  Index row_;
  const Walls& walls_;
  const ContinuationRules& rules_;
  double within_;
  std::size_t n_given_points_ = 0;
  std::vector<Index> part_;           ///< BuiltRows::part_of_triangle
  std::vector<Index> block_of_part_;  ///< BuiltRows::block_of_part
  std::set<Index> ends_on_;
  ContinuedSurface ledger_;
};

std::vector<Index> rows_of(const std::vector<TriangulatedSurface>& surfaces, std::initializer_list<SurfaceKind> kinds) {
  std::vector<Index> rows;
  for (Index s = 0; s < surfaces.size(); ++s)
    if (std::find(kinds.begin(), kinds.end(), surfaces[s].kind) != kinds.end()) rows.push_back(s);
  return rows;
}

bool keeps_border(const BuiltSurfaces& built, const ModelRules& rules, Index row) {
  return built.surfaces[row].triangles.empty() || !rules.of(row).continues_by_default();
}

class HorizonContinuation {
 public:
  /// `built` contains the surfaces that bound the blocks, and must outlive this object; its BuiltRows::overshooting is
  /// set. Continued horizons that bound no blocks may belong to it, too.
  HorizonContinuation(BuiltSurfaces& built, const ModelRules& rules, const std::vector<Index>& fill_blocks)
      : built_(built),
        rules_(rules),
        fill_blocks_(fill_blocks),
        unconformities_(truncating_horizons(built.rows.truncations)),
        ended_(ended_faults(built, rules)),
        cutters_(ended_.surfaces, with_unconformities(rows_of(built.surfaces, {SurfaceKind::fault, SurfaceKind::body})),
                 {}),
        walls_(ended_.surfaces, rows_of(built.surfaces, {SurfaceKind::fault, SurfaceKind::body, SurfaceKind::horizon}),
               rules.continuation.sides) {}

  void run(BuiltSurfaces& built, const std::vector<Index>& rows, const BuildLog& log) {
    const ContinuationRules& how = rules_.continuation;
    for (const Index row : rows) {
      const bool fills_blocks = std::ranges::count(fill_blocks_, row) > 0;
      Continuing horizon(built, row, walls_, how, how.within_of_horizons);
      horizon.fill_holes(cutters_, [&](const Vec3& p) { return !framework().has_tip_at(p); });
      const BorderStates states =
          border_states(built.surfaces[row], row, walls_, how.bounds, reach_of_horizon(how, fills_blocks));
      const auto has_met_wall = [](const auto& edge) { return edge.second == BorderState::met_wall; };
      if (std::ranges::all_of(states, has_met_wall)) {
        horizon.tell(log);
        continue;
      }
      horizon.go_on_in(
          states, {framework(), cutters_, walls_, how.within_of_horizons, fills_blocks, left_out(built.surfaces, row)},
          ended_.tips);
      horizon.tell(log);
    }
  }

  std::optional<HorizonBlocks> blocks() {
    if (!framework_) return std::nullopt;
    return HorizonBlocks{std::move(*framework_), std::move(cutters_), std::move(walls_), fill_blocks_};
  }

 private:
  const BlockFramework& framework() {
    if (!framework_) framework_.emplace(built_, rules_);
    return *framework_;
  }

  std::vector<Index> with_unconformities(std::vector<Index> rows) const {
    rows.insert(rows.end(), unconformities_.begin(), unconformities_.end());
    std::ranges::sort(rows);
    return rows;
  }

  /// Marks the blocks in which the horizon is absent: above a younger unconformity, or below an older one.
  std::vector<bool> left_out(const std::vector<TriangulatedSurface>& surfaces, Index row) const {
    const auto position = [&](Index s) { return std::ranges::find(rules_.column, surfaces[s].name); };
    std::vector<bool> blocks(framework_->n_blocks(), false);
    for (const Index horizon : unconformities_) {
      if (position(row) == rules_.column.end() || position(horizon) == rules_.column.end()) continue;
      const int side = position(horizon) < position(row) ? 1 : -1;
      for (Index b = 0; b < framework_->n_blocks(); ++b)
        if (framework_->side_of_unconformity(b, horizon) == side) blocks[b] = true;
    }
    return blocks;
  }

  const BuiltSurfaces& built_;
  const ModelRules& rules_;
  const std::vector<Index>& fill_blocks_;
  std::vector<Index> unconformities_;
  EndedFaults ended_;
  std::optional<BlockFramework> framework_;  ///< fault blocks, computed when the first horizon needs them
  Walls cutters_, walls_;
};

}  // namespace

void continue_faults(BuiltSurfaces& built, const ModelRules& rules, const BuildLog& log) {
  const ContinuationRules& how = rules.continuation;
  if (!(how.within_of_faults > 0)) return;
  const std::vector<Index> faults = rows_of(built.surfaces, {SurfaceKind::fault});
  built.rows.truncations = fault_truncations(built.surfaces, rules);
  std::map<Index, Walls> walls_of;  // bounding surfaces of all faults are collected before any fault is continued
  const Walls walls(built.surfaces, faults, how.sides);
  for (const Index row : faults) {
    std::vector<Index> own;
    for (const auto& [fault, horizon] : built.rows.truncations)
      if (fault == row) own.push_back(horizon);
    if (own.empty()) continue;
    const bool by_default = ends_by_default(built.surfaces, rules, row);
    if (by_default) own.insert(own.end(), faults.begin(), faults.end());
    walls_of.emplace(row, Walls(built.surfaces, own, by_default ? how.sides : std::vector<TriangulatedSurface>{}));
  }
  for (const Index row : faults) {
    const auto own = walls_of.find(row);
    if (own == walls_of.end() && !ends_by_default(built.surfaces, rules, row)) continue;
    Continuing fault(built, row, own == walls_of.end() ? walls : own->second, how, how.within_of_faults);
    fault.go_on();
    fault.tell(log);
  }
}

double reach_of_horizon(const ContinuationRules& rules, bool fills_blocks) {
  return fills_blocks ? norm(rules.bounds.max - rules.bounds.min) : rules.within_of_horizons;
}

std::optional<HorizonBlocks> continue_horizons(BuiltSurfaces& built, const ModelRules& rules,
                                               const std::vector<Index>& fill_blocks, const BuildLog& log) {
  if (!(rules.continuation.within_of_horizons > 0)) return std::nullopt;
  std::vector<Index> left;
  for (const Index row : rows_of(built.surfaces, {SurfaceKind::horizon}))
    if (!keeps_border(built, rules, row)) left.push_back(row);
  if (left.empty()) return std::nullopt;
  const std::vector<Index> truncating = truncating_horizons(built.rows.truncations);
  const auto middle = std::stable_partition(left.begin(), left.end(),
                                            [&](Index row) { return std::ranges::binary_search(truncating, row); });
  // The unconformities, which become bounding surfaces of the blocks below them.
  const std::vector<Index> first(left.begin(), middle);
  left.erase(left.begin(), middle);
  if (!first.empty()) {
    BuiltSurfaces above = built;
    for (const auto& [fault, _] : built.rows.truncations) above.surfaces[fault].triangles.clear();
    above.rows.truncations.clear();
    HorizonContinuation(above, rules, fill_blocks).run(built, first, log);
  }
  HorizonContinuation continuation(built, rules, fill_blocks);
  continuation.run(built, left, log);
  return continuation.blocks();
}

}  // namespace geomesh::geomodel

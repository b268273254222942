// SPDX-License-Identifier: GPL-3.0-or-later
// Applies, in order, the rules that follow the arrangement, declared in geomesh/geomodel/model_rules.hpp.
#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "rules/blocks/part_blocks.hpp"
#include "rules/framework/end_at_walls.hpp"
#include "rules/framework/end_on_faults.hpp"
#include "rules/framework/fault_truncations.hpp"
#include "rules/framework/overshoots.hpp"
#include "rules/order/column_heights.hpp"
#include "rules/planar/height_vote.hpp"
#include "rules/planar/map_locator.hpp"
#include "rules/planar/pieces.hpp"
#include "rules/throw/sheet_sides.hpp"

namespace geomesh::geomodel {

namespace {

/// Least ratio of the shorter to the longer of two lengths, at which a piece of a fault counts as a step between two
/// blocks: the lengths along which the piece is above a horizon, and along which it is below.
constexpr double share_of_step = 0.5;
/// Least ratio of the lengths above and below the topography or base at which a piece of a fault counts as a step
/// between two blocks. It is small, because a piece that is kept beyond the model does no harm. Such a piece lies
/// between two blocks and continues beyond them, for example where a body separates one block from the fault.
constexpr double share_at_end = 0.1;

/// Returns whether a piece of a fault lies between two blocks of a horizon: above one and below the other, along
/// lengths whose ratio is at least `least_share`. It separates the units above and below the horizon.
bool is_step(const Piece& piece, double least_share) {
  return piece.above > 0 && piece.below > 0 &&
         std::min(piece.above, piece.below) >= least_share * std::max(piece.above, piece.below);
}

/// A soup that is being trimmed, the rules that trim it, and the record of what was done.
struct Trimming {
  WorkingSoup working;
  const std::vector<TriangulatedSurface>& surfaces;
  const BuiltRows& built;
  const ModelRules& rules;
  std::vector<double> removed;  ///< area, per surface
  std::vector<std::string> notes{}, warnings{};
  std::map<Index, UpwardSides> upward{};  ///< for each surface, which side of its triangles faces up; made when needed

  Index row_of(const std::string& name) const {
    for (Index s = 0; s < surfaces.size(); ++s)
      if (surfaces[s].name == name) return s;
    throw Error(ErrorKind::usage, "no surface is named " + name + " (in a rule of the model)");
  }

  const UpwardSides& sides_of(Index s) {
    const auto at = upward.find(s);
    return at != upward.end() ? at->second : upward.emplace(s, orient_upward(surfaces[s])).first->second;
  }

  Index n_given() const { return static_cast<Index>(built.n_given_triangles.size()); }
  bool is_given(const PolygonSoup::Origin& o) const { return o.triangle < built.n_given_triangles[o.surface]; }

  double remove(const Piece& piece, Index surface) {
    const double area = working.remove(piece.facets, surface);
    removed[surface] += area;
    return area;
  }

  /// Returns all faults except x. Horizons in blocks end at them, so that a piece of x may lie above such a horizon on
  /// one side of a fault and below it on the other.
  std::vector<Index> faults_but(Index x) const {
    std::vector<Index> faults;
    for (Index s = 0; s < surfaces.size(); ++s)
      if (s != x && surfaces[s].kind == SurfaceKind::fault) faults.push_back(s);
    return faults;
  }

  /// Returns the faults except x at which horizon y is divided. Topography and base may have a scarp at any fault.
  std::vector<Index> dividers_of(Index y, Index x) const {
    const bool is_end = surfaces[y].name == rules.topography || surfaces[y].name == rules.floor;
    if (is_end || rules.of(y).fills_blocks()) return faults_but(x);
    std::vector<Index> faults = y < built.parted_at.size() ? built.parted_at[y] : std::vector<Index>{};
    std::erase(faults, x);
    return faults;
  }

  /// Adds all other horizons of the column to the surfaces at which pieces of horizon x end when it is cut by horizon
  /// y. Beyond a horizon on which y ends, x may meet y again from its other side.
  void add_others_of_column(Index x, Index y, std::vector<Index>& dividers) const {
    for (std::size_t i = 1; i < rules.column.size(); i += 2)
      if (const Index row = row_of(rules.column[i]); row != x && row != y) dividers.push_back(row);
  }

  /// Returns 1 if most of a piece of another surface lies above surface y, -1 if below, 0 if unknown.
  int side_of_piece(const Piece& piece, Index y, const std::optional<HeightVote>& heights, bool is_divided) {
    const int by_height = heights ? heights->side_of(piece) : 0;
    if (by_height != 0) return by_height;
    const bool is_beyond_a_fault = heights && is_divided && piece.above == piece.below;
    return is_beyond_a_fault ? 0 : side_of(working, piece, y, sides_of(y));
  }

  /// Removes the pieces of surface x on one side of surface y (1 above, -1 below).
  void clip(Index x, Index y, int side, const std::string& because, double least_of_step = share_of_step) {
    double area = 0;
    Index largest = no_index;
    const UpwardSides& sides = sides_of(y);
    std::vector<Piece> gone;
    const bool are_horizons = surfaces[x].kind == SurfaceKind::horizon && surfaces[y].kind == SurfaceKind::horizon;
    const BeyondEnd beyond = are_horizons ? BeyondEnd::has_none : BeyondEnd::has_a_side;
    std::optional<HeightVote> heights;
    if (are_horizons) heights.emplace(working, y, surfaces);
    const std::vector<Index> faults = dividers_of(y, x);
    std::vector<Index> dividers = faults;
    if (are_horizons) add_others_of_column(x, y, dividers);
    for (Piece& piece : pieces_of(working, x, {y}, &sides, beyond, dividers)) {
      if ((surfaces[x].kind == SurfaceKind::fault || surfaces[x].kind == SurfaceKind::body) &&
          is_step(piece, least_of_step)) {
        if (surfaces[y].kind == SurfaceKind::fault)
          warnings.push_back(because + ", but " + surfaces[x].name + " passes round the end of " + surfaces[y].name +
                             " near " + to_text(working.centre(piece.largest)) + " and is kept there");
        continue;
      }
      if (side_of_piece(piece, y, heights, !faults.empty()) == side) gone.push_back(std::move(piece));
    }
    for (const Piece& piece : gone) {
      if (largest == no_index || working.area(piece.largest) > working.area(largest)) largest = piece.largest;
      area += remove(piece, x);
    }
    if (!gone.empty())
      notes.push_back(because + ": " + std::to_string(gone.size()) + " pieces of " + surfaces[x].name +
                      (side > 0 ? " above " : " below ") + surfaces[y].name + " removed (area " + to_text(area) +
                      ", near " + to_text(working.centre(largest)) + ")");
  }
};

/// Removes pieces of surface s that surface `target` cuts off, if they consist only of the extension of s.
void stop_at(Trimming& work, Index s, Index target) {
  double area = 0;
  std::size_t n = 0;
  for (const Piece& piece : pieces_of(work.working, s, {target}, nullptr)) {
    const bool given = std::any_of(piece.facets.begin(), piece.facets.end(),
                                   [&](Index f) { return work.is_given(*work.working.origin_of(f, s)); });
    if (given) continue;
    area += work.remove(piece, s);
    ++n;
  }
  if (n > 0)
    work.notes.push_back("surface " + work.surfaces[s].name + " ends at " + work.surfaces[target].name + ": " +
                         std::to_string(n) + " continued pieces beyond it removed (area " + to_text(area) + ")");
}

/// Applies the rule stop_at to all surfaces, to its target before the surface itself: a surface that ends on another
/// one must not continue beyond what remains of it.
void stop_continuations(Trimming& work) {
  std::vector<bool> done(work.n_given(), false);
  const std::function<void(Index)> stop = [&](Index s) {
    if (s >= work.n_given() || done[s]) return;
    done[s] = true;
    const std::string target = work.rules.of(s).stop_at;
    if (target.empty()) return;
    stop(work.row_of(target));
    stop_at(work, s, work.row_of(target));
  };
  for (Index s = 0; s < work.n_given(); ++s) stop(s);
}

/// Applies the rule cut_units, by which a fault cuts some units only: removes its pieces above and below these.
void cut_units_alone(Trimming& work, Index s) {
  const std::vector<std::string> units = work.rules.of(s).cut_units;
  if (units.empty()) return;
  const auto unit_row = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(work.rules.column.begin(), work.rules.column.end(), name) -
                                    work.rules.column.begin()) /
           2;
  };
  std::size_t first = work.rules.column.size(), last = 0;
  for (const std::string& unit : units) {
    first = std::min(first, unit_row(unit));
    last = std::max(last, unit_row(unit));
  }
  const std::string because = "fault " + work.surfaces[s].name + " cuts " + units.front() +
                              (units.size() > 1 ? " to " + units.back() : "") + " alone";
  for (std::size_t h = 0; 2 * h + 1 < work.rules.column.size(); ++h) {
    const Index horizon = work.row_of(work.rules.column[2 * h + 1]);
    if (h < first) work.clip(s, horizon, 1, because);
    if (h >= last) work.clip(s, horizon, -1, because);
  }
}

/// Removes the parts of all other surfaces on one side of the named surface. Sides of the box are not cut here; they
/// are removed together with the tetrahedra beyond the surface.
void end_at(Trimming& work, const std::string& name, int side, const std::string& because) {
  if (name.empty()) return;
  const Index end = work.row_of(name);
  for (const bool are_faults : {false, true})  // faults divide the other surfaces and are therefore cut last
    for (Index s = 0; s < work.surfaces.size(); ++s)
      if (s != end && work.surfaces[s].kind != SurfaceKind::box &&
          (work.surfaces[s].kind == SurfaceKind::fault) == are_faults)
        work.clip(s, end, side, because, share_at_end);
}

/// Throws Error{invalid_input} if the younger horizon runs below the older one.
void refuse_crossing(Trimming& work, Index younger, Index older) {
  double area = 0;
  Vec3 place;
  const UpwardSides& sides = work.sides_of(older);
  const HeightVote heights(work.working, older, work.surfaces);
  for (const Piece& piece : pieces_of(work.working, younger, {older}, &sides, BeyondEnd::has_none)) {
    const int by_height = heights.side_of(piece);
    if (piece.contact > 0 && (by_height < 0 || (by_height == 0 && piece.below > piece.above))) {
      area += piece.area;
      place = work.working.centre(piece.largest);
    }
  }
  if (area > 0)
    throw Error(ErrorKind::invalid_input,
                "horizon " + work.surfaces[younger].name + " runs below the older horizon " +
                    work.surfaces[older].name + " over an area of " + to_text(area) + " near " + to_text(place) +
                    "; correct one of them, or choose on_crossing: clip_younger or clip_older",
                {{}, {}, {}, {place}});
}

std::string reason_of_domain(const Trimming& work, Index s, Index bound, bool is_above) {
  return "the field of " + work.surfaces[s].name + " holds " + (is_above ? "above " : "below ") +
         work.surfaces[bound].name + " alone";
}

BuiltSurfaces built_surfaces(const Trimming& work) {
  BuiltSurfaces built;
  built.surfaces.assign(work.surfaces.begin(), work.surfaces.begin() + work.n_given());
  built.rows = work.built;
  return built;
}

/// Returns, for a note, why one of two horizons cuts the other where they cross; empty if no rule applies.
std::string reason_to_cut(const Trimming& work, Index younger, Index older, Keeper keeper) {
  const bool younger_stays = keeper == Keeper::younger;
  const auto is_in = [&](const std::vector<std::string>& names, Index row) {
    return std::find(names.begin(), names.end(), work.surfaces[row].name) != names.end();
  };
  if (!younger_stays && is_in(work.rules.of(younger).holds_above, older))
    return reason_of_domain(work, younger, older, true);
  if (younger_stays && is_in(work.rules.of(older).holds_below, younger))
    return reason_of_domain(work, older, younger, false);
  if (younger_stays && work.rules.of(younger).base == BaseRule::erode) return work.surfaces[younger].name + " erodes";
  if (!younger_stays && work.rules.of(older).base == BaseRule::onlap) return work.surfaces[younger].name + " onlaps";
  if (younger_stays && work.rules.on_crossing == OnCrossing::clip_older)
    return "crossing resolved for the younger horizon";
  if (!younger_stays && work.rules.on_crossing == OnCrossing::clip_younger)
    return "crossing resolved for the older horizon";
  return "";
}

/// Applies the rules of each pair of horizons in the order of deposition: each horizon is cut by those older ones that
/// are kept, then cuts the others, starting with the oldest. Parts that were eroded before a horizon was deposited do
/// not cut that horizon.
void order_horizons(Trimming& work) {
  std::vector<Index> rows;  // youngest first
  for (std::size_t i = 1; i < work.rules.column.size(); i += 2) rows.push_back(work.row_of(work.rules.column[i]));
  const Keepers keepers = keepers_of(work.rules, rows, work.surfaces);
  for (std::size_t younger = rows.size(); younger-- > 0;)
    for (const Keeper stays : {Keeper::older, Keeper::younger})
      for (std::size_t older = rows.size(); --older > younger;) {
        const Keeper keeper = keepers.of(younger, older);
        if (keeper != stays) continue;
        const std::string because = reason_to_cut(work, rows[younger], rows[older], keeper);
        if (!because.empty() && stays == Keeper::younger) work.clip(rows[older], rows[younger], 1, because);
        if (!because.empty() && stays == Keeper::older) work.clip(rows[younger], rows[older], -1, because);
        if (because.empty() && work.rules.on_crossing == OnCrossing::error)
          refuse_crossing(work, rows[younger], rows[older]);
      }
}

/// Removes the parts of surface `s` outside the domain of its field, if that is not valid everywhere, except the parts
/// that order_horizons() and part_blocks() remove.
void end_at_domain(Trimming& work, Index s) {
  const auto& column = work.rules.column;
  const auto is_of_column = [&](Index row) {
    return std::find(column.begin(), column.end(), work.surfaces[row].name) != column.end();
  };
  const SurfaceRules rule = work.rules.of(s);
  for (const bool is_above : {true, false})
    for (const std::string& name : is_above ? rule.holds_above : rule.holds_below) {
      const Index bound = work.row_of(name);
      if (is_of_column(s) && is_of_column(bound)) continue;
      work.clip(s, bound, is_above ? -1 : 1, reason_of_domain(work, s, bound, is_above));
    }
}

/// Determines whether points lie in the domain of a scalar field of surface `s`. On the faults, horizons and fault
/// blocks that bound the domain, either answer may result.
class DomainSides {
 public:
  DomainSides(const Trimming& work, Index s, const FieldPart& part, const Parting& parting)
      : part_(part), in_one_block_(parting.in_one_block) {
    for (const auto& [fault, is_above] : part.sides) add(work, fault, is_above);
    const SurfaceRules rule = work.rules.of(s);
    for (const std::string& name : rule.holds_above) add(work, name, true);
    for (const std::string& name : rule.holds_below) add(work, name, false);
  }

  bool hold(const Vec3& p) const {
    for (const auto& [fault, is_above] : faults_)
      if (fault.is_above(p) != is_above) return false;
    for (const auto& bound : horizons_) {
      const MapLocator& horizon = *bound.first;
      bool is_over = false, is_on_side = false;
      horizon.for_each({p.x, p.y}, [&](Index triangle, bool) {
        is_over = true;
        is_on_side |= (p.z > horizon.height(triangle, {p.x, p.y})) == bound.second;
      });
      if (is_over && !is_on_side) return false;
    }
    return !part_.block || in_one_block_(p, *part_.block);
  }

 private:
  void add(const Trimming& work, const std::string& name, bool is_above) {
    const TriangulatedSurface& surface = work.surfaces[work.row_of(name)];
    if (surface.triangles.empty()) return;
    if (surface.kind == SurfaceKind::fault)
      faults_.emplace_back(FaultSides(surface), is_above);
    else
      horizons_.emplace_back(std::make_unique<MapLocator>(surface), is_above);
  }

  const FieldPart& part_;
  const std::function<bool(const Vec3&, const Vec3&)>& in_one_block_;
  std::vector<std::pair<FaultSides, bool>> faults_;
  std::vector<std::pair<std::unique_ptr<MapLocator>, bool>> horizons_;
};

/// Warns that the contour of a scalar field may be wrong at certain triangles or places, if the final model contains
/// any of these. Those outside the field's domain do not matter.
void warn_of_doubts(Trimming& work, const Parting& parting) {
  for (Index s = 0; s < work.n_given(); ++s) {
    const std::vector<FieldPart> parts = work.rules.of(s).field_parts;
    if (std::all_of(parts.begin(), parts.end(), [](const FieldPart& part) { return part.doubts.empty(); })) continue;
    std::vector<bool> is_kept(work.surfaces[s].triangles.size(), false);
    for (const auto& origins : work.working.origins)
      for (const PolygonSoup::Origin& o : origins)
        if (o.surface == s) is_kept[o.triangle] = true;
    for (const FieldPart& part : parts) {
      const DomainSides sides(work, s, part, parting);
      for (const FieldPart::Doubt& doubt : part.doubts)
        if (std::any_of(doubt.triangles.begin(), doubt.triangles.end(), [&](Index t) { return is_kept[t]; }) ||
            std::any_of(doubt.places.begin(), doubt.places.end(), [&](const Vec3& p) { return sides.hold(p); }))
          work.warnings.push_back(doubt.warning);
    }
  }
}

/// Removes, from horizons that fill their fault blocks, the data beyond the fault at which they should end.
void end_data_at_faults(Trimming& work) {
  std::optional<BlockFramework> blocks;  // fault blocks, computed when the first surface is found to overshoot another
  for (Index s = 0; s < work.n_given(); ++s) {
    if (!work.rules.of(s).fills_blocks()) continue;
    MeantEnd end{s, work.faults_but(s), work.rules.continuation.within_of_horizons, part_of(work.built, s)};
    if (!(end.limit > 0) || overshoots_of(work.working, end).empty()) continue;
    if (!blocks) blocks.emplace(built_surfaces(work), work.rules);
    end.blocks = &*blocks;
    work.removed[s] += remove_overshoots(work.working, end, work.surfaces[s].name, work.notes);
  }
}

/// Applies the rule trim_overshoot to horizons and faults, relative to all other surfaces.
void trim_overshoots(Trimming& work) {
  for (Index s = 0; s < work.surfaces.size(); ++s) {
    if (work.surfaces[s].kind != SurfaceKind::horizon && work.surfaces[s].kind != SurfaceKind::fault) continue;
    std::vector<Index> cutters;
    for (Index c = 0; c < work.surfaces.size(); ++c)
      if (c != s && work.surfaces[c].kind != SurfaceKind::box) cutters.push_back(c);
    work.removed[s] +=
        remove_overshoots(work.working, {s, cutters, work.rules.trim_overshoot}, work.surfaces[s].name, work.notes);
  }
}

}  // namespace

TrimmedSoup trim_soup(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                      const ModelRules& rules) {
  Trimming work{WorkingSoup(soup), surfaces, built, rules, std::vector<double>(surfaces.size(), 0)};
  std::optional<BlockFramework> blocks;  // fault blocks, computed when the first field is valid in one of them
  const auto in_one_block = [&](const Vec3& p, const Vec3& q) {
    if (!blocks) blocks.emplace(built_surfaces(work), rules);
    return blocks->block_at(p) == blocks->block_at(q);
  };
  const Parting parting{work.working, surfaces, built, rules, work.removed, work.notes, work.warnings, in_one_block};
  const auto is_end = [&](Index s) { return surfaces[s].name == rules.topography || surfaces[s].name == rules.floor; };
  for (Index s = 0; s < work.n_given(); ++s)
    // Topography and base are divided into blocks first, because other surfaces end at the parts that remain.
    if (is_end(s)) part_blocks(parting, s);
  end_at(work, rules.topography, 1, "nothing is kept above the topography");
  end_at(work, rules.floor, -1, "nothing is kept below the bottom of the model");
  stop_continuations(work);
  end_faults(work.working, surfaces, built, rules.continuation.within_of_faults, {work.removed, work.notes});
  for (Index s = 0; s < work.n_given(); ++s)
    if (surfaces[s].kind == SurfaceKind::fault) end_at_domain(work, s);
  // Continued horizons end at faults, but only at the parts that the rules for faults have not removed.
  for (Index s = 0; s < built.part_of_triangle.size(); ++s)
    if (surfaces[s].kind != SurfaceKind::fault && !built.part_of_triangle[s].empty())
      work.removed[s] += end_at_walls(work.working, surfaces, built, s);
  for (Index s = 0; s < work.n_given(); ++s)
    if (!is_end(s)) part_blocks(parting, s);
  remove_continuations(parting);
  truncate_faults(work.working, surfaces, built, rules.continuation.within_of_faults, work.removed, work.notes);
  end_data_at_faults(work);
  for (Index s = 0; s < work.n_given(); ++s)
    if (surfaces[s].kind != SurfaceKind::fault) end_at_domain(work, s);
  order_horizons(work);
  for (Index s = 0; s < work.n_given(); ++s) cut_units_alone(work, s);
  if (rules.trim_overshoot > 0) trim_overshoots(work);
  warn_of_doubts(work, parting);
  return {work.working.result(), std::move(work.removed), std::move(work.notes), std::move(work.warnings)};
}

}  // namespace geomesh::geomodel

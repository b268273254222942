// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/horizon_group.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "geomesh/core/predicates.hpp"
#include "naming/region_facts.hpp"
#include "rules/planar/borders.hpp"
#include "stack/map/shallow_crossings.hpp"
#include "stack/settled_report.hpp"
#include "stack/sheets/centred_sheets.hpp"
#include "stack/sheets/closing_rows.hpp"
#include "stack/thickness_sizes.hpp"
#include "stack/throw/lost_blocks.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double lattice_of_size = 2;
constexpr double area_of_size = 0.43;  // area of an equilateral triangle divided by the square of its edge
// Ratio of a horizon's number of triangles to the number that the target size requires, above which the horizon has too
// many.
constexpr double many_triangles = 4;
// Fraction of samples in the wrong order up to which reordering the horizons is not worthwhile.
constexpr double few_samples = 0.01;
// Least thickness of a unit if none is given, as a fraction of the target size; at least half of the tolerance.
constexpr double thickness_of_size = 1.0 / 150;
constexpr double room_of_thickness = 2;  // at pinch-out lines
// Width over which a unit closes towards its pinch-out line, as a multiple of the least thickness: an angle of 5
// degrees.
constexpr double row_of_thickness = 12;
// Pinch-out lines are shifted by half the width over which a unit closes, at most by this fraction of the target size.
constexpr double most_shift = 0.15;
constexpr double edge_of_thickness = 24;  // largest length of edges in a thin unit, as a multiple of its thickness
// Constraint lines of the map closer to each other than this fraction of MapSamples::border_reach() are merged.
constexpr double joined_of_reach = 0.25;

double map_area(const MapBounds& b) { return (b.max.x - b.min.x) * (b.max.y - b.min.y); }

/// Returns whether the horizons have many more triangles within the bounds than the target size requires.
bool has_many_triangles(const std::vector<const TriangulatedSurface*>& horizons, const MapBounds& bounds, double size) {
  std::size_t n = 0;
  for (const TriangulatedSurface* s : horizons)
    for (const Triangle& t : s->triangles) n += bounds.holds({s->points[t[0]].x, s->points[t[0]].y});
  const double asked = static_cast<double>(horizons.size()) * map_area(bounds) / (area_of_size * size * size);
  return static_cast<double>(n) > many_triangles * asked;
}

/// Adds border edges of horizons without throw to the map's constraint lines, except edges outside or along its bounds.
void add_borders(const std::vector<BlockData>& horizons, MapLayout& layout) {
  const MapBounds near = layout.bounds;
  for (const BlockData& horizon : horizons) {
    if (horizon.has_throw()) continue;
    const TriangulatedSurface& s = horizon.single;
    for (const BorderEdge& e : border_edges(s)) {
      const Vec2 a{s.points[e.a].x, s.points[e.a].y}, b{s.points[e.b].x, s.points[e.b].y};
      const bool beside = std::max(a.x, b.x) <= near.min.x || std::min(a.x, b.x) >= near.max.x ||
                          std::max(a.y, b.y) <= near.min.y || std::min(a.y, b.y) >= near.max.y;
      if (!beside) layout.lines.push_back({a, b});
    }
  }
}

/// Sets heights to zero that are zero up to rounding. Corrections are passed on from vertex to vertex, so that next to
/// a level area (the sea at height 0) they decay below what exact arithmetic can represent.
void flush_heights_that_vanish(std::vector<Vec3>& points) {
  for (Vec3& p : points)
    if (p.z != 0 && std::isfinite(p.z) && !exponents_are_safe(std::span(&p, 1)) && std::abs(p.z) < 1) p.z = 0;
}

}  // namespace

HorizonGroup::HorizonGroup(GroupMembers members, BuiltSurfaces& built, const ModelRules& rules, const MapFrame& frame)
    : members_(std::move(members)), built_(built), rules_(rules), frame_(frame) {
  for (const BlockData& data : members_.data) horizons_.push_back(&data.single);
  layout_.bounds = members_.bounds;
  layout_.lattice = lattice_of_size * rules.stack.size;
  add_borders(members_.data, layout_);
  strips_ = find_fault_strips(members_.data, layout_.bounds, rules.stack.size);
  layout_.keeps_lines = ends_inside();
  samples_ = std::make_unique<MapSamples>(horizons_, layout_.bounds.grown(rules.stack.size));
}

std::size_t HorizonGroup::first_that_overhangs() const {
  for (std::size_t k = 0; k < horizons_.size(); ++k)
    if (!members_.data[k].has_throw() && samples_->overhangs(k)) return k;
  return horizons_.size();
}

Settling HorizonGroup::settle() {
  if (first_that_overhangs() < horizons_.size()) return Settling::overhangs;
  const double size = rules_.stack.size, thickness = least_thickness();
  const SheetOptions options{members_.stack.keepers, stack_share * rules_.stack.tolerance, thickness,
                             room_of_thickness * thickness, members_.stack.units.empty()};
  const double shift = std::min(0.5 * row_of_thickness * thickness, most_shift * size);
  const std::vector<ThinArea> areas =
      find_thin_areas(*samples_, layout_.bounds, members_.stack.keepers, {size, thickness, shift});
  const bool is_thin = std::any_of(areas.begin(), areas.end(), [](const ThinArea& a) { return a.any(); });
  const bool is_wanted = (is_thin && rules_.min_thickness > 0) || crosses_by_mistake();
  if (!is_wanted && !has_many_triangles(horizons_, layout_.bounds, size) &&
      !cross_at_small_angle(*samples_, layout_.bounds, size))
    return Settling::not_needed;
  sheets_ = draw_sheets(areas, options);
  sided_.resize(horizons_.size());
  if (has_throw() && !add_sides(options)) return Settling::refused;
  describe(areas, options);
  if (moves_alone()) {
    built_.notes.push_back("horizon " + horizons_[0]->name +
                           " is left as given: triangles of the size would not follow its blocks");
    return Settling::refused;
  }
  ask_for_sizes(thickness);
  return Settling::settled;
}

TriangulatedSurface HorizonGroup::sheet(std::size_t horizon) const {
  TriangulatedSurface s = given(horizon);
  const bool is_up = faces_up(given(horizon), Frame{});
  s.points.clear();
  s.triangles.clear();
  std::vector<VertexIndex> row(sheets_.points.size(), no_vertex);
  for (const Triangle& t : sheets_.triangles) {
    const Vec2 &a = sheets_.points[t[0]], &b = sheets_.points[t[1]], &c = sheets_.points[t[2]];
    const bool complete =
        std::none_of(t.begin(), t.end(), [&](VertexIndex v) { return std::isnan(sheets_.height(v, horizon)); });
    if (!complete || !samples_->covers(horizon, {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3})) continue;
    Triangle own = t;
    for (VertexIndex& v : own) {
      if (row[v] == no_vertex) {
        row[v] = static_cast<VertexIndex>(s.points.size());
        const Vec2 p = frame_.to_model(sheets_.points[v]);
        s.points.push_back({p.x, p.y, sheets_.height(v, horizon)});
      }
      v = row[v];
    }
    if (!is_up) std::swap(own[1], own[2]);
    s.triangles.push_back(own);
  }
  flush_heights_that_vanish(s.points);
  return s;
}

TriangulatedSurface HorizonGroup::surface_with_throw(std::size_t horizon) const {
  TriangulatedSurface s = given(horizon);
  const bool is_up = faces_up(given(horizon), Frame{});
  s.points = sided_[horizon].points;
  s.triangles = sided_[horizon].triangles;
  for (Vec3& p : s.points) {
    const Vec2 q = frame_.to_model(Vec2{p.x, p.y});
    p = {q.x, q.y, p.z};
  }
  flush_heights_that_vanish(s.points);
  if (!is_up)
    for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}

/// Returns whether neighbouring horizons are in the wrong order at many samples, without a rule on which one cuts.
bool HorizonGroup::crosses_by_mistake() const {
  if (rules_.on_crossing != OnCrossing::leave) return false;
  const std::vector<Index>& rows = members_.stack.rows;
  for (std::size_t k = 0; k + 1 < horizons_.size(); ++k) {
    if (rules_.of(rows[k]).base == BaseRule::erode || rules_.of(rows[k + 1]).base == BaseRule::onlap ||
        given(k).name == rules_.topography || given(k + 1).name == rules_.floor)
      continue;
    std::size_t n = 0;
    for (std::size_t s = 0; s < samples_->size(); ++s) n += samples_->heights(s)[k] < samples_->heights(s)[k + 1];
    if (static_cast<double>(n) > few_samples * static_cast<double>(samples_->size())) return true;
  }
  return false;
}

/// Returns the first horizon with throw that loses a block at the target size; the number of horizons if none does.
std::size_t HorizonGroup::first_lost() const {
  for (std::size_t k = 0; k < sided_.size(); ++k)
    if (has_throw(k) && loses_blocks(members_.data[k], sided_[k], {members_.faults[k], frame_, layout_.bounds}))
      return k;
  return sided_.size();
}

/// Returns the first horizon that keeps its height by the rules but would have to move by more than the tolerance,
/// because the horizon that should move instead has no throw there; the number of horizons if there is none.
std::size_t HorizonGroup::first_against_rule() const {
  const auto at = std::find_if(sided_.begin(), sided_.end(),
                               [&](const SidedHorizon& s) { return s.largest_against_rule > rules_.stack.tolerance; });
  return static_cast<std::size_t>(at - sided_.begin());
}

/// Returns whether a horizon that is alone in the stack would move by more than the tolerance. No other horizon then
/// requires the move: triangles of the target size cannot follow the horizon's fault blocks.
bool HorizonGroup::moves_alone() const {
  const SettledHorizon& told = told_.horizons.front();
  return members_.stack.units.empty() && has_throw() &&
         std::max(told.largest_move, told.largest_move_at_faults) > rules_.stack.tolerance;
}

bool HorizonGroup::has_throw() const {
  return std::any_of(members_.data.begin(), members_.data.end(),
                     [](const BlockData& data) { return data.has_throw(); });
}

double HorizonGroup::least_thickness() const {
  if (rules_.min_thickness > 0) return rules_.min_thickness;
  return std::max(stack_share * rules_.stack.tolerance, thickness_of_size * rules_.stack.size);
}

MapSheets HorizonGroup::draw_sheets(const std::vector<ThinArea>& areas, const SheetOptions& options) {
  layout_.lines.insert(layout_.lines.end(), strips_.outlines.begin(), strips_.outlines.end());
  for (const ThinArea& area : areas) layout_.lines.insert(layout_.lines.end(), area.curves.begin(), area.curves.end());
  layout_.joined_within = joined_of_reach * samples_->border_reach();
  MapSheets sheets = approximate_sheets(*samples_, layout_, areas, options);
  close_units(sheets, *samples_, options, row_of_thickness * options.gap);
  centre_sheets(sheets, *samples_, areas, options);
  return sheets;
}

bool HorizonGroup::add_sides(const SheetOptions& options) {
  sided_ = make_both_sides(sheets_, {members_.data, members_.faults, strips_, frame_, *rules_.box, options});
  if (const std::size_t k = first_lost(); k < sided_.size()) {
    built_.notes.push_back("the stack is left as given: triangles of the size would not hold the blocks of horizon " +
                           horizons_[k]->name + " beside its faults");
    return false;
  }
  if (const std::size_t k = first_against_rule(); k < sided_.size()) {
    built_.notes.push_back("the stack is left as given: at the faults of horizon " + horizons_[k]->name +
                           " one gives way to it that has no throw there (throw_at of that one)");
    return false;
  }
  return true;
}

void HorizonGroup::describe(const std::vector<ThinArea>& areas, const SheetOptions& options) {
  const bool has_topography = !rules_.topography.empty() && given(0).name == rules_.topography;
  SettledFrom from{*samples_, areas, frame_.bounds(rules_.stack.outline), options, strips_, has_topography, {}};
  if (members_.counts)
    from.counts = [&](const Vec3& p) {
      const Vec2 q = frame_.to_model(Vec2{p.x, p.y});
      return members_.counts({q.x, q.y, p.z});
    };
  told_ = describe_settled(sheets_, from);
  told_.min_thickness = options.gap;
  const Stack& stack = members_.stack;
  for (std::size_t k = 0; k < horizons_.size(); ++k) {
    SettledHorizon& told = told_.horizons[k];
    told.name = given(k).name;
    const Vec2 place = frame_.to_model(Vec2{told.place.x, told.place.y});
    told.place = {place.x, place.y, told.place.z};
    if (!has_throw(k)) continue;
    told.area_at_faults = sided_[k].area;
    told.largest_move_at_faults = sided_[k].largest_move;
    const Vec2 at_faults = frame_.to_model(Vec2{sided_[k].place.x, sided_[k].place.y});
    told.place_at_faults = {at_faults.x, at_faults.y, sided_[k].place.z};
  }
  for (std::size_t k = 0; k < stack.units.size(); ++k) {
    told_.units[k].name = stack.units[k];
    told_.units[k].top = told_.horizons[k].name;
    told_.units[k].base = told_.horizons[k + 1].name;
  }
}

void HorizonGroup::ask_for_sizes(double thickness) {
  told_.sizes = sizes_of_thickness(sheets_, layout_.bounds, {rules_.stack.size, thickness, edge_of_thickness});
  for (SizeSource& source : told_.sizes) {
    const Vec2 place = frame_.to_model(Vec2{source.point.x, source.point.y});
    source.point = {place.x, place.y, source.point.z};
  }
  if (members_.counts) std::erase_if(told_.sizes, [&](const SizeSource& s) { return !members_.counts(s.point); });
}

}  // namespace geomesh::geomodel

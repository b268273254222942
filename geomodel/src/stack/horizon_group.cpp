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

namespace geomesh::geomodel {
namespace {

constexpr double lattice_of_size = 2;
constexpr double area_of_size = 0.43;  // area of an equilateral triangle divided by the square of its edge
constexpr double many_triangles = 4;
constexpr double few_samples = 0.01;  // share of samples in the wrong order up to which settling is not worth while
constexpr double thickness_of_size = 1.0 / 150;
constexpr double room_of_thickness = 2;  // at pinch-out lines
constexpr double row_of_thickness = 12;
constexpr double most_shift = 0.15;  // shift of pinch-out lines by half of that width, at most this share of the size
constexpr double edge_of_thickness = 24;  // largest length of edges in a unit, as a multiple of its thickness
constexpr double joined_of_reach = 0.25;  // lines closer than this share of the border reach are merged

double map_area(const MapBounds& b) { return (b.max.x - b.min.x) * (b.max.y - b.min.y); }

/// Returns whether the surfaces have many more triangles within the bounds than the target size requires.
bool has_many_triangles(const std::vector<const TriangulatedSurface*>& horizons, const MapBounds& bounds, double size) {
  std::size_t n = 0;
  for (const TriangulatedSurface* s : horizons)
    for (const Triangle& t : s->triangles) n += bounds.holds({s->points[t[0]].x, s->points[t[0]].y});
  const double asked = static_cast<double>(horizons.size()) * map_area(bounds) / (area_of_size * size * size);
  return static_cast<double>(n) > many_triangles * asked;
}

/// Borders of the horizons that reach into the bounds; those along a side of the bounds do not.
void add_borders(const std::vector<TriangulatedSurface>& horizons, MapLayout& layout) {
  const MapBounds near = layout.bounds;
  for (const TriangulatedSurface& s : horizons) {
    for (const BorderEdge& e : border_edges(s)) {
      const Vec2 a{s.points[e.a].x, s.points[e.a].y}, b{s.points[e.b].x, s.points[e.b].y};
      const bool beside = std::max(a.x, b.x) <= near.min.x || std::min(a.x, b.x) >= near.max.x ||
                          std::max(a.y, b.y) <= near.min.y || std::min(a.y, b.y) >= near.max.y;
      if (!beside) layout.lines.push_back({a, b});
    }
  }
}

/// Settling propagates corrections from vertex to vertex, so that next to a level area (the sea at height 0) they decay
/// below what exact arithmetic can represent. Such heights are zero up to rounding, and are set to zero.
void flush_heights_that_vanish(std::vector<Vec3>& points) {
  for (Vec3& p : points)
    if (p.z != 0 && std::isfinite(p.z) && !exponents_are_safe(std::span(&p, 1)) && std::abs(p.z) < 1) p.z = 0;
}

}  // namespace

HorizonGroup::HorizonGroup(GroupMembers members, BuiltSurfaces& built, const ModelRules& rules, const MapFrame& frame)
    : members_(std::move(members)), built_(built), rules_(rules), frame_(frame) {
  for (const TriangulatedSurface& data : members_.data) horizons_.push_back(&data);
  layout_.bounds = members_.bounds;
  layout_.lattice = lattice_of_size * rules.stack.size;
  add_borders(members_.data, layout_);
  layout_.keeps_lines = ends_inside();
  samples_ = std::make_unique<MapSamples>(horizons_, layout_.bounds.grown(rules.stack.size));
}

std::size_t HorizonGroup::first_that_overhangs() const {
  for (std::size_t k = 0; k < horizons_.size(); ++k)
    if (samples_->overhangs(k)) return k;
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
  describe(areas, options);
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

/// Returns whether neighbouring horizons, for which no rule says which one cuts the other, are in the wrong order at
/// more than a few samples.
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

double HorizonGroup::least_thickness() const {
  if (rules_.min_thickness > 0) return rules_.min_thickness;
  return std::max(stack_share * rules_.stack.tolerance, thickness_of_size * rules_.stack.size);
}

MapSheets HorizonGroup::draw_sheets(const std::vector<ThinArea>& areas, const SheetOptions& options) {
  for (const ThinArea& area : areas) layout_.lines.insert(layout_.lines.end(), area.curves.begin(), area.curves.end());
  layout_.joined_within = joined_of_reach * samples_->border_reach();
  MapSheets sheets = approximate_sheets(*samples_, layout_, areas, options);
  close_units(sheets, *samples_, options, row_of_thickness * options.gap);
  centre_sheets(sheets, *samples_, areas, options);
  return sheets;
}

void HorizonGroup::describe(const std::vector<ThinArea>& areas, const SheetOptions& options) {
  const bool has_topography = !rules_.topography.empty() && given(0).name == rules_.topography;
  SettledFrom from{*samples_, areas, frame_.bounds(rules_.stack.outline), options, has_topography, {}};
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

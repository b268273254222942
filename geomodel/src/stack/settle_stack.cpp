// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/settle_stack.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "geomesh/core/predicates.hpp"
#include "naming/region_facts.hpp"
#include "rules/planar/borders.hpp"
#include "stack/map/map_frame.hpp"
#include "stack/map/shallow_crossings.hpp"
#include "stack/settled_report.hpp"
#include "stack/sheets/centred_sheets.hpp"
#include "stack/sheets/closing_rows.hpp"
#include "stack/sheets/sheet_approximation.hpp"
#include "stack/stack_members.hpp"
#include "stack/thickness_sizes.hpp"
#include "stack/throw/both_sides.hpp"
#include "stack/throw/lost_blocks.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double lattice_of_size = 2;
constexpr double area_of_size = 0.43;            // of a triangle with sides of the size, over its square
constexpr double many_triangles = 4;             // times those that the size asks for
constexpr double few_samples = 0.01;             // share of those in the wrong order that nothing is settled for
constexpr double thickness_of_size = 1.0 / 150;  // least thickness where none is given, or half of the tolerance
constexpr double room_of_thickness = 2;          // at pinch-out lines
constexpr double row_of_thickness = 12;          // over which a unit closes: at 5 degrees
constexpr double most_shift = 0.15;              // of the size: of pinch-out lines, by half of that row
constexpr double edge_of_thickness = 24;         // edges in a unit are at most so long
constexpr double joined_of_reach = 0.25;         // lines that far apart are one, of how far borders reach
constexpr double margin_of_size = 0.25;          // about an outline that is no box along the axes

/// Why the stack cannot be settled; empty: it can.
std::string obstacle(const Stack& stack, const BuiltSurfaces& built) {
  if (stack.rows.size() > most_horizons) return "it has more than " + std::to_string(most_horizons) + " horizons";
  if (stack.rows.size() != stack.units.size() + 1) return "a horizon of the column is not there";
  for (const Index row : stack.rows) {
    const TriangulatedSurface& s = built.surfaces[row];
    if (!is_single_valued_by_block(s, built.rows.block_of_triangle[row], built.rows.n_given_triangles[row]))
      return "horizon " + s.name + " has more than one height over a place of the map";
  }
  return "";
}

double map_area(const MapBounds& b) { return (b.max.x - b.min.x) * (b.max.y - b.min.y); }

/// More triangles within bounds than the size asks for, by far.
bool has_many_triangles(const std::vector<const TriangulatedSurface*>& horizons, const MapBounds& bounds, double size) {
  std::size_t n = 0;
  for (const TriangulatedSurface* s : horizons)
    for (const Triangle& t : s->triangles) n += bounds.holds({s->points[t[0]].x, s->points[t[0]].y});
  const double asked = static_cast<double>(horizons.size()) * map_area(bounds) / (area_of_size * size * size);
  return static_cast<double>(n) > many_triangles * asked;
}

/// Borders of the horizons without throw that reach into the bounds; those along a side of the bounds do not.
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

/// Settling passes corrections on from vertex to vertex, so that beside a level place (the sea at height 0) they decay
/// below what exact arithmetic can hold. Such heights are zero up to rounding by any measure, and are set to it.
void flush_heights_that_vanish(std::vector<Vec3>& points) {
  for (Vec3& p : points)
    if (p.z != 0 && std::isfinite(p.z) && !exponents_are_safe(std::span(&p, 1)) && std::abs(p.z) < 1) p.z = 0;
}

/// The horizon's part of the sheets, oriented as the horizon was.
TriangulatedSurface sheet_of(const MapSheets& sheets, std::size_t horizon, const MapSamples& samples,
                             const TriangulatedSurface& given, const MapFrame& frame) {
  TriangulatedSurface s = given;
  const bool faces_up = geomodel::faces_up(given, Frame{});
  s.points.clear();
  s.triangles.clear();
  std::vector<VertexIndex> row(sheets.points.size(), no_vertex);
  for (const Triangle& t : sheets.triangles) {
    const Vec2 &a = sheets.points[t[0]], &b = sheets.points[t[1]], &c = sheets.points[t[2]];
    const bool complete =
        std::none_of(t.begin(), t.end(), [&](VertexIndex v) { return std::isnan(sheets.height(v, horizon)); });
    if (!complete || !samples.covers(horizon, {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3})) continue;
    Triangle own = t;
    for (VertexIndex& v : own) {
      if (row[v] == no_vertex) {
        row[v] = static_cast<VertexIndex>(s.points.size());
        const Vec2 p = frame.to_model(sheets.points[v]);
        s.points.push_back({p.x, p.y, sheets.height(v, horizon)});
      }
      v = row[v];
    }
    if (!faces_up) std::swap(own[1], own[2]);
    s.triangles.push_back(own);
  }
  flush_heights_that_vanish(s.points);
  return s;
}

/// The horizon from both sides of its faults, oriented as it was.
TriangulatedSurface surface_of(SidedHorizon sided, const TriangulatedSurface& given, const MapFrame& frame) {
  TriangulatedSurface s = given;
  const bool faces_up = geomodel::faces_up(given, Frame{});
  s.points = std::move(sided.points);
  s.triangles = std::move(sided.triangles);
  for (Vec3& p : s.points) {
    const Vec2 q = frame.to_model(Vec2{p.x, p.y});
    p = {q.x, q.y, p.z};
  }
  flush_heights_that_vanish(s.points);
  if (!faces_up)
    for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}

/// Horizons that are settled together, in the frame of the volume.
class Group {
 public:
  Group(const Stack& stack, BuiltSurfaces& built, const ModelRules& rules)
      : stack_(stack), built_(built), rules_(rules), frame_(rules.stack.outline, rules.stack.outline_is_box) {
    for (const Index row : stack.rows) {
      data_.push_back(block_data(frame_.to_frame(built.surfaces[row]), built.rows.block_of_triangle[row],
                                 built.rows.n_given_triangles[row]));
      faults_.push_back(faults_of(row));
    }
    for (const BlockData& data : data_) horizons_.push_back(&data.single);
    layout_.bounds = frame_.bounds(rules.stack.outline);
    if (!rules.stack.outline_is_box) layout_.bounds = layout_.bounds.grown(margin_of_size * rules.stack.size);
    layout_.lattice = lattice_of_size * rules.stack.size;
    add_borders(data_, layout_);
    strips_ = find_fault_strips(data_, layout_.bounds, rules.stack.size);
    layout_.keeps_lines = ends_inside();
  }

  /// Horizons that end inside may do so exactly on a fault or body, which moving them would break.
  bool ends_inside() const { return !layout_.lines.empty() || strips_.is_open; }

  /// Gives whether there was anything to settle.
  bool settle() {
    const double size = rules_.stack.size;
    const MapSamples samples(horizons_, layout_.bounds.grown(size));
    for (std::size_t k = 0; k < horizons_.size(); ++k)
      if (!data_[k].has_throw() && samples.overhangs(k)) {
        built_.notes.push_back("the stack is left as given: horizon " + horizons_[k]->name +
                               " has more than one height over a place of the map");
        return false;
      }
    const double thickness = least_thickness();
    const SheetOptions options{stack_.keepers, stack_share * rules_.stack.tolerance, thickness,
                               room_of_thickness * thickness, stack_.units.empty()};
    const double shift = std::min(0.5 * row_of_thickness * thickness, most_shift * size);
    const std::vector<ThinArea> areas =
        find_thin_areas(samples, layout_.bounds, stack_.keepers, {size, thickness, shift});
    const bool is_thin = std::any_of(areas.begin(), areas.end(), [](const ThinArea& a) { return a.any(); });
    const bool is_wanted = (is_thin && rules_.min_thickness > 0) || crosses_by_mistake(samples);
    if (!is_wanted && !has_many_triangles(horizons_, layout_.bounds, size) &&
        !cross_at_small_angle(samples, layout_.bounds, size))
      return false;
    MapSheets sheets = draw_sheets(samples, areas, options);
    std::vector<SidedHorizon> sided(horizons_.size());
    if (has_throw()) {
      sided = make_both_sides(sheets, {data_, faults_, strips_, frame_, *rules_.box, options});
      if (const std::size_t k = first_lost(sided); k < sided.size()) {
        built_.notes.push_back(
            "the stack is left as given: triangles of the size would not hold the blocks of horizon " +
            horizons_[k]->name + " beside its faults");
        return false;
      }
      if (const std::size_t k = first_against_rule(sided); k < sided.size()) {
        built_.notes.push_back("the stack is left as given: at the faults of horizon " + horizons_[k]->name +
                               " one gives way to it that has no throw there (throw_at of that one)");
        return false;
      }
    }
    told_ = describe_settled(sheets, {samples, areas, layout_.bounds, options, strips_, has_topography()});
    told_.min_thickness = thickness;
    if (moves_alone()) {
      built_.notes.push_back("horizon " + horizons_[0]->name +
                             " is left as given: triangles of the size would not follow its blocks");
      return false;
    }
    ask_for_sizes(sheets, thickness);
    replace_horizons(sheets, samples, std::move(sided));
    return true;
  }

  SettledStack& told() { return told_; }

 private:
  /// Neighbours of which no rule says which one cuts the other, in the wrong order at more than a few samples.
  bool crosses_by_mistake(const MapSamples& samples) const {
    if (rules_.on_crossing != OnCrossing::leave) return false;
    for (std::size_t k = 0; k + 1 < horizons_.size(); ++k) {
      const Index younger = stack_.rows[k], older = stack_.rows[k + 1];
      if (rules_.of(younger).base == BaseRule::erode || rules_.of(older).base == BaseRule::onlap ||
          built_.surfaces[younger].name == rules_.topography || built_.surfaces[older].name == rules_.floor)
        continue;
      std::size_t n = 0;
      for (std::size_t s = 0; s < samples.size(); ++s) n += samples.heights(s)[k] < samples.heights(s)[k + 1];
      if (static_cast<double>(n) > few_samples * static_cast<double>(samples.size())) return true;
    }
    return false;
  }

  /// The first horizon with throw that loses a block; their number: none.
  std::size_t first_lost(const std::vector<SidedHorizon>& sided) const {
    for (std::size_t k = 0; k < sided.size(); ++k)
      if (data_[k].has_throw() && loses_blocks(data_[k], sided[k], {faults_[k], frame_, layout_.bounds})) return k;
    return sided.size();
  }
  /// The first horizon that would give way to one without throw against the rules, by more than the tolerance; their
  /// number: none.
  std::size_t first_against_rule(const std::vector<SidedHorizon>& sided) const {
    const auto at = std::find_if(sided.begin(), sided.end(), [&](const SidedHorizon& s) {
      return s.largest_against_rule > rules_.stack.tolerance;
    });
    return static_cast<std::size_t>(at - sided.begin());
  }
  /// A horizon by itself has no order that moves it: it does where triangles of the size do not follow its blocks.
  bool moves_alone() const {
    const SettledHorizon& told = told_.horizons.front();
    return stack_.units.empty() && has_throw() &&
           std::max(told.largest_move, told.largest_move_at_faults) > rules_.stack.tolerance;
  }
  double least_thickness() const {
    if (rules_.min_thickness > 0) return rules_.min_thickness;
    return std::max(stack_share * rules_.stack.tolerance, thickness_of_size * rules_.stack.size);
  }

  MapSheets draw_sheets(const MapSamples& samples, const std::vector<ThinArea>& areas, const SheetOptions& options) {
    layout_.lines.insert(layout_.lines.end(), strips_.outlines.begin(), strips_.outlines.end());
    for (const ThinArea& area : areas)
      layout_.lines.insert(layout_.lines.end(), area.curves.begin(), area.curves.end());
    layout_.joined_within = joined_of_reach * samples.border_reach();
    MapSheets sheets = approximate_sheets(samples, layout_, areas, options);
    close_units(sheets, samples, options, row_of_thickness * options.gap);
    centre_sheets(sheets, samples, areas, options);
    return sheets;
  }

  void ask_for_sizes(const MapSheets& sheets, double thickness) {
    told_.sizes = sizes_of_thickness(sheets, layout_.bounds, {rules_.stack.size, thickness, edge_of_thickness});
    for (SizeSource& source : told_.sizes) {
      const Vec2 place = frame_.to_model(Vec2{source.point.x, source.point.y});
      source.point = {place.x, place.y, source.point.z};
    }
  }

  void replace_horizons(const MapSheets& sheets, const MapSamples& samples, std::vector<SidedHorizon> sided) {
    for (std::size_t k = 0; k < horizons_.size(); ++k) {
      const Index row = stack_.rows[k];
      TriangulatedSurface& s = built_.surfaces[row];
      SettledHorizon& told = told_.horizons[k];
      told.name = s.name;
      const Vec2 place = frame_.to_model(Vec2{told.place.x, told.place.y});
      told.place = {place.x, place.y, told.place.z};
      told.n_triangles_given = s.triangles.size();
      built_.rows.part_of_triangle[row].clear();  // settled horizons are made anew, to their walls
      built_.rows.continued_to[row].clear();
      if (!data_[k].has_throw()) {
        s = sheet_of(sheets, k, samples, s, frame_);
        built_.rows.n_given_triangles[row] = static_cast<Index>(s.triangles.size());
      } else {
        tell_sides(sided[k], told);
        built_.rows.n_given_triangles[row] = sided[k].n_single;
        built_.rows.block_of_triangle[row] = std::move(sided[k].block);
        s = surface_of(std::move(sided[k]), s, frame_);
      }
      told.n_triangles = s.triangles.size();
    }
    for (std::size_t k = 0; k < stack_.units.size(); ++k) {
      told_.units[k].name = stack_.units[k];
      told_.units[k].top = told_.horizons[k].name;
      told_.units[k].base = told_.horizons[k + 1].name;
    }
  }

  bool has_topography() const {
    return !rules_.topography.empty() && built_.surfaces[stack_.rows.front()].name == rules_.topography;
  }

  bool has_throw() const {
    return std::any_of(data_.begin(), data_.end(), [](const BlockData& data) { return data.has_throw(); });
  }

  void tell_sides(const SidedHorizon& sided, SettledHorizon& told) const {
    told.area_at_faults = sided.area;
    told.largest_move_at_faults = sided.largest_move;
    const Vec2 place = frame_.to_model(Vec2{sided.place.x, sided.place.y});
    told.place_at_faults = {place.x, place.y, sided.place.z};
  }

  HorizonFaults faults_of(Index row) const {
    HorizonFaults found;
    if (built_.rows.block_of_triangle[row].empty()) return found;
    for (const Index s : built_.rows.parted_at[row]) {
      const auto n = static_cast<Index>(built_.surfaces[s].triangles.size());
      found.faults.push_back({&built_.surfaces[s], std::min(n, built_.rows.first_only_parting[s])});
      found.rows.push_back(s);
    }
    found.sides = built_.rows.sides_of_block[row];
    return found;
  }

  const Stack& stack_;
  BuiltSurfaces& built_;
  const ModelRules& rules_;
  MapFrame frame_;
  std::vector<BlockData> data_;        ///< in the frame
  std::vector<HorizonFaults> faults_;  ///< per horizon
  FaultStrips strips_;
  std::vector<const TriangulatedSurface*> horizons_;
  MapLayout layout_;
  SettledStack told_;
};

bool can_be_ended_on(const TriangulatedSurface& s) {
  return s.kind == SurfaceKind::fault || s.kind == SurfaceKind::body;
}

/// The column with its ends. False where there was nothing to settle or something stood against it, which a note tells.
bool settle_column_of(BuiltSurfaces& built, const ModelRules& rules, const Stack& stack) {
  if (stack.rows.empty()) return false;
  std::string why = obstacle(stack, built);
  if (why.empty()) {
    Group group(stack, built, rules);
    if (!group.ends_inside() || std::none_of(built.surfaces.begin(), built.surfaces.end(), can_be_ended_on)) {
      if (!group.settle()) return false;
      built.stack = std::move(group.told());
      return true;
    }
    why = "a horizon ends inside the model, where faults or bodies may end it (fill_holes, extend)";
  }
  built.notes.push_back("the stack is left as given: " + why);
  return false;
}

/// Horizons beside the column that reach through the model get few triangles too.
void thin_out_others(BuiltSurfaces& built, const ModelRules& rules, const Stack& stack) {
  for (Index row = 0; row < built.surfaces.size(); ++row) {
    if (built.surfaces[row].kind != SurfaceKind::horizon ||
        std::find(stack.rows.begin(), stack.rows.end(), row) != stack.rows.end())
      continue;
    const Stack alone{{row}, {}, {}};
    if (!built.rows.block_of_triangle[row].empty() || !obstacle(alone, built).empty()) continue;
    Group group(alone, built, rules);
    if (group.ends_inside() || !group.settle()) continue;
    built.stack.settled = true;
    built.stack.min_thickness = group.told().min_thickness;
    built.stack.horizons.push_back(std::move(group.told().horizons.front()));
  }
}

}  // namespace

bool asks_for_settling(const StackRules& rules) {
  return rules.rule != StackRule::keep && rules.tolerance > 0 && rules.size > 0 && !rules.outline.empty();
}

bool settle_stack(BuiltSurfaces& built, const ModelRules& rules) {
  const StackRules& asked = rules.stack;
  if (!asks_for_settling(asked)) return false;
  const Stack stack = find_stack(built, rules);
  const bool settled = settle_column_of(built, rules, stack);
  thin_out_others(built, rules, stack);
  built.stack.size = asked.size;
  built.stack.tolerance = asked.tolerance;
  return settled;
}

}  // namespace geomesh::geomodel

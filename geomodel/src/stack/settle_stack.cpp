// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/settle_stack.hpp"

#include <algorithm>
#include <cmath>

#include "naming/region_facts.hpp"
#include "rules/planar/borders.hpp"
#include "stack/map/map_frame.hpp"
#include "stack/settled_report.hpp"
#include "stack/sheets/centred_sheets.hpp"
#include "stack/sheets/closing_rows.hpp"
#include "stack/sheets/sheet_approximation.hpp"
#include "stack/single_valued.hpp"
#include "stack/stack_members.hpp"
#include "stack/thickness_sizes.hpp"

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
constexpr double margin_of_size = 0.25;          // about an outline that is no box along the axes

/// Why the stack cannot be settled; empty: it can.
std::string obstacle(const Stack& stack, const BuiltSurfaces& built) {
  if (stack.rows.size() > most_horizons) return "it has more than " + std::to_string(most_horizons) + " horizons";
  if (stack.rows.size() != stack.units.size() + 1) return "a horizon of the column is not there";
  for (const Index row : stack.rows) {
    const TriangulatedSurface& s = built.surfaces[row];
    if (!built.rows.block_of_triangle[row].empty()) return "horizon " + s.name + " is given block by block (throw_at)";
    if (!is_single_valued(s)) return "horizon " + s.name + " has more than one height over a place of the map";
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

/// Borders of the horizons that reach into the bounds.
void add_borders(const std::vector<const TriangulatedSurface*>& horizons, MapLayout& layout) {
  const MapBounds near = layout.bounds;
  for (const TriangulatedSurface* s : horizons)
    for (const BorderEdge& e : border_edges(*s)) {
      const Vec2 a{s->points[e.a].x, s->points[e.a].y}, b{s->points[e.b].x, s->points[e.b].y};
      const bool beside = std::max(a.x, b.x) < near.min.x || std::min(a.x, b.x) > near.max.x ||
                          std::max(a.y, b.y) < near.min.y || std::min(a.y, b.y) > near.max.y;
      if (!beside) layout.lines.push_back({a, b});
    }
}

/// The horizon's part of the sheets, oriented as the horizon was.
TriangulatedSurface sheet_of(const MapSheets& sheets, std::size_t horizon, const MapSamples& samples,
                             const TriangulatedSurface& given, const MapFrame& frame) {
  TriangulatedSurface s = given;
  double up = 0;
  for (const Triangle& t : given.triangles)
    up += cross(given.points[t[1]] - given.points[t[0]], given.points[t[2]] - given.points[t[0]]).z;
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
    if (up < 0) std::swap(own[1], own[2]);
    s.triangles.push_back(own);
  }
  return s;
}

/// Horizons that are settled together, in the frame of the volume.
class Group {
 public:
  Group(const Stack& stack, BuiltSurfaces& built, const ModelRules& rules)
      : stack_(stack), built_(built), rules_(rules), frame_(rules.stack.outline, rules.stack.outline_is_box) {
    for (const Index row : stack.rows) turned_.push_back(frame_.to_frame(built.surfaces[row]));
    for (const TriangulatedSurface& s : turned_) horizons_.push_back(&s);
    layout_.bounds = frame_.bounds(rules.stack.outline);
    if (!rules.stack.outline_is_box) layout_.bounds = layout_.bounds.grown(margin_of_size * rules.stack.size);
    layout_.lattice = lattice_of_size * rules.stack.size;
    add_borders(horizons_, layout_);
    layout_.keeps_lines = ends_inside();
  }

  /// Horizons that end inside may do so exactly on a fault or body, which moving them would break.
  bool ends_inside() const { return !layout_.lines.empty(); }

  /// Gives whether there was anything to settle.
  bool settle() {
    const double size = rules_.stack.size;
    const MapSamples samples(horizons_, layout_.bounds.grown(size));
    for (std::size_t k = 0; k < horizons_.size(); ++k)
      if (samples.overhangs(k)) {
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
    if (!is_wanted && !has_many_triangles(horizons_, layout_.bounds, size)) return false;
    const MapSheets sheets = draw_sheets(samples, areas, options);
    told_ = describe_settled(sheets, samples, areas, layout_.bounds, options);
    told_.min_thickness = thickness;
    ask_for_sizes(sheets, thickness);
    replace_horizons(sheets, samples);
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

  double least_thickness() const {
    if (rules_.min_thickness > 0) return rules_.min_thickness;
    return std::max(stack_share * rules_.stack.tolerance, thickness_of_size * rules_.stack.size);
  }

  MapSheets draw_sheets(const MapSamples& samples, const std::vector<ThinArea>& areas, const SheetOptions& options) {
    for (const ThinArea& area : areas)
      layout_.lines.insert(layout_.lines.end(), area.curves.begin(), area.curves.end());
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

  void replace_horizons(const MapSheets& sheets, const MapSamples& samples) {
    for (std::size_t k = 0; k < horizons_.size(); ++k) {
      TriangulatedSurface& s = built_.surfaces[stack_.rows[k]];
      SettledHorizon& told = told_.horizons[k];
      told.name = s.name;
      const Vec2 place = frame_.to_model(Vec2{told.place.x, told.place.y});
      told.place = {place.x, place.y, told.place.z};
      told.n_triangles_given = s.triangles.size();
      s = sheet_of(sheets, k, samples, s, frame_);
      told.n_triangles = s.triangles.size();
      built_.rows.n_given_triangles[stack_.rows[k]] = static_cast<Index>(s.triangles.size());
    }
    for (std::size_t k = 0; k < stack_.units.size(); ++k) {
      told_.units[k].name = stack_.units[k];
      told_.units[k].top = told_.horizons[k].name;
      told_.units[k].base = told_.horizons[k + 1].name;
    }
  }

  const Stack& stack_;
  BuiltSurfaces& built_;
  const ModelRules& rules_;
  MapFrame frame_;
  std::vector<TriangulatedSurface> turned_;
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
    if (!obstacle(alone, built).empty()) continue;
    Group group(alone, built, rules);
    if (group.ends_inside() || !group.settle()) continue;
    built.stack.settled = true;
    built.stack.min_thickness = group.told().min_thickness;
    built.stack.horizons.push_back(std::move(group.told().horizons.front()));
  }
}

}  // namespace

bool settle_stack(BuiltSurfaces& built, const ModelRules& rules) {
  const StackRules& asked = rules.stack;
  if (asked.rule == StackRule::keep || !(asked.tolerance > 0) || !(asked.size > 0) || asked.outline.empty())
    return false;
  const Stack stack = find_stack(built, rules);
  const bool settled = settle_column_of(built, rules, stack);
  thin_out_others(built, rules, stack);
  built.stack.size = asked.size;
  built.stack.tolerance = asked.tolerance;
  return settled;
}

}  // namespace geomesh::geomodel

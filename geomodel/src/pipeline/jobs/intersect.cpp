// SPDX-License-Identifier: GPL-3.0-or-later
// The stages build and intersect, declared in pipeline/jobs/prepare.hpp.
#include <algorithm>
#include <cstdio>

#include "geomesh/geomodel/words.hpp"
#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "pipeline/jobs/prepare.hpp"
#include "pipeline/merge_near.hpp"
#include "stack/settled_report.hpp"

namespace geomesh::geomodel {
namespace {

bool looks_geographic(const Box3& extent) {
  return extent.min.x >= -180 && extent.max.x <= 360 && extent.min.y >= -90 && extent.max.y <= 90;
}

/// What a geologist would look at first where a surface lies elsewhere than the model.
const char* advice(const Box3& extent, const std::optional<Box3>& model) {
  if (!model) return "";
  if (looks_geographic(extent) && !looks_geographic(*model))
    return ". Its coordinates look like longitude and latitude, the model's do not: project the file to the system of "
           "the project";
  const bool inside_map = extent.max.x >= model->min.x && extent.min.x <= model->max.x &&
                          extent.max.y >= model->min.y && extent.min.y <= model->max.y;
  if (inside_map && -extent.min.z >= model->min.z && -extent.max.z <= model->max.z)
    return ". With z turned round it would lie in the box: are these depths, counted downwards?";
  if (inside_map) return ". In the map it lies over the box, but not in height: are both in the same unit?";
  return ". Are its coordinates in the same system and unit as those of the box?";
}

/// Faults that end inside, with the length of their tips: as given, or for want of an extent.
void note_tips(PreparedModel& model, const RunContext& context) {
  struct Tip {
    double length = 0, longest = -1;
    Vec3 place;
  };
  std::vector<Tip> tips(model.plc.curves.size());
  const auto& points = model.plc.plc.points;
  for (std::size_t s = 0; s < model.plc.segment_curves.size(); ++s)
    for (const Index curve : model.plc.segment_curves[s]) {
      if (model.plc.curves[curve].kind != "fault_tip") continue;
      const Vec3 &a = points[model.plc.plc.segments[s].a], &b = points[model.plc.plc.segments[s].b];
      const double length = norm(b - a);
      tips[curve].length += length;
      if (length <= tips[curve].longest) continue;
      tips[curve].longest = length;
      tips[curve].place = 0.5 * (a + b);
    }
  for (std::size_t c = 0; c < tips.size(); ++c) {
    const std::string& name = model.plc.curves[c].name;
    if (tips[c].length > 0)
      note(model.notes, context,
           "fault " + name.substr(0, name.rfind(".tip")) + " ends inside the model along a tip of length " +
               to_text(tips[c].length) + ", near " + to_text(tips[c].place) + " (extent: to_box would continue it)");
  }
}

/// A surface of which nothing is left is most often one in other coordinates than the box.
void warn_of_absent_surfaces(PreparedModel& model, const RunContext& context) {
  std::vector<bool> present(model.surfaces.size(), false);
  for (const PolygonSoup::Origin& origin : model.arrangement.soup.origins)
    if (origin.surface < present.size()) present[origin.surface] = true;
  for (std::size_t s = 0; s < model.surfaces.size(); ++s) {
    if (present[s] || model.surfaces[s].triangles.empty()) continue;
    if (std::find(model.doubted.begin(), model.doubted.end(), model.surfaces[s].name) != model.doubted.end()) continue;
    Box3 extent;
    for (const Vec3& p : model.surfaces[s].points) extent.add(p);
    char text[200];
    std::snprintf(text, sizeof text, "it reaches from (%.9g, %.9g, %.9g) to (%.9g, %.9g, %.9g)", extent.min.x,
                  extent.min.y, extent.min.z, extent.max.x, extent.max.y, extent.max.z);
    warn(model.warnings, context,
         std::string(to_string(model.surfaces[s].kind)) + " " + model.surfaces[s].name +
             " never meets the model: all of it lies outside the box or inside bodies that cut it; " + text +
             advice(extent, model.rules.box));
  }
}

/// Wells of which a part is left out, but for those that a warning has said this of with its cause.
void warn_of_clipped_wells(PreparedModel& model, const std::vector<Polyline>& wells, const RunContext& context) {
  for (const Spot& spot : model.arrangement.spots) {
    if (spot.what != "clipped polyline") continue;
    const std::string& name = wells[spot.surface_a].name;
    if (std::find(model.doubted.begin(), model.doubted.end(), name) != model.doubted.end()) continue;
    warn(model.warnings, context,
         "polyline " + name + ": a length of " + short_words(spot.measure) + " lies outside the box, near " +
             to_text(spot.place) + ", and is left out");
  }
}

/// What crosses, has gaps and dangles, but for what was warned of.
void note_findings(PreparedModel& model, const RunContext& context) {
  constexpr std::size_t most = 100;
  std::size_t n = 0;
  for (std::string& text : findings(model.arrangement.spots, model.surfaces))
    if (std::find(model.warnings.begin(), model.warnings.end(), text) == model.warnings.end() && n++ < most)
      note(model.notes, context, std::move(text));
  if (n > most)
    note(model.notes, context,
         "... and " + std::to_string(n - most) + " more findings of this kind: see intersection.spots");
}

/// Continued blocks of a horizon with throw run through and onto each other until they are parted: nothing that the
/// user gave is wrong there.
void drop_spots_of_blocks(PreparedModel& model) {
  ArrangementResult& found = model.arrangement;
  const auto& blocks = model.built_rows.block_of_triangle;
  const auto& continued = model.built_rows.part_of_triangle;
  std::erase_if(found.spots, [&](const Spot& spot) {
    const Index s = spot.surface_a;
    const bool of_blocks = s == spot.surface_b && ((s < blocks.size() && !blocks[s].empty()) ||
                                                   (s < continued.size() && !continued[s].empty()));
    // The overshoot of a continuation beyond its wall is cut off later.
    const bool of_overshoot = spot.what == "free border" && s < continued.size() && !continued[s].empty();
    if (of_blocks || of_overshoot) std::erase(found.warnings, describe(spot, model.surfaces));
    return of_blocks || of_overshoot;
  });
}

/// What was given of each block of a horizon with throw, what continues surfaces, and what continues faults only to
/// part blocks.
void set_parts(const PreparedModel& model, ArrangementOptions& options) {
  const BuiltRows& rows = model.built_rows;
  std::vector<std::vector<Index>>& parts = options.parts = rows.part_of_triangle;
  parts.resize(model.surfaces.size());
  options.n_given_parts.assign(parts.size(), 1);
  for (std::size_t s = 0; s < rows.block_of_triangle.size(); ++s) {
    const std::vector<Index>& block = rows.block_of_triangle[s];
    if (block.empty()) continue;
    Index& n_given = options.n_given_parts[s];
    for (const Index b : block)
      if (b != BuiltRows::of_every_block) n_given = std::max(n_given, b + 2);
    parts[s].resize(block.size(), 0);
    for (std::size_t t = 0; t < block.size(); ++t)
      if (parts[s][t] > 0)
        parts[s][t] += n_given - 1;
      else if (block[t] != BuiltRows::of_every_block)
        parts[s][t] = block[t] + 1;
  }
  for (std::size_t s = 0; s < rows.first_only_parting.size(); ++s) {
    const std::size_t n = model.surfaces[s].triangles.size(), first = rows.first_only_parting[s];
    if (!parts[s].empty() || first >= n) continue;
    parts[s].assign(n, 0);
    std::fill(parts[s].begin() + static_cast<std::ptrdiff_t>(first), parts[s].end(), Index{1});
  }
}

/// The walls at which continued surfaces end that are whole in the arrangement: faults that overshoot the ones on which
/// they end are cut in the soup, and what ends at them is cut there, too.
std::vector<std::vector<Index>> walls_of_continuations(const PreparedModel& model) {
  const BuiltRows& rows = model.built_rows;
  std::vector<std::vector<Index>> walls = rows.continued_to;
  for (std::size_t s = 0; s < walls.size(); ++s) {
    if (rows.part_of_triangle[s].empty()) walls[s].clear();
    std::erase_if(walls[s], [&](Index wall) {
      return std::binary_search(rows.overshooting.begin(), rows.overshooting.end(), wall);
    });
  }
  return walls;
}

/// Settled horizons share surfaces where that is wanted: nothing to warn of.
void drop_spots_of_stack(PreparedModel& model) {
  const auto is_settled = [&](Index s) {
    return s < model.surfaces.size() &&
           std::any_of(model.stack.horizons.begin(), model.stack.horizons.end(),
                       [&](const SettledHorizon& h) { return h.name == model.surfaces[s].name; });
  };
  ArrangementResult& found = model.arrangement;
  std::erase_if(found.spots, [&](const Spot& spot) {
    const bool of_stack = spot.what == "overlap" && is_settled(spot.surface_a) && is_settled(spot.surface_b);
    if (of_stack) std::erase(found.warnings, describe(spot, model.surfaces));
    return of_stack;
  });
}

/// Regions of a settled stack are units, or units in fault blocks. What is smaller than a tenth of an element joins a
/// neighbour. A unit of an element in a block is no remainder: where sizes are coarse, it is as thick as others.
void name_by_unit_and_block(PreparedModel& model) {
  constexpr double element = 0.118;  // volume of a regular tetrahedron over the cube of its side
  constexpr double least_share = 0.1;
  model.naming.join_pieces = true;
  model.naming.fault_blocks = true;
  if (model.naming.min_volume > 0) return;
  model.naming.min_volume = least_share * element * model.stack.size * model.stack.size * model.stack.size;
  model.naming.merge_small = true;
}

/// Surfaces of thin units are held more closely, and get the sizes that the thickness asks for.
void ask_of_thin_units(PreparedModel& model) {
  if (model.stack.sizes.empty()) return;
  RefinementSettings& r = model.refinement;
  r.tolerance.limit_share(stack_tolerance_of_size);
  std::vector<SizeSource>& sources = r.size.base.sources;
  sources.insert(sources.end(), model.stack.sizes.begin(), model.stack.sizes.end());
}

}  // namespace

void build(PreparedModel& model, const RunContext& context) {
  StageScope stage(context, "build");
  BuiltSurfaces built = build_surfaces(model.surfaces, model.rules, context);
  model.surfaces = std::move(built.surfaces);
  model.built_rows = std::move(built.rows);
  model.stack = std::move(built.stack);
  model.continued = std::move(built.continued);
  if (model.stack.settled) {
    for (std::string& text : notes_of(model.stack)) note(model.notes, context, std::move(text));
    for (ToleranceUse& use : uses_of(model.stack)) model.refinement.tolerance.take(std::move(use));
    ask_of_thin_units(model);
    name_by_unit_and_block(model);
  }
  for (std::string& text : built.notes) note(model.notes, context, std::move(text));
  for (std::string& text : built.warnings) warn(model.warnings, context, std::move(text));
}

void intersect(PreparedModel& model, const std::vector<Polyline>& wells, const ArrangementOptions& options,
               const RunContext& context) {
  StageScope stage(context, "intersect");
  ArrangementOptions with_parts = options;
  set_parts(model, with_parts);
  with_parts.ends_at = walls_of_continuations(model);
  model.arrangement = arrange_merging_near(model, wells, with_parts, context);
  drop_spots_of_blocks(model);
  drop_spots_of_stack(model);
  for (const std::string& text : model.arrangement.warnings) warn(model.warnings, context, text);
  warn_of_clipped_wells(model, wells, context);
  warn_of_absent_surfaces(model, context);
  for (const TriangulatedSurface& side : model.arrangement.box_sides) model.surfaces.push_back(side);
  note_findings(model, context);
  add_steps(model.surfaces, model.built_rows);
  if (model.rules.trims() || model.built_rows.any_continued()) {
    TrimmedSoup trimmed = trim_soup(model.arrangement.soup, model.surfaces, model.built_rows, model.rules);
    model.arrangement.soup = std::move(trimmed.soup);
    model.arrangement.area_clipped_by_rules = std::move(trimmed.area_removed);
    for (std::string& text : trimmed.notes) note(model.notes, context, std::move(text));
    for (std::string& text : trimmed.warnings) warn(model.warnings, context, std::move(text));
  }
  model.plc = make_plc(model.arrangement.soup, model.surfaces, wells);
  note_tips(model, context);
  context.note(LogLevel::info, std::to_string(model.arrangement.n_crossing_pairs) + " pairs of triangles cross; " +
                                   std::to_string(model.arrangement.soup.facets.size()) + " facets");
}

}  // namespace geomesh::geomodel

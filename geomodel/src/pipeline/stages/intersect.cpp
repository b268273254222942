// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the stage intersect, declared in pipeline/stages/stages.hpp.
#include <algorithm>
#include <cstdio>
#include <map>

#include "fractures/plane_polygons.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/words.hpp"
#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "pipeline/stages/hull.hpp"
#include "pipeline/stages/merge_near.hpp"
#include "pipeline/stages/stages.hpp"
#include "stack/settled_report.hpp"

namespace geomesh::geomodel {
namespace {

bool looks_geographic(const Box3& extent) {
  return extent.min.x >= -180 && extent.max.x <= 360 && extent.min.y >= -90 && extent.max.y <= 90;
}

/// Returns advice for a surface far from the model: coordinates or unit may be wrong, or depths were given as heights.
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

/// Notes the faults that end inside the model, with the length of their tips, and whether the project requests this or
/// it follows from a missing extent. Fractures are left out, because they always end inside.
void note_tips(const ModelPlc& model, Journal& journal) {
  struct Tip {
    double length = 0, longest = -1;
    Vec3 place;
  };
  std::vector<Tip> tips(model.curves.size());
  const auto& points = model.plc.points;
  for (std::size_t s = 0; s < model.segment_curves.size(); ++s)
    for (const Index curve : model.segment_curves[s]) {
      if (model.curves[curve].kind != "fault_tip") continue;
      const Vec3 &a = points[model.plc.segments[s].a], &b = points[model.plc.segments[s].b];
      const double length = norm(b - a);
      tips[curve].length += length;
      if (length <= tips[curve].longest) continue;
      tips[curve].longest = length;
      tips[curve].place = 0.5 * (a + b);
    }
  for (std::size_t c = 0; c < tips.size(); ++c) {
    const std::string& name = model.curves[c].name;
    if (tips[c].length > 0)
      journal.note("fault " + name.substr(0, name.rfind(".tip")) + " ends inside the model along a tip of length " +
                   to_text(tips[c].length) + ", near " + to_text(tips[c].place) +
                   " (extent: to_box would continue it)");
  }
}

/// Warns of surfaces of which no part is left in the model: most often their coordinates do not fit those of the box.
void warn_of_absent_surfaces(const Inputs& inputs, const Built& built, const PolygonSoup& soup, Journal& journal) {
  std::vector<bool> present(built.surfaces.size(), false);
  for (const PolygonSoup::Origin& origin : soup.origins)
    if (origin.surface < present.size()) present[origin.surface] = true;
  for (std::size_t s = 0; s < built.surfaces.size(); ++s) {
    if (present[s] || built.surfaces[s].triangles.empty()) continue;
    if (std::find(inputs.doubted.begin(), inputs.doubted.end(), built.surfaces[s].name) != inputs.doubted.end())
      continue;
    Box3 extent;
    for (const Vec3& p : built.surfaces[s].points) extent.add(p);
    char text[200];
    std::snprintf(text, sizeof text, "it reaches from (%.9g, %.9g, %.9g) to (%.9g, %.9g, %.9g)", extent.min.x,
                  extent.min.y, extent.min.z, extent.max.x, extent.max.y, extent.max.z);
    journal.warn(std::string(to_string(built.surfaces[s].kind)) + " " + built.surfaces[s].name +
                 " never meets the model: all of it lies outside the box or inside bodies that cut it; " + text +
                 advice(extent, built.rules.box));
  }
}

/// Warns of wells that are partly outside the model, unless another warning already stated the cause.
void warn_of_clipped_wells(const Inputs& inputs, const std::vector<Spot>& spots, Journal& journal) {
  for (const Spot& spot : spots) {
    if (spot.what != "clipped polyline") continue;
    const std::string& name = inputs.wells[spot.surface_a].name;
    if (std::find(inputs.doubted.begin(), inputs.doubted.end(), name) != inputs.doubted.end()) continue;
    journal.warn("polyline " + name + ": a length of " + short_words(spot.measure) + " lies outside the box, near " +
                 to_text(spot.place) + ", and is left out");
  }
}

/// Notes crossings, gaps and dangling edges of surfaces, unless a warning already mentioned them.
void note_findings(const std::vector<Spot>& spots, const std::vector<TriangulatedSurface>& surfaces, Journal& journal) {
  constexpr std::size_t most = 100;
  std::size_t n = 0;
  for (std::string& text : findings(spots, surfaces))
    if (std::find(journal.warnings().begin(), journal.warnings().end(), text) == journal.warnings().end() && n++ < most)
      journal.note(std::move(text));
  if (n > most)
    journal.note("... and " + std::to_string(n - most) + " more findings of this kind: see intersection.spots");
}

/// Drops findings about the blocks of a horizon with throw. The blocks were continued and cross and overlap each other
/// until they are divided, so these findings are not errors of the input.
void drop_spots_of_blocks(const Built& built, ArrangementResult& found) {
  const auto& blocks = built.rows.block_of_triangle;
  const auto& continued = built.rows.part_of_triangle;
  std::erase_if(found.spots, [&](const Spot& spot) {
    const Index s = spot.surface_a;
    const bool of_blocks = s == spot.surface_b && ((s < blocks.size() && !blocks[s].empty()) ||
                                                   (s < continued.size() && !continued[s].empty()));
    // A continued surface overshoots the surface at which it ends; its free border there is cut off later.
    const bool of_overshoot = spot.what == "free border" && s < continued.size() && !continued[s].empty();
    if (of_blocks || of_overshoot) std::erase(found.warnings, describe(spot, built.surfaces));
    return of_blocks || of_overshoot;
  });
}

/// Returns the parts of surfaces that may be removed later: blocks of horizons with throw, and extensions of faults
/// that only separate such blocks.
std::vector<std::vector<Index>> parts_that_may_go(const Built& built) {
  std::vector<std::vector<Index>> parts = built.rows.block_of_triangle;
  for (std::size_t s = 0; s < parts.size() && s < built.rows.part_of_triangle.size(); ++s)
    if (parts[s].empty()) parts[s] = built.rows.part_of_triangle[s];
  const std::vector<Index>& first_only_parting = built.rows.first_only_parting;
  parts.resize(built.surfaces.size());
  for (std::size_t s = 0; s < first_only_parting.size() && s < parts.size(); ++s) {
    const std::size_t n = built.surfaces[s].triangles.size(), first = first_only_parting[s];
    if (!parts[s].empty() || first >= n) continue;
    parts[s].assign(n, 0);
    std::fill(parts[s].begin() + static_cast<std::ptrdiff_t>(first), parts[s].end(), Index{1});
  }
  return parts;
}

/// Returns for each continued surface the walls (surfaces) at which it ends. Only walls that the arrangement contains
/// completely count. Faults that overshoot the ones at which they end are cut in the polygon soup, and so are the
/// surfaces that end at them.
std::vector<std::vector<Index>> walls_of_continuations(const BuiltRows& rows) {
  std::vector<std::vector<Index>> walls = rows.continued_to;
  for (std::size_t s = 0; s < walls.size(); ++s) {
    if (rows.part_of_triangle[s].empty()) walls[s].clear();
    std::erase_if(walls[s], [&](Index wall) {
      return std::binary_search(rows.overshooting.begin(), rows.overshooting.end(), wall);
    });
  }
  return walls;
}

/// Drops findings that horizons coincide if these were put in order: they are meant to where a unit pinches out.
void drop_spots_of_stack(const Built& built, ArrangementResult& found) {
  const auto is_settled = [&](Index s) {
    return s < built.surfaces.size() &&
           std::any_of(built.stack.horizons.begin(), built.stack.horizons.end(),
                       [&](const SettledHorizon& h) { return h.name == built.surfaces[s].name; });
  };
  std::erase_if(found.spots, [&](const Spot& spot) {
    const bool of_stack = spot.what == "overlap" && is_settled(spot.surface_a) && is_settled(spot.surface_b);
    if (of_stack) std::erase(found.warnings, describe(spot, built.surfaces));
    return of_stack;
  });
}

/// Removes from the polygon soup the parts of surfaces that rules cut off at crossings, and the ends of continuations.
void trim(const Built& built, Arranged& arranged, Journal& journal) {
  if (!built.rules.trims() && !built.rows.any_continued()) return;
  ArrangementResult& found = arranged.arrangement;
  TrimmedSoup trimmed = trim_soup(found.soup, arranged.surfaces, built.rows, built.rules);
  found.soup = std::move(trimmed.soup);
  GEOMESH_EXPENSIVE_CHECK(validate_soup(found.soup, 1).empty());
  found.area_clipped_by_rules = std::move(trimmed.area_removed);
  for (std::string& text : trimmed.notes) journal.note(std::move(text));
  journal.warn_all(std::move(trimmed.warnings));
}

/// Returns true if every edge of the surface has an even number of triangles; equal points count as one.
bool is_closed(const TriangulatedSurface& surface) {
  const auto less = [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
  std::map<Vec3, Index, decltype(less)> ids(less);
  std::vector<std::pair<Index, Index>> edges;
  for (const Triangle& t : surface.triangles)
    for (int i = 0; i < 3; ++i) {
      const auto id = [&](VertexIndex v) {
        return ids.try_emplace(surface.points[v], static_cast<Index>(ids.size())).first->second;
      };
      const Index a = id(t[i]), b = id(t[(i + 1) % 3]);
      if (a != b) edges.emplace_back(std::min(a, b), std::max(a, b));
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i;
    while (j < edges.size() && edges[j] == edges[i]) ++j;
    if ((j - i) % 2 != 0) return false;
    i = j;
  }
  return !edges.empty();
}

/// Returns the arrangement for a PLC that is meshed unchanged. Its facets replace soup facets, so that results have
/// names.
Arranged as_given(const Inputs& inputs, const Built& built) {
  Arranged arranged;
  arranged.surfaces = built.surfaces;
  arranged.refinement = built.refinement;
  const PiecewiseLinearComplex& plc = inputs.plc->plc;
  PolygonSoup& soup = arranged.arrangement.soup;
  soup.points = plc.points;
  soup.kind.assign(soup.points.size(), SoupVertexKind::input);
  for (Index v = 0; v < soup.points.size(); ++v) soup.input_point.push_back(v);
  for (Index f = 0; f < plc.n_facets(); ++f) {
    soup.facets.push_back(built.surfaces.front().triangles[f]);
    soup.origins.push_back({0, f, false});
    soup.origin_offsets.push_back(static_cast<Index>(soup.origins.size()));
    arranged.plc.facet_soup.push_back(f);
    arranged.plc.facet_soup_offsets.push_back(f + 1);
  }
  arranged.plc.facet_patch.assign(plc.n_facets(), 1);
  arranged.plc.segment_curves.resize(plc.segments.size());
  arranged.plc.plc = plc;
  return arranged;
}

}  // namespace

Arranged intersect(const Inputs& inputs, const Built& built, Journal& journal) {
  if (inputs.plc) return as_given(inputs, built);
  const StageScope stage(journal.context(), "intersect");
  ArrangementOptions options = inputs.arrangement;
  if (built.volume.volume > 0) {
    options.box = built.volume.box;
    options.volume = built.volume.sides;
  }
  options.parts = parts_that_may_go(built);
  options.ends_at = walls_of_continuations(built.rows);
  Arranged arranged;
  arranged.refinement = built.refinement;
  arranged.arrangement = arrange_merging_near(inputs, built, options, arranged.refinement.tolerance, journal);
  ArrangementResult& found = arranged.arrangement;
  drop_spots_of_blocks(built, found);
  drop_spots_of_stack(built, found);
  journal.warn_all(found.warnings);
  warn_of_clipped_wells(inputs, found.spots, journal);
  warn_of_absent_surfaces(inputs, built, found.soup, journal);
  arranged.surfaces = built.surfaces;
  arranged.surfaces.insert(arranged.surfaces.end(), found.box_sides.begin(), found.box_sides.end());
  note_findings(found.spots, arranged.surfaces, journal);
  trim(built, arranged, journal);
  arranged.plc = make_plc(found.soup, arranged.surfaces, built.wells);
  if (!is_fracture_network(built.surfaces, built.rules)) note_tips(arranged.plc, journal);
  journal.context().note(LogLevel::info, std::to_string(found.n_crossing_pairs) + " pairs of triangles cross; " +
                                             std::to_string(found.soup.facets.size()) + " facets");
  if (inputs.closed_are_bodies)
    for (TriangulatedSurface& surface : arranged.surfaces)
      if (surface.kind == SurfaceKind::surface && surface.name != hull_name && is_closed(surface))
        surface.kind = SurfaceKind::body;
  return arranged;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/framework/end_on_faults.hpp"

#include <algorithm>

#include "rules/framework/end_at_walls.hpp"
#include "rules/framework/fault_truncations.hpp"
#include "rules/framework/overshoots.hpp"

namespace geomesh::geomodel {
namespace {

std::vector<Index> faults_of(const std::vector<TriangulatedSurface>& surfaces) {
  std::vector<Index> rows;
  for (Index s = 0; s < surfaces.size(); ++s)
    if (surfaces[s].kind == SurfaceKind::fault) rows.push_back(s);
  return rows;
}

std::vector<Index> without(std::vector<Index> rows, Index row) {
  std::erase(rows, row);
  return rows;
}

/// Returns the surface with only those facets that were not removed from the soup.
TriangulatedSurface left_of(const WorkingSoup& working, const TriangulatedSurface& surface, Index row) {
  TriangulatedSurface left = surface;
  left.points = working.soup.points;
  left.triangles.clear();
  for (Index f = 0; f < working.origins.size(); ++f)
    if (working.has(f, row)) left.triangles.push_back(working.soup.facets[f]);
  return left;
}

/// Returns the edges of faults that have only one facet.
std::vector<FaultTip> tips_of(const WorkingSoup& working, const std::vector<Index>& faults) {
  std::vector<FaultTip> tips;
  const auto& points = working.soup.points;
  for_each_edge(working.uses, [&](std::span<const EdgeUse> edge) {
    Index facet = no_index;
    std::size_t n = 0;
    for (const EdgeUse& u : edge)
      if (working.alive(u.facet)) {
        facet = u.facet;
        ++n;
      }
    if (n != 1) return;
    const Triangle& t = working.soup.facets[facet];
    const auto fault = std::find_if(faults.begin(), faults.end(), [&](Index s) { return working.has(facet, s); });
    if (fault == faults.end()) return;
    tips.push_back({{points[edge[0].a], points[edge[0].b]},
                    cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]),
                    *fault});
  });
  return tips;
}

}  // namespace

void end_faults(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                double within, const TakenOff& taken) {
  for (Index s = 0; s < built.part_of_triangle.size(); ++s)
    if (surfaces[s].kind == SurfaceKind::fault && !built.part_of_triangle[s].empty())
      taken.area[s] += end_at_walls(working, surfaces, built, s);
  const std::vector<Index> faults = faults_of(surfaces);
  for (const Index s : built.overshooting)
    taken.area[s] +=
        remove_overshoots(working, {s, without(faults, s), within, part_of(built, s)}, surfaces[s].name, taken.notes);
  truncate_faults(working, surfaces, built, within, taken.area, taken.notes);
}

ArrangedWalls arrange_walls(const BuiltSurfaces& built, const ModelRules& rules, const std::set<SurfaceKind>& kinds) {
  ArrangedWalls walls{built.surfaces, {}};
  const std::vector<Index> unconformities = truncating_horizons(built.rows.truncations);
  for (Index s = 0; s < walls.surfaces.size(); ++s)
    if (!kinds.contains(walls.surfaces[s].kind) && !std::ranges::binary_search(unconformities, s))
      walls.surfaces[s].triangles.clear();
  ArrangementOptions options;
  if (rules.continuation.sides.size() == 1)  // the sides of a box are given as one surface
    options.box = rules.continuation.bounds;
  else
    options.volume = rules.continuation.sides;
  ArrangementResult arranged = arrange(walls.surfaces, {}, {}, options);
  walls.surfaces.insert(walls.surfaces.end(), arranged.box_sides.begin(), arranged.box_sides.end());
  walls.soup = std::move(arranged.soup);
  return walls;
}

EndedFaults ended_faults(BuiltSurfaces& built, const ModelRules& rules) {
  const std::vector<Index> faults = faults_of(built.surfaces);
  ArrangedWalls walls = arrange_walls(built, rules, {SurfaceKind::fault});
  const std::vector<TriangulatedSurface>& alone = walls.surfaces;
  WorkingSoup working(walls.soup);
  const double within = rules.continuation.within_of_faults;
  for (const Index s : faults)
    if (within > 0 && ends_by_default(built.surfaces, rules, s) &&
        !overshoots_of(working, {s, without(faults, s), within, part_of(built.rows, s)}).empty())
      built.rows.overshooting.push_back(s);
  std::vector<double> area(alone.size(), 0);
  // Notes on cut faults are discarded, because the user gets the same ones when the model's faults are cut.
  std::vector<std::string> notes;
  end_faults(working, alone, built.rows, within, {area, notes});
  EndedFaults ended{built.surfaces, tips_of(working, faults)};
  for (const Index s : faults)
    if (area[s] > 0) ended.surfaces[s] = left_of(working, built.surfaces[s], s);
  return ended;
}

bool ends_by_default(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules, Index row) {
  const SurfaceRules& rule = rules.of(row);
  const auto has_throw_there = [&](const SurfaceRules& of) {
    return std::find(of.throw_at.begin(), of.throw_at.end(), surfaces[row].name) != of.throw_at.end();
  };
  return !surfaces[row].triangles.empty() && rule.continues && rule.extend == Extend::none &&
         std::none_of(rules.surfaces.begin(), rules.surfaces.end(), has_throw_there);
}

}  // namespace geomesh::geomodel

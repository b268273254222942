// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/names/region_labels.hpp"

#include <algorithm>
#include <array>

#include "check/exact/crossing.hpp"

namespace geomesh::geomodel::checking {
namespace {

constexpr std::size_t n_samples = 12;

/// Returns whether every edge of the surface is traversed as often in one direction as in the other.
bool is_closed(const TriangulatedSurface& s) {
  using Place = std::array<double, 3>;
  std::map<std::array<Place, 2>, int> balance;
  const auto place = [&](VertexIndex v) { return Place{s.points[v].x, s.points[v].y, s.points[v].z}; };
  for (const Triangle& t : s.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Place a = place(t[i]), b = place(t[(i + 1) % 3]);
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : a > b ? -1 : 0;
    }
  return !s.triangles.empty() &&
         std::all_of(balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; });
}

bool holds(const std::vector<Index>& rows, Index row) { return std::find(rows.begin(), rows.end(), row) != rows.end(); }

}  // namespace

LabelFinder::LabelFinder(const CheckedFaces& checked, const Allowed& allowed)
    : checked_(checked),
      reach_(allowed.both()),
      least_volume_(allowed.rounding * allowed.rounding * allowed.rounding),
      units_(checked, allowed.both()),
      places_(region_places(checked.mesh(), n_samples)) {}

std::optional<std::vector<Index>> LabelFinder::bodies_about(const RegionPlace& place) const {
  std::vector<Index> about;
  for (const Body& body : checked_.bodies()) {
    const auto row = static_cast<Index>(body.surface - checked_.specification().surfaces.data());
    if (body.surface->kind != SurfaceKind::body || !is_closed(*body.surface)) continue;
    bool decided = false;
    for (const Vec3& p : place.samples) {
      if (is_near(body, p, reach_)) continue;
      const auto winding = winding_about_centroid(body.surface->points, body.surface->triangles, body.tree, p, p, p);
      if (!winding) continue;
      if (*winding != 0) about.push_back(row);
      decided = true;
      break;
    }
    if (!decided) return std::nullopt;
  }
  return about;
}

/// Returns the names that seeds give to regions; the first seed in a region counts. A seed on a border between regions
/// names none of them, because it is uncertain which one is meant.
std::map<std::int32_t, RegionLabel> LabelFinder::seeded() const {
  std::map<std::int32_t, RegionLabel> labels;
  const auto& seeds = checked_.specification().names.seeds;
  for (Index s = 0; s < seeds.size(); ++s) {
    const auto regions = regions_at(checked_.mesh(), seeds[s].point);
    if (regions.size() == 1) labels.try_emplace(regions[0], RegionLabel{LabelKind::seed, s, seeds[s].name});
  }
  return labels;
}

/// Returns the label of the innermost body around a region: one that contains no other body around it; the first if
/// there are several. A body lies within another if all regions in it are in the other, but not vice versa.
std::optional<RegionLabel> LabelFinder::body_label(const std::vector<std::vector<Index>>& about,
                                                   const std::vector<Index>& own) const {
  const auto is_within = [&](Index inner, Index outer) {
    bool all = true, strictly = false;
    for (const auto& bodies : about) {
      all = all && (!holds(bodies, inner) || holds(bodies, outer));
      strictly = strictly || (holds(bodies, outer) && !holds(bodies, inner));
    }
    return all && strictly;
  };
  for (const Index body : own)
    if (std::none_of(own.begin(), own.end(), [&](Index other) { return other != body && is_within(other, body); }))
      return RegionLabel{LabelKind::body, body, checked_.specification().surfaces[body].name};
  return std::nullopt;
}

std::map<std::int32_t, AllowedLabels> LabelFinder::labels() const {
  std::map<std::int32_t, std::optional<std::vector<Index>>> bodies;
  std::vector<std::vector<Index>> about;
  for (const auto& [region, place] : places_) {
    const auto& own = bodies[region] = bodies_about(place);
    about.push_back(own.value_or(std::vector<Index>{}));
  }
  const std::map<std::int32_t, RegionLabel> by_seed = seeded();
  std::map<std::int32_t, AllowedLabels> labels;
  for (const auto& [region, place] : places_) {
    AllowedLabels& allowed = labels[region];
    if (const auto seed = by_seed.find(region); seed != by_seed.end()) {
      allowed.push_back(seed->second);
    } else if (!bodies[region]) {
      continue;
    } else if (const auto body = body_label(about, *bodies[region])) {
      allowed.push_back(*body);
    } else if (!units_.given()) {
      allowed.push_back({});
    } else if (place.volume <= least_volume_) {
      continue;
    } else {
      for (const UnitVerdict& verdict : units_.verdicts_of(region, place)) {
        if (verdict.close) {
          allowed.clear();
          break;
        }
        RegionLabel label{LabelKind::unnamed, 0, units_.name_of(verdict)};
        if (!label.name.empty()) {
          label.kind = LabelKind::unit;
          label.rank = 2 * verdict.first + (verdict.last > verdict.first ? 1 : 0);
        }
        const bool known = std::any_of(allowed.begin(), allowed.end(),
                                       [&](const RegionLabel& other) { return other.name == label.name; });
        if (!known) allowed.push_back(std::move(label));
      }
    }
  }
  return labels;
}

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/framework/fault_truncations.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <ranges>

#include "geomesh/core/surface_distance.hpp"
#include "naming/sums.hpp"
#include "rules/framework/end_at_walls.hpp"
#include "rules/framework/overshoots.hpp"
#include "rules/framework/walls.hpp"
#include "rules/planar/borders.hpp"

namespace geomesh::geomodel {
namespace {

bool is_inside(const Box3& box, const Vec3& p) {
  return p.x > box.min.x && p.y > box.min.y && p.z > box.min.z && p.x < box.max.x && p.y < box.max.y && p.z < box.max.z;
}

/// The ends of a border edge, each given by its position along strike and its height.
using SeenAlongStrike = std::array<std::array<double, 2>, 2>;

/// Returns whether an edge passes above a place, as seen along the fault. If two edges meet exactly above the place,
/// only the one that begins there counts.
bool is_over(const SeenAlongStrike& edge, const std::array<double, 2>& place) {
  const auto& [a, b] = edge;
  if (std::min(a[0], b[0]) > place[0] || std::max(a[0], b[0]) <= place[0]) return false;
  return a[1] + (place[0] - a[0]) / (b[0] - a[0]) * (b[1] - a[1]) > place[1];
}

/// A place on the upper border of a fault, and the corner opposite the border of the triangle at that place.
struct UpperPlace {
  Vec3 at, opposite;
};

/// Returns the midpoints, inside the model, of a fault's border edges along strike that have no border edge above them.
std::vector<UpperPlace> upper_border(const TriangulatedSurface& fault, const Box3& box) {
  const Frame frame = frame_of(fault);
  const auto seen = [&](const Vec3& p) { return std::array<double, 2>{frame.to_frame(p).x, p.z}; };
  const std::vector<BorderEdge> border = border_edges(fault);
  std::vector<SeenAlongStrike> edges;
  for (const BorderEdge& e : border) edges.push_back({seen(fault.points[e.a]), seen(fault.points[e.b])});
  std::vector<UpperPlace> upper;
  for (Index e = 0; e < border.size(); ++e) {
    const Vec3 &a = fault.points[border[e].a], &b = fault.points[border[e].b];
    const Vec3 middle = 0.5 * (a + b);
    const Vec3 way = frame.to_frame(b) - frame.to_frame(a);
    // Skips the fault's border edges at its lateral ends, and those outside the model.
    if (std::abs(way.x) <= std::abs(way.y) || !is_inside(box, middle)) continue;
    bool is_upper = true;
    for (Index k = 0; k < border.size() && is_upper; ++k) is_upper = k == e || !is_over(edges[k], seen(middle));
    if (!is_upper) continue;
    for (const VertexIndex v : fault.triangles[border[e].triangle])
      if (v != border[e].a && v != border[e].b) upper.push_back({middle, fault.points[v]});
  }
  return upper;
}

/// Position of a fault's upper border relative to a horizon.
struct Beside {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;  ///< m
  bool is_above = true;                                                    ///< all of it
  std::size_t n_crossing = 0;  ///< number of places where the horizon cuts the fault's triangle at the border
};

/// The horizons at which a fault may end.
class Horizons {
 public:
  Horizons(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules)
      : within_(rules.continuation.within_of_faults) {
    for (Index s = 0; s < surfaces.size(); ++s) {
      if (surfaces[s].kind != SurfaceKind::horizon || surfaces[s].triangles.empty()) continue;
      if (std::ranges::find(rules.column, surfaces[s].name) == rules.column.end()) continue;
      Box3 box;
      for (const Vec3& p : surfaces[s].points) box.add(p);
      for (std::size_t i = 0; i < 3; ++i) box.min[i] -= within_, box.max[i] += within_;
      horizons_.push_back({s, rules.of(s).base == BaseRule::erode, box,
                           SurfaceDistance(surfaces[s].points, surfaces[s].triangles), Walls(surfaces, {s}, {})});
    }
  }

  std::vector<Index> truncating(const std::vector<UpperPlace>& border) const {
    std::vector<Index> rows;
    std::optional<Index> best;
    double farthest = within_;
    for (const Horizon& h : horizons_) {
      if (std::ranges::none_of(border, [&](const UpperPlace& p) { return is_inside(h.near, p.at); })) continue;
      const Beside found = beside(border, h);
      if (h.erodes && found.nearest <= within_) rows.push_back(h.row);
      const bool runs_on = 2 * found.n_crossing > border.size();
      if (h.erodes || (found.is_above && !runs_on) || found.farthest > farthest) continue;
      farthest = found.farthest;
      best = h.row;
    }
    if (best && rows.empty()) rows.push_back(*best);
    std::ranges::sort(rows);
    return rows;
  }

 private:
  struct Horizon {
    Index row;
    bool erodes;
    Box3 near;
    SurfaceDistance distance;
    Walls itself;
  };

  static Beside beside(const std::vector<UpperPlace>& border, const Horizon& horizon) {
    Beside found;
    for (const auto& [p, opposite] : border) {
      const Vec3 q = horizon.distance.closest(p);
      const double d = norm(p - q);
      found.nearest = std::min(found.nearest, d);
      found.farthest = std::max(found.farthest, d);
      found.is_above = found.is_above && p.z >= q.z;
      found.n_crossing += horizon.itself.first_surface(p, opposite, no_index).has_value() ? 1 : 0;
    }
    return found;
  }

  double within_;
  std::vector<Horizon> horizons_;
};

}  // namespace

std::vector<std::pair<Index, Index>> fault_truncations(const std::vector<TriangulatedSurface>& surfaces,
                                                       const ModelRules& rules) {
  std::vector<std::pair<Index, Index>> truncations;
  if (!(rules.continuation.within_of_faults > 0)) return truncations;
  std::optional<Horizons> horizons;
  for (Index s = 0; s < surfaces.size(); ++s) {
    const SurfaceRules rule = rules.of(s);
    if (surfaces[s].kind != SurfaceKind::fault || surfaces[s].triangles.empty() || !rule.continues ||
        rule.extend != Extend::none || !rule.stop_at.empty())
      continue;
    const std::vector<UpperPlace> border = upper_border(surfaces[s], rules.continuation.bounds);
    if (border.empty()) continue;
    if (!horizons) horizons.emplace(surfaces, rules);
    for (const Index h : horizons->truncating(border)) truncations.emplace_back(s, h);
  }
  return truncations;
}

std::vector<Index> truncating_horizons(const std::vector<std::pair<Index, Index>>& truncations) {
  std::vector<Index> rows;
  for (const auto& [_, horizon] : truncations) rows.push_back(horizon);
  std::ranges::sort(rows);
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

std::vector<std::string> unconformities(const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                                        const ModelRules& rules) {
  const std::vector<Index> truncating = truncating_horizons(built.truncations);
  std::vector<std::string> names;
  for (Index s = 0; s < surfaces.size(); ++s)
    if (rules.of(s).base == BaseRule::erode || std::ranges::binary_search(truncating, s))
      names.push_back(surfaces[s].name);
  return names;
}

void truncate_faults(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                     double within, std::vector<double>& area, std::vector<std::string>& notes) {
  for (const auto& [fault, horizon] : built.truncations)
    area[fault] +=
        remove_overshoots(working, {fault, {horizon}, within, part_of(built, fault)}, surfaces[fault].name, notes);
}

}  // namespace geomesh::geomodel

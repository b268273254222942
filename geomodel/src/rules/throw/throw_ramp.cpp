// SPDX-License-Identifier: GPL-3.0-or-later
// Detects ramps in segments along the fault, from the slopes of triangles perpendicular to it.
#include "rules/throw/throw_ramp.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/single_valued.hpp"
#include "rules/throw/sheet_sides.hpp"

namespace geomesh::geomodel {
namespace {

// Lengths, in median edge lengths of the horizon in the map: of a segment along the fault, and of the zones on both
// sides of a ramp in which the slope of the horizon itself is measured.
constexpr double stretch_length = 8;
constexpr double ring_width = 8;
// Distances from the fault, in median edge lengths, at which the zones beside a ramp begin; smaller ones are used if
// too few triangles lie in a zone because other faults are near.
constexpr std::array<long, 3> rings{8, 5, 3};
constexpr std::size_t fewest_in_ring = 6;
// A ramp (throw smeared by gridding) is steeper than the slopes beside it by at least this many standard deviations.
constexpr double sure_of_spread = 3;
// A ramp across a fault is steeper than its surroundings by at least this multiple of the sides' difference in slope.
constexpr double sure_of_difference = 2;
constexpr double least_slope = 0.02;  // slope by which a ramp across a fault is at least steeper than its surroundings
constexpr double ramp_ends_at = 0.1;  // fraction of the ramp's greatest slope at which the ramp ends
constexpr double share_of_stretches = 0.25;

/// The slope of a triangle of the horizon, perpendicular to the fault.
struct SlopeBeside {
  double across, slope;
};

/// The ramp of a horizon in a segment of the fault; nothing if the horizon's slope is not known on both sides of it.
struct StretchRamp {
  bool is_ramp = false;
  double step = 0;  ///< height of the ramp across the fault, in the horizon's median edge lengths
  RampWidth width;
};
std::optional<StretchRamp> ramp_within(const std::vector<SlopeBeside>& slopes, long ring_from) {
  std::vector<double> ring[2], off;
  std::map<long, std::vector<double>> bins;
  for (const SlopeBeside& s : slopes) {
    const double d = std::abs(s.across);
    if (d > static_cast<double>(ring_from) && d <= static_cast<double>(ring_from) + ring_width)
      ring[s.across > 0 ? 1 : 0].push_back(s.slope);
    if (d < static_cast<double>(ring_from)) bins[static_cast<long>(std::floor(s.across))].push_back(s.slope);
  }
  if (ring[0].size() < fewest_in_ring || ring[1].size() < fewest_in_ring) return std::nullopt;
  const double low = median(ring[0]), high = median(ring[1]);
  for (const double s : ring[0]) off.push_back(std::abs(s - low));
  for (const double s : ring[1]) off.push_back(std::abs(s - high));
  constexpr double normal_by_median = 1.4826, half_ring = 0.5 * ring_width;
  const double middle = static_cast<double>(ring_from) + half_ring;
  const double spread = normal_by_median * median(off);
  std::map<long, double> excess;
  for (const auto& [bin, values] : bins) {
    const double place = static_cast<double>(bin) + 0.5;
    excess[bin] = median(values) - (low + (high - low) * (place + middle) / (2 * middle));
  }
  long steepest = 0;
  double greatest = 0;
  for (const long bin : {-1L, 0L, -2L, 1L})
    if (excess.contains(bin) && std::abs(excess[bin]) > std::abs(greatest)) steepest = bin, greatest = excess[bin];
  StretchRamp found;
  found.is_ramp =
      std::abs(greatest) > std::max({sure_of_spread * spread, sure_of_difference * std::abs(high - low), least_slope});
  if (!found.is_ramp) return found;
  const auto is_steep = [&](long bin) {
    return excess.contains(bin) && excess[bin] / greatest > std::max(ramp_ends_at, spread / std::abs(greatest));
  };
  long first = steepest, last = steepest;
  while (is_steep(first - 1)) --first;
  while (is_steep(last + 1)) ++last;
  for (long bin = first; bin <= last; ++bin) found.step += std::abs(excess[bin]);
  // A steep zone that extends to where the slope beside it is measured is no ramp but the horizon's own slope.
  if (first <= 1 - ring_from || last >= ring_from - 2) return StretchRamp{};
  found.width = {std::max(0.0, static_cast<double>(-first)), std::max(0.0, static_cast<double>(last + 1))};
  return found;
}

std::optional<StretchRamp> ramp_in(const std::vector<SlopeBeside>& slopes) {
  for (const long ring_from : rings)
    if (const auto found = ramp_within(slopes, ring_from)) return found;
  return std::nullopt;
}

bool are_enough(std::size_t n_ramps, std::size_t n_stretches) {
  return n_ramps > 0 && static_cast<double>(n_ramps) >= share_of_stretches * static_cast<double>(n_stretches);
}

}  // namespace

bool Ramp::is_there() const { return are_enough(at.size(), n_stretches); }

RampWidth Ramp::width(long stretch) const {
  RampWidth widest;
  long nearest = at.begin()->first;
  for (const auto& [k, width] : at) {
    if (std::abs(k - stretch) < std::abs(nearest - stretch)) nearest = k;
    if (std::abs(k - stretch) > 1) continue;
    widest = {std::max(widest.below, width.below), std::max(widest.above, width.above)};
  }
  return widest.below + widest.above > 0 ? widest : at.at(nearest);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_map_edge(const TriangulatedSurface& s) {
  std::vector<double> lengths;
  for (const Triangle& t : s.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 u = s.points[t[(i + 1) % 3]] - s.points[t[i]];
      lengths.push_back(std::hypot(u.x, u.y));
    }
  return lengths.empty() ? 0 : median(std::move(lengths));
}

long stretch_at(double along, double edge) { return std::lround(along / (stretch_length * edge)); }

Ramp find_ramp(const TriangulatedSurface& horizon, std::span<const FaultFaces> faults, std::size_t own, double edge) {
  std::map<long, std::vector<SlopeBeside>> stretches;
  std::map<long, std::pair<double, double>> ends;
  for (const Triangle& t : horizon.triangles) {
    const Vec3 &a = horizon.points[t[0]], &b = horizon.points[t[1]], &c = horizon.points[t[2]];
    const Vec3 n = cross(b - a, c - a);
    if (n.z == 0) continue;
    const Vec3 centre = (1.0 / 3) * (a + b + c);
    const auto beside = faults[own].beside(centre, furthest_beside * edge);
    if (!beside || !beside->is_within) continue;
    const bool is_of_other = std::any_of(faults.begin(), faults.end(), [&](const FaultFaces& other) {
      return &other != &faults[own] && other.beside(centre, beside->distance).has_value();
    });
    if (is_of_other) continue;
    auto& [from, to] = ends.try_emplace(stretch_at(beside->along, edge), beside->along, beside->along).first->second;
    from = std::min(from, beside->along), to = std::max(to, beside->along);
    const double slope = -(n.x * beside->direction.x + n.y * beside->direction.y) / n.z;
    stretches[stretch_at(beside->along, edge)].push_back({beside->across / edge, slope});
  }
  Ramp ramp;
  for (const auto& [k, slopes] : stretches) {
    const auto found = ramp_in(slopes);
    if (!found) continue;
    ++ramp.n_stretches;
    if (!found->is_ramp) continue;
    ramp.at[k] = found->width;
    ramp.steps.push_back(found->step * edge);
    ramp.length += ends.at(k).second - ends.at(k).first;
  }
  return ramp;
}

void find_ramps(const std::vector<TriangulatedSurface>& surfaces, ModelRules& rules, std::vector<std::string>& notes) {
  std::vector<FaultFaces> faces;
  std::vector<const TriangulatedSurface*> faults;
  for (const TriangulatedSurface& s : surfaces)
    if (s.kind == SurfaceKind::fault && !s.triangles.empty()) {
      faces.emplace_back(s);
      faults.push_back(&s);
    }
  // A fault displaces two blocks and therefore all horizons in them: gridding smears its throw in all of them or in
  // none. If one horizon were restored beside others that keep their ramps, they would cross.
  std::vector<std::size_t> n_ramps(faults.size(), 0), n_stretches(faults.size(), 0);
  // For each horizon, the faults that separate its connected parts; such faults have no ramp.
  std::map<std::size_t, std::vector<bool>> parts;
  for (std::size_t s = 0; s < rules.surfaces.size(); ++s) {
    const SurfaceRules& rule = rules.surfaces[s];
    if (!rule.throw_auto || !rule.cut_smeared || !is_single_valued(surfaces[s])) continue;
    const std::vector<bool>& parted = parts[s] = parting_of(surfaces[s], faults);
    const double edge = median_map_edge(surfaces[s]);
    for (std::size_t f = 0; f < faults.size(); ++f) {
      if (parted[f]) continue;
      const Ramp ramp = find_ramp(surfaces[s], faces, f, edge);
      n_ramps[f] += ramp.at.size();
      n_stretches[f] += ramp.n_stretches;
    }
  }
  std::vector<bool> is_smeared;
  for (std::size_t f = 0; f < faults.size(); ++f) is_smeared.push_back(are_enough(n_ramps[f], n_stretches[f]));
  if (std::ranges::count(is_smeared, true) == 0) return;
  for (const auto& [s, parted] : parts)
    for (std::size_t f = 0; f < faults.size(); ++f) {
      const std::string& name = faults[f]->name;
      std::vector<std::string>& throw_at = rules.surfaces[s].throw_at;
      if (std::ranges::count(throw_at, name) > 0 || !(is_smeared[f] || parted[f])) continue;
      throw_at.push_back(name);
      notes.push_back("horizon " + surfaces[s].name +
                      (is_smeared[f] ? ": throw across " + name + " found from the data, smeared along it"
                                     : ": " + name + " lies between sheets of it, and parts them"));
    }
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/names/unit_of_region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/exact/vertical_line.hpp"
#include "check/names/sheet_sides.hpp"
#include "check/names/small_parts.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// If the smaller of two areas, of a horizon's faces above and below a region, exceeds this share of their sum, the
/// side of the horizon on which the region lies is uncertain.
constexpr double close_share = 0.45;

double area_of(const std::map<Index, double>& areas, Index h) {
  const auto at = areas.find(h);
  return at == areas.end() ? 0 : at->second;
}

}  // namespace

UnitFinder::UnitFinder(const CheckedFaces& checked, double reach) : checked_(checked) {
  const Specification& specification = checked.specification();
  const auto& column = specification.names.column;
  for (std::size_t i = 0; i < column.size(); i += 2) units_.push_back(column[i]);
  for (std::size_t i = 1; i < column.size(); i += 2)
    for (Index row = 0; row < specification.surfaces.size(); ++row) {
      if (specification.surfaces[row].name != column[i]) continue;
      horizon_of_surface_[row] = static_cast<Index>(horizons_.size());
      const auto& cutting = specification.names.unconformities;
      const bool is_unconformity = std::find(cutting.begin(), cutting.end(), column[i]) != cutting.end();
      horizons_.push_back({row, is_unconformity, upper_sides(specification.surfaces[row]),
                           TriangleSet(triangles_of(specification.surfaces[row])),
                           tree_over_triangles(specification.surfaces[row])});
    }
  left_.resize(horizons_.size());
  add_faces(reach);
}

/// Adds up for each region the areas of horizons that bound it, by the side of the horizon on which it lies. The side
/// follows from the input triangle nearest to a mesh face. Small parts merged into another unit are ignored.
void UnitFinder::add_faces(double reach) {
  const FacesFile& faces = *checked_.faces();
  const std::vector<SmallSides> in_small_part = sides_in_small_parts(checked_);
  for (Index f = 0; f < checked_.candidates().size(); ++f) {
    const Corners c = corners_of(checked_, f);
    const Vec3 normal = cross(c[1] - c[0], c[2] - c[0]), middle = (1.0 / 3) * (c[0] + c[1] + c[2]);
    const double area = 0.5 * std::sqrt(dot(normal, normal));
    for (const std::int32_t id : checked_.set_of(f)) {
      const auto at = horizon_of_surface_.find(checked_.surface_of(id));
      if (at == horizon_of_surface_.end()) continue;
      const Index h = at->second;
      const auto& surface = checked_.specification().surfaces[at->first];
      double best = -1, agreement = 0;
      for (const auto& near : horizons_[h].triangles.near(middle, reach)) {
        const Triangle& t = surface.triangles[near.triangle];
        const Vec3 n = cross(surface.points[t[1]] - surface.points[t[0]], surface.points[t[2]] - surface.points[t[0]]);
        const double size = std::sqrt(dot(n, n));
        const double cosine = size > 0 && area > 0 ? dot(n, normal) / (2 * size * area) : 0;
        if (std::abs(cosine) <= best) continue;
        best = std::abs(cosine);
        agreement = cosine * horizons_[h].upper_side[near.triangle];
      }
      if (best < least_cosine) continue;  // another check reports faces that do not lie on their surface
      const std::int32_t lower = agreement > 0 ? faces.region_minus[f] : faces.region_plus[f];
      const std::int32_t upper = agreement > 0 ? faces.region_plus[f] : faces.region_minus[f];
      const auto [minus_is_small, plus_is_small] = in_small_part[f];
      if (lower == upper) {
        if (!minus_is_small && !plus_is_small) contacts_[lower].both[h] += area;
      } else {
        const bool lower_is_minus = agreement > 0;
        if (!(lower_is_minus ? minus_is_small : plus_is_small)) contacts_[lower].below[h] += area;
        if (!(lower_is_minus ? plus_is_small : minus_is_small)) contacts_[upper].above[h] += area;
      }
      TriangulatedSurface& left = left_[h];
      const auto first = static_cast<VertexIndex>(left.points.size());
      left.points.insert(left.points.end(), c.begin(), c.end());
      left.triangles.push_back({first, first + 1, first + 2});
    }
  }
}

UnitVerdict UnitFinder::verdict_of(const Contacts& contacts) const {
  UnitVerdict verdict;
  Index first = 0, last = static_cast<Index>(units_.size() - 1);
  bool has_over = false, has_under = false;
  for (Index h = 0; h < horizons_.size(); ++h) {
    const double below = area_of(contacts.below, h), above = area_of(contacts.above, h);
    if (!(std::max(below, above) > 0)) continue;
    // A horizon does not bound the region if the region lies on both sides of it, or of a horizon beyond it, over a
    // larger area.
    const auto goes_on = [&](const auto& both) {
      return (below >= above ? both.first <= h : both.first >= h) && both.second > std::max(below, above);
    };
    if (std::any_of(contacts.both.begin(), contacts.both.end(), goes_on)) continue;
    verdict.close = verdict.close || std::min(below, above) > close_share * (below + above);
    if (below >= above) {
      first = std::max(first, h + 1);
      has_over = true;
    } else {
      last = std::min(last, h);
      has_under = true;
    }
  }
  // The horizons leave the region one possible unit. Or they contradict each other, because the region is above a
  // horizon and below an older one: then its unit is the one just above the younger horizon.
  if (first >= last) {
    verdict.first = verdict.last = last;
    return verdict;
  }
  for (const auto& [h, area] : contacts.both) {
    if (h < first || h >= last) continue;
    verdict.first = std::min(verdict.first, h);
    verdict.last = h + 1;
  }
  if (verdict.first == no_index && (has_over || has_under)) {
    const bool is_eroded = has_over && has_under && horizons_[first - 1].is_unconformity;
    verdict.first = verdict.last = has_over && !is_eroded ? first : last;
    verdict.open = true;
    verdict.first_possible = first;
    verdict.last_possible = last;
  }
  return verdict;
}

/// Returns the horizons directly above and below a point, taken from their parts in the mesh, else from the input.
UnitFinder::Contacts UnitFinder::on_vertical(const Vec3& p) const {
  Contacts contacts;
  for (const bool of_input : {false, true}) {
    double over = std::numeric_limits<double>::infinity(), under = -over;
    Index above = no_index, below = no_index;
    for (Index h = 0; h < horizons_.size(); ++h) {
      const TriangulatedSurface& s = of_input ? checked_.specification().surfaces[horizons_[h].surface] : left_[h];
      if (s.triangles.empty()) continue;
      const auto look_at = [&](Index, double z) {
        if (z >= p.z && (z < over || (z == over && h > above))) over = z, above = h;
        if (z < p.z && (z > under || (z == under && h < below))) under = z, below = h;
      };
      for_each_height(s, of_input ? horizons_[h].tree : tree_over_triangles(s), p, 0, look_at);
    }
    if (above != no_index) contacts.below[above] = 1;
    if (below != no_index) contacts.above[below] = 1;
    if (above != no_index || below != no_index) break;
  }
  return contacts;
}

bool UnitFinder::narrow(const Vec3& p, Index& first, Index& last) const {
  Index least = first, most = last;
  bool tells = false;
  for (Index h = first; h < last; ++h) {
    const TriangulatedSurface& s = checked_.specification().surfaces[horizons_[h].surface];
    bool is_over = false, is_under = false;
    for_each_height(s, horizons_[h].tree, p, 0, [&](Index, double z) { (z >= p.z ? is_over : is_under) = true; });
    tells = tells || is_over || is_under;
    if (is_over && !is_under) least = std::max(least, h + 1);
    if (is_under && !is_over) most = std::min(most, h);
  }
  if (least <= most) {
    first = least;
    last = most;
  }
  return tells;
}

UnitFinder::Narrowed UnitFinder::narrowed(const RegionPlace& place, Index first, Index last) const {
  Narrowed found{{}, true};
  for (const Vec3& p : place.samples) {
    Index least = first, most = last;
    const bool tells = narrow(p, least, most);
    found.tells_everywhere = found.tells_everywhere && tells;
    for (Index u = least; tells && u <= most; ++u) found.verdicts.push_back({u, u});
  }
  return found;
}

std::vector<UnitVerdict> UnitFinder::verdicts_of(std::int32_t region, const RegionPlace& place) const {
  const auto at = contacts_.find(region);
  if (at != contacts_.end()) {
    const UnitVerdict verdict = verdict_of(at->second);
    if (verdict.open) {
      const auto [left, tells_everywhere] = narrowed(place, verdict.first_possible, verdict.last_possible);
      std::vector<UnitVerdict> allowed = left;
      if (!tells_everywhere) allowed.push_back(verdict);
      return allowed;
    }
    if (verdict.first != no_index || verdict.close) return {verdict};
  }
  const Narrowed by_input = narrowed(place, 0, static_cast<Index>(units_.size() - 1));
  std::vector<UnitVerdict> verdicts = by_input.verdicts;
  const bool is_one =
      by_input.tells_everywhere && std::all_of(verdicts.begin(), verdicts.end(),
                                               [&](const UnitVerdict& v) { return v.first == verdicts.front().first; });
  if (!verdicts.empty() && is_one) return verdicts;
  for (const Vec3& p : place.samples) verdicts.push_back(verdict_of(on_vertical(p)));
  return verdicts;
}

std::string UnitFinder::name_of(const UnitVerdict& verdict) const {
  if (verdict.first == no_index) return "";
  std::string name = units_[verdict.first];
  for (Index u = verdict.first + 1; u <= verdict.last; ++u) name += "+" + units_[u];
  return name;
}

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/throw/sheet_sides.hpp"

#include <algorithm>

#include "naming/region_facts.hpp"
#include "naming/sheets.hpp"
#include "rules/planar/map_locator.hpp"

namespace geomesh::geomodel {
namespace {

// Least fraction of a connected part's area on each side of a fault for the part to continue across it.
constexpr double least_of_sides = 0.1;
// Least fraction of a connected part on each side of a fault that it crosses, if another part lies on the smaller side.
constexpr double least_beside_another = 0.25;
// Least fraction of a connected part on each side of a fault that it crosses, if other faults separate these sides.
constexpr double least_of_corner = 0.02;
// Area below which a connected part of a horizon is ignored, as a fraction of the horizon's area.
constexpr double least_sheet = 0.005;

std::vector<Vec3> centres_of(const TriangulatedSurface& s) {
  std::vector<Vec3> centres;
  for (const Triangle& t : s.triangles) centres.push_back(centre_of(s, t));
  return centres;
}

/// Returns planes through the centres of a surface's triangles, with normals to the same side.
std::vector<SidedPlane> planes_of(const TriangulatedSurface& s) {
  const UpwardSides up = orient_upward(s);
  std::vector<SidedPlane> planes;
  for (Index t = 0; t < s.triangles.size(); ++t) {
    const Triangle& v = s.triangles[t];
    const Vec3 n = cross(s.points[v[1]] - s.points[v[0]], s.points[v[2]] - s.points[v[0]]);
    planes.push_back({centre_of(s, v), up.as_stored[t] ? n : -1.0 * n});
  }
  return planes;
}

}  // namespace

std::vector<std::pair<Index, Index>> neighbours_in(const TriangulatedSurface& s) {
  const std::vector<Triangle> triangles = merged_triangles(s);
  std::map<std::pair<VertexIndex, VertexIndex>, Index> first;
  std::vector<std::pair<Index, Index>> pairs;
  for (Index t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexIndex a = triangles[t][i], b = triangles[t][(i + 1) % 3];
      if (a == b) continue;
      const auto [at, is_new] = first.emplace(std::pair(std::min(a, b), std::max(a, b)), t);
      if (!is_new) pairs.emplace_back(at->second, t);
    }
  return pairs;
}

FaultSides::FaultSides(const TriangulatedSurface& fault)
    : planes_(planes_of(fault)), nearest_(centres_of(fault)), bounds_(planes_) {}

bool FaultSides::is_above(const Vec3& p) const {
  if (const SideOfAll side = bounds_.side(p); side != SideOfAll::not_known) return side == SideOfAll::above;
  const Index nearest = nearest_.find(p);
  return nearest != no_index && dot(p - planes_[nearest].point, planes_[nearest].normal) > 0;
}

SheetSides::SheetSides(const TriangulatedSurface& horizon, const std::vector<const TriangulatedSurface*>& faults)
    : horizon_(horizon), n_faults_(faults.size()) {
  sheet_ = sheets_of(horizon.triangles.size(), neighbours_in(horizon), [](Index, Index) { return true; });
  std::vector<FaultSides> fault_sides;
  for (const TriangulatedSurface* fault : faults) fault_sides.emplace_back(*fault);
  const AreaSamples samples(horizon);
  for (Index t = 0; t < sheet_.size(); ++t)
    samples.for_each(t, [&](const Vec3& place, double area) {
      Part part{sheet_[t], place, area, {}};
      for (const FaultSides& f : fault_sides) part.above.push_back(f.is_above(place));
      Sheet& sheet = sheets_.try_emplace(part.sheet, Sheet{0, std::vector<double>(n_faults_, 0)}).first->second;
      sheet.add(part);
      area_ += area;
      parts_.push_back(std::move(part));
    });
}

SheetSides::SmallerPart SheetSides::smaller_part(Index own, std::size_t fault) const {
  TriangulatedSurface others = horizon_;
  others.triangles.clear();
  for (Index t = 0; t < sheet_.size(); ++t)
    if (sheet_[t] != own) others.triangles.push_back(horizon_.triangles[t]);
  const MapLocator over(others);
  const bool is_above_smaller = !sheets_.at(own).is_above(fault);
  Sheet smaller{0, std::vector<double>(n_faults_, 0)};
  double alone = 0;
  for (const Part& part : parts_) {
    if (part.sheet != own || part.above[fault] != is_above_smaller) continue;
    smaller.add(part);
    if (over.find({part.place.x, part.place.y}).count == 0) alone += part.area;
  }
  const bool has_another = std::any_of(sheets_.begin(), sheets_.end(), [&](const auto& other) {
    for (std::size_t f = 0; f < n_faults_; ++f)
      if (other.second.is_above(f) != smaller.is_above(f)) return false;
    return other.first != own;
  });
  return {alone, has_another};
}

bool SheetSides::runs_across(std::size_t fault) const {
  return std::any_of(sheets_.begin(), sheets_.end(), [&](const auto& entry) {
    const Sheet& sheet = entry.second;
    if (sheet.smaller(fault) <= least_of_sides * sheet.area) return false;
    const SmallerPart part = smaller_part(entry.first, fault);
    return part.alone > (part.has_another ? least_beside_another : least_of_sides) * sheet.area;
  });
}

bool SheetSides::parts_alone(std::size_t fault, const std::vector<bool>& counts) const {
  // For each combination of sides of the other faults: whether parts of the horizon lie below and above `fault`.
  std::map<std::vector<bool>, std::pair<bool, bool>> found;
  for (const auto& entry : sheets_) {
    const Sheet& sheet = entry.second;
    if (sheet.area < least_sheet * area_) continue;
    std::vector<bool> others;
    for (std::size_t f = 0; f < n_faults_; ++f)
      if (f != fault && counts[f]) others.push_back(sheet.is_above(f));
    auto& [below, above] = found[others];
    (sheet.is_above(fault) ? above : below) = true;
  }
  return std::any_of(found.begin(), found.end(),
                     [](const auto& entry) { return entry.second.first && entry.second.second; });
}

bool SheetSides::parts_any(std::size_t fault) const { return parts_alone(fault, std::vector<bool>(n_faults_, false)); }

double SheetSides::largest_corner(std::size_t fault) const {
  double largest = 0;
  for (const auto& [own, sheet] : sheets_)
    if (sheet.smaller(fault) > least_of_corner * sheet.area)
      largest = std::max(largest, smaller_part(own, fault).alone / sheet.area);
  return largest;
}

double SheetSides::on_wrong_side(std::size_t fault) const {
  double area = 0;
  for (const auto& entry : sheets_) area += entry.second.smaller(fault);
  return area;
}

template <class F>
std::size_t SheetSides::least_needed(const std::vector<bool>& counts, double least, F&& much) const {
  std::size_t found = n_faults_;
  for (std::size_t f = 0; f < n_faults_; ++f) {
    if (!counts[f] || !parts_any(f) || parts_alone(f, counts)) continue;
    const double here = much(f);
    if (here > least) found = f, least = here;
  }
  return found;
}

std::vector<bool> SheetSides::run_across() const {
  std::vector<bool> counts(n_faults_);
  for (std::size_t f = 0; f < n_faults_; ++f) counts[f] = !runs_across(f);
  const auto corner = [this](std::size_t f) { return largest_corner(f); };
  for (;;) {  // faults are dropped one at a time, because the others may then be needed to separate the horizon's parts
    const std::size_t next = least_needed(counts, least_of_corner, corner);
    if (next == n_faults_) break;
    counts[next] = false;
  }
  counts.flip();
  return counts;
}

std::vector<bool> SheetSides::parting() const {
  std::vector<bool> counts = run_across();
  counts.flip();
  const auto wrong = [&](std::size_t f) { return on_wrong_side(f); };
  for (;;) {
    const std::size_t next = least_needed(counts, -1, wrong);
    if (next == n_faults_) break;
    counts[next] = false;
  }
  for (std::size_t f = 0; f < n_faults_; ++f) counts[f] = counts[f] && parts_alone(f, counts);
  return counts;
}

std::vector<bool> parting_of(const TriangulatedSurface& horizon,
                             const std::vector<const TriangulatedSurface*>& faults) {
  const std::vector<Index> sheet =
      sheets_of(horizon.triangles.size(), neighbours_in(horizon), [](Index, Index) { return true; });
  if (std::ranges::all_of(sheet, [&](Index s) { return s == sheet.front(); }))
    return std::vector<bool>(faults.size(), false);
  return SheetSides(horizon, faults).parting();
}

}  // namespace geomesh::geomodel

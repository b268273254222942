// SPDX-License-Identifier: GPL-3.0-or-later
// Checks volumes of regions whose boundary moved within a tolerance, declared in check/within/within_tolerance.hpp.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "check/exact/crossing.hpp"
#include "check/exact/exact.hpp"
#include "check/mesh/faults.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {
namespace {

double face_area(const Corners& c) {
  const Vec3 n = cross(c[1] - c[0], c[2] - c[0]);
  return 0.5 * std::sqrt(dot(n, n));
}

/// Returns for each region the area of its boundary faces that can have moved, without those only on box sides.
std::map<std::int32_t, double> movable_areas(const CheckedFaces& checked) {
  std::map<std::int32_t, double> areas;
  const FacesFile& faces = *checked.faces();
  for (Index f = 0; f < checked.candidates().size(); ++f) {
    if (checked.is_side_alone(f) || faces.region_minus[f] == faces.region_plus[f]) continue;
    const double area = face_area(corners_of(checked, f));
    areas[faces.region_minus[f]] += area;
    areas[faces.region_plus[f]] += area;
  }
  return areas;
}

/// Returns the exactly summed volume of the closed surface; nothing if it is open or inconsistently oriented.
std::optional<double> enclosed_volume(const TriangulatedSurface& s) {
  std::map<std::array<std::array<double, 3>, 2>, int> edges;
  const auto key = [&](VertexIndex v) { return std::array{s.points[v].x, s.points[v].y, s.points[v].z}; };
  ExactVolume sum;
  const Vec3& o = s.points[s.triangles[0][0]];
  for (const Triangle& t : s.triangles) {
    sum.add(o, s.points[t[0]], s.points[t[1]], s.points[t[2]]);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = key(t[i]), b = key(t[(i + 1) % 3]);
      edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  if (std::any_of(edges.begin(), edges.end(), [](const auto& e) { return e.second != 0; })) return std::nullopt;
  return std::abs(sum.value());
}

class VolumesWithin {
 public:
  VolumesWithin(const CheckedFaces& checked, const Allowed& allowed)
      : checked_(checked), allowed_(allowed), areas_(movable_areas(checked)) {}

  void check_regions(const nlohmann::json& report, CheckResult& result);
  void check_bodies(CheckResult& result);

 private:
  /// Returns the volumes of regions that the report gives, by name; empty if it has none.
  std::map<std::string, double> told_volumes(const nlohmann::json& report) const;
  bool is_open_or_crosses_itself(const Body& body) const;

  const CheckedFaces& checked_;
  Allowed allowed_;
  std::map<std::int32_t, double> areas_;
};

std::map<std::string, double> VolumesWithin::told_volumes(const nlohmann::json& report) const {
  std::map<std::string, double> told;
  const auto regions = report.find("regions");
  if (regions == report.end() || !regions->is_array()) return told;
  for (const auto& r : *regions)
    if (r.contains("volume_of_input") && r["volume_of_input"].is_number() && r.contains("name") &&
        r["name"].is_string())
      told[r["name"].get<std::string>()] = r["volume_of_input"].get<double>();
  return told;
}

void VolumesWithin::check_regions(const nlohmann::json& report, CheckResult& result) {
  const auto told = told_volumes(report);
  if (told.empty()) {
    result.checks_done.emplace_back(
        "no report with the regions' volumes in the input stands beside the mesh: these were not checked");
    return;
  }
  FaultCollector wrong("region_volumes");
  std::string how;
  double sum = 0, largest = 0;
  for (const auto& region : result.regions) {
    const auto input = told.find(region.name);
    const double bound = areas_[region.id] * allowed_.both() + 1e-12 * region.volume;
    const double change = input == told.end() ? region.volume : std::abs(region.volume - input->second);
    sum += input == told.end() ? 0 : input->second;
    if (bound > 0) largest = std::max(largest, change / bound);
    if (change <= bound) continue;
    wrong.add(static_cast<std::size_t>(region.id), {});
    char text[160];
    std::snprintf(text, sizeof text, "%s%.60s: %.9g, in the input %.9g, allowed %.3g", how.empty() ? "" : "; ",
                  region.name.c_str(), region.volume, input == told.end() ? 0 : input->second, bound);
    how += text;
  }
  const Specification& specification = checked_.specification();
  if (specification.volume && !specification.ends_inside && std::abs(sum / specification.volume->volume - 1) > 1e-9) {
    wrong.add(0, {});
    how += how.empty() ? "those of the report do not fill the box" : "; those of the report do not fill the box";
  }
  wrong.report(result,
               "region volumes differ from the input's by more than area of boundary times tolerance (" + how + ")");
  char text[160];
  std::snprintf(
      text, sizeof text,
      "region volumes are those of the input, but for at most %.3g of what boundary area times tolerance allows",
      largest);
  if (wrong.count() == 0) result.checks_done.emplace_back(text);
}

/// Returns for each region the centroid of its largest tetrahedron, a point well inside the region.
std::map<std::int32_t, Vec3> inner_places(const CheckedMesh& mesh) {
  std::map<std::int32_t, std::pair<double, Index>> largest;
  for (Index t = 0; t < mesh.cells.size(); ++t) {
    const Tetrahedron& c = mesh.cells[t];
    const double volume = six_volumes(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2]), mesh.point(c[3]));
    auto& best = largest.try_emplace(mesh.file.region[t], -1, t).first->second;
    if (volume > best.first) best = {volume, t};
  }
  std::map<std::int32_t, Vec3> places;
  for (const auto& [region, best] : largest) places[region] = centroid(mesh, mesh.cells[best.second]);
  return places;
}

bool lies_in(const Vec3& p, const Body& body) {
  const auto winding = winding_about_centroid(body.surface->points, body.surface->triangles, body.tree, p, p, p);
  return winding && *winding != 0;
}

/// Returns whether an edge of the body has another number of faces than two. Then the box cuts the body, or the body
/// crosses itself and encloses parts of space twice. A body without faces is left to other checks.
bool VolumesWithin::is_open_or_crosses_itself(const Body& body) const {
  std::map<std::array<VertexIndex, 2>, int> uses;
  const auto row = static_cast<Index>(body.surface - checked_.specification().surfaces.data());
  for (Index f = 0; f < checked_.candidates().size(); ++f) {
    if (!checked_.carries(f, row)) continue;
    const Triangle& t = checked_.candidates()[f];
    for (std::size_t i = 0; i < 3; ++i) ++uses[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
  }
  return uses.empty() || std::any_of(uses.begin(), uses.end(), [](const auto& u) { return u.second != 2; });
}

void VolumesWithin::check_bodies(CheckResult& result) {
  FaultCollector wrong("body_volumes");
  std::string how;
  std::size_t n_checked = 0;
  const std::map<std::int32_t, Vec3> places = inner_places(checked_.mesh());
  for (const Body& body : checked_.bodies()) {
    if (body.surface->triangles.empty() || is_open_or_crosses_itself(body)) continue;
    const auto input = enclosed_volume(*body.surface);
    if (!input) continue;
    ++n_checked;
    double inside = 0, area = 0;
    for (const auto& region : result.regions)
      if (lies_in(places.at(region.id), body)) inside += region.volume;
    for (const Triangle& t : body.surface->triangles)
      area += face_area({body.surface->points[t[0]], body.surface->points[t[1]], body.surface->points[t[2]]});
    const double bound = area * allowed_.both() + 1e-12 * *input;
    if (std::abs(inside - *input) <= bound) continue;
    wrong.add(static_cast<std::size_t>(body.surface - checked_.specification().surfaces.data()),
              body.surface->points[body.surface->triangles[0][0]]);
    char text[160];
    std::snprintf(text, sizeof text, "%s%.60s: %.9g, in the input %.9g, allowed %.3g", how.empty() ? "" : "; ",
                  body.surface->name.c_str(), inside, *input, bound);
    how += text;
  }
  wrong.report(result,
               "bodies hold a volume that differs from the input's by more than area times tolerance (" + how + ")");
  if (wrong.count() == 0 && n_checked > 0)
    result.checks_done.push_back(std::to_string(n_checked) +
                                 " closed bodies hold the volume of their input, within area times tolerance");
}

}  // namespace

void check_volumes_within(const CheckedFaces& checked, const Allowed& allowed,
                          const std::optional<nlohmann::json>& report, CheckResult& result) {
  if (checked.mesh().file.region.empty()) return;
  VolumesWithin volumes(checked, allowed);
  volumes.check_regions(report ? *report : nlohmann::json::object(), result);
  volumes.check_bodies(result);
}

}  // namespace geomesh::geomodel::checking

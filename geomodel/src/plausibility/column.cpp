// SPDX-License-Identifier: GPL-3.0-or-later
// Horizons and the column, declared in plausibility/doubts.hpp.
#include <algorithm>

#include "plausibility/doubts.hpp"
#include "rules/planar/map_locator.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t most_samples = 500;  // triangles of a horizon in no column
/// Share of the samples on one side of a horizon of the column, from which on the two do not cross.
constexpr double nearly_all = 0.98;

/// 1: above, -1: below, 0: the two cross, or lie nowhere over each other.
int side_of(const TriangulatedSurface& surface, const MapLocator& other) {
  const std::size_t step = 1 + surface.triangles.size() / most_samples;
  std::size_t above = 0, below = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); t += step) {
    const Triangle& v = surface.triangles[t];
    const Vec3 corners[3] = {surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]};
    for (const Vec3& p : {(1.0 / 3) * (corners[0] + corners[1] + corners[2]), corners[0], corners[1], corners[2]}) {
      const auto height = other.height({p.x, p.y});
      if (height && *height != p.z) ++(p.z > *height ? above : below);
    }
  }
  const auto least = nearly_all * static_cast<double>(above + below);
  if (above + below == 0) return 0;
  return static_cast<double>(above) >= least ? 1 : static_cast<double>(below) >= least ? -1 : 0;
}

}  // namespace

void doubt_column(const Inspected& model, std::vector<Finding>& findings) {
  const std::vector<std::string>& column = model.project.column;
  if (column.size() < 2) return;
  const auto& surfaces = model.inputs.surfaces;
  std::vector<MapLocator> locators;
  std::vector<std::string> names;
  for (std::size_t i = 1; i < column.size(); i += 2)
    for (const TriangulatedSurface& s : surfaces)
      if (s.name == column[i]) locators.emplace_back(s), names.push_back(s.name);
  std::vector<std::string> left_out;
  std::string places;
  for (const TriangulatedSurface& s : surfaces) {
    const bool is_named = std::find(column.begin(), column.end(), s.name) != column.end();
    if (s.kind != SurfaceKind::horizon || is_named || s.ends_model || s.triangles.empty()) continue;
    std::string above, below;  // the nearest ones of the column
    bool in_order = true;
    for (std::size_t k = 0; in_order && k < locators.size(); ++k) {
      const int side = side_of(s, locators[k]);
      in_order = side != 0;
      if (side < 0) above = names[k];
      if (side > 0 && below.empty()) below = names[k];
    }
    if (!in_order) continue;  // it crosses what was deposited: an isotherm, a contact of fluids
    left_out.push_back(s.name);
    places += (places.empty() ? "" : ", ") + s.name +
              (above.empty()   ? " above " + below
               : below.empty() ? " below " + above
                               : " between " + above + " and " + below);
  }
  if (left_out.empty()) return;
  findings.push_back({Finding::Sureness::probable, "not in the column", left_out,
                      few_of(left_out) + (left_out.size() > 1 ? " stand" : " stands") +
                          " in no column: no unit is named by " + (left_out.size() > 1 ? "them" : "it"),
                      "by the heights the place in the column is " + places +
                          ", with a unit on either side (column: [unit, horizon, unit, ...])"});
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the order of horizons with the stratigraphic column, declared in plausibility/doubts.hpp.
#include <algorithm>
#include <functional>
#include <utility>

#include "plausibility/doubts.hpp"
#include "rules/planar/map_locator.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t most_samples = 500;  // largest number of triangles sampled on one horizon
/// One horizon counts as above another if at least this share of its sampled points is above.
constexpr double nearly_all = 0.98;

using HeightMap = std::function<double(double)>;
double as_given(double z) { return z; }

/// Returns 1 if the surface is above the other one, -1 if below, 0 if they cross or do not overlap in the map. Heights
/// of the surface are converted by `map` first.
int side_of(const TriangulatedSurface& surface, const MapLocator& other, const HeightMap& map = as_given) {
  const std::size_t step = 1 + surface.triangles.size() / most_samples;
  std::size_t above = 0, below = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); t += step) {
    const Triangle& v = surface.triangles[t];
    const Vec3 corners[3] = {surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]};
    for (const Vec3& p : {(1.0 / 3) * (corners[0] + corners[1] + corners[2]), corners[0], corners[1], corners[2]}) {
      const auto height = other.height({p.x, p.y});
      if (height && *height != map(p.z)) ++(map(p.z) > *height ? above : below);
    }
  }
  const auto least = nearly_all * static_cast<double>(above + below);
  if (above + below == 0) return 0;
  return static_cast<double>(above) >= least ? 1 : static_cast<double>(below) >= least ? -1 : 0;
}

std::vector<const TriangulatedSurface*> horizons_in_column(const Inspected& model) {
  std::vector<const TriangulatedSurface*> horizons;
  const std::vector<std::string>& column = model.project.column;
  for (std::size_t i = 1; i < column.size(); i += 2)
    for (const TriangulatedSurface& s : model.inputs.surfaces)
      if (s.name == column[i] && !s.triangles.empty()) horizons.push_back(&s);
  return horizons;
}

std::vector<MapLocator> locators_of(const std::vector<const TriangulatedSurface*>& horizons) {
  std::vector<MapLocator> locators;
  for (const TriangulatedSurface* s : horizons) locators.emplace_back(*s);
  return locators;
}

/// Finds horizons whose heights are in feet but were read as metres. In a deep model such a horizon still lies inside
/// the box: only its order in the stratigraphic column reveals the error.
void doubt_units(const Inspected& model, std::vector<Finding>& findings) {
  const std::vector<const TriangulatedSurface*> horizons = horizons_in_column(model);
  if (horizons.size() < 3) return;  // with only two horizons, either could be in the wrong unit, so none is reported
  const std::vector<MapLocator> locators = locators_of(horizons);
  // whether two horizons are in another order than in the stratigraphic column
  const auto is_against = [&](std::size_t one, std::size_t other, const HeightMap& map) {
    return side_of(*horizons[one], locators[other], map) == (other < one ? 1 : -1);
  };
  std::vector<std::pair<std::size_t, std::size_t>> against;
  for (std::size_t k = 0; k < horizons.size(); ++k)
    for (std::size_t one = 0; one < k; ++one)
      if (is_against(one, k, as_given)) against.emplace_back(one, k);
  if (against.empty()) return;
  const bool in_feet = model.project.crs.unit.starts_with("ft");
  const double factor = in_feet ? 1 / foot : foot, zero = model.project.output.origin.z;
  const HeightMap in_other_unit = [&](double z) { return factor * (z + zero) - zero; };
  for (std::size_t one = 0; one < horizons.size(); ++one) {
    bool would_be_in_order =
        std::ranges::all_of(against, [&](const auto& p) { return p.first == one || p.second == one; });
    for (std::size_t k = 0; would_be_in_order && k < horizons.size(); ++k)
      would_be_in_order = k == one || !is_against(one, k, in_other_unit);
    if (!would_be_in_order) continue;
    const std::string& name = horizons[one]->name;
    findings.push_back({Finding::Sureness::probable,
                        "unit of z",
                        {name},
                        "horizon " + name +
                            " lies against the order of the column, and would lie in it if its heights were in " +
                            (in_feet ? "metres where feet were understood" : "feet where metres were understood"),
                        std::string("if so, give 'z_unit: ") + (in_feet ? "m" : "ft") + "' in its entry"});
  }
}

}  // namespace

void doubt_column(const Inspected& model, std::vector<Finding>& findings) {
  const std::vector<std::string>& column = model.project.column;
  if (column.size() < 2) return;
  const auto& surfaces = model.inputs.surfaces;
  doubt_units(model, findings);
  const std::vector<const TriangulatedSurface*> in_column = horizons_in_column(model);
  const std::vector<MapLocator> locators = locators_of(in_column);
  std::vector<std::string> names;
  for (const TriangulatedSurface* s : in_column) names.push_back(s->name);
  std::vector<std::string> left_out;
  std::string places;
  for (const TriangulatedSurface& s : surfaces) {
    const bool is_named = std::find(column.begin(), column.end(), s.name) != column.end();
    if (s.kind != SurfaceKind::horizon || is_named || s.ends_model || s.triangles.empty()) continue;
    std::string above, below;  // the column's horizons next above and next below this surface
    bool in_order = true;
    for (std::size_t k = 0; in_order && k < locators.size(); ++k) {
      const int side = side_of(s, locators[k]);
      in_order = side != 0;
      if (side < 0) above = names[k];
      if (side > 0 && below.empty()) below = names[k];
    }
    if (!in_order) continue;  // it crosses horizons of the column: an isotherm or a fluid contact
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

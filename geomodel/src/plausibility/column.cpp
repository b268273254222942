// SPDX-License-Identifier: GPL-3.0-or-later
// Horizons and the column, declared in plausibility/doubts.hpp.
#include <algorithm>
#include <functional>

#include "plausibility/doubts.hpp"
#include "rules/planar/map_locator.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t most_samples = 500;  // triangles of a horizon in no column
/// Share of the samples on one side of a horizon of the column, from which on the two do not cross.
constexpr double nearly_all = 0.98;

/// 1: above, -1: below, 0: the two cross, or lie nowhere over each other. Heights of the surface are mapped first.
int side_of(
    const TriangulatedSurface& surface, const MapLocator& other,
    const std::function<double(double)>& map = [](double z) { return z; }) {
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

/// The horizons of the column, from the youngest to the oldest.
std::vector<const TriangulatedSurface*> horizons_in_column(const Inspected& model) {
  std::vector<const TriangulatedSurface*> horizons;
  const std::vector<std::string>& column = model.project.column;
  for (std::size_t i = 1; i < column.size(); i += 2)
    for (const TriangulatedSurface& s : model.inputs.surfaces)
      if (s.name == column[i] && !s.triangles.empty()) horizons.push_back(&s);
  return horizons;
}

/// How many pairs of horizons lie the other way round than the column has them. Heights of one are mapped.
class ColumnOrder {
 public:
  explicit ColumnOrder(const std::vector<const TriangulatedSurface*>& horizons) : horizons_(horizons) {
    for (const TriangulatedSurface* s : horizons) locators_.emplace_back(*s);
  }

  std::size_t n_against(std::size_t one, const std::function<double(double)>& map) const {
    std::size_t n = 0;
    for (std::size_t k = 0; k < horizons_.size(); ++k)
      if (k != one && side_of(*horizons_[one], locators_[k], map) == (k < one ? 1 : -1)) ++n;
    return n;
  }
  std::size_t n_against() const {
    std::size_t n = 0;
    for (std::size_t k = 0; k < horizons_.size(); ++k) n += n_against(k, [](double z) { return z; });
    return n / 2;
  }

 private:
  const std::vector<const TriangulatedSurface*>& horizons_;
  std::vector<MapLocator> locators_;
};

/// A model as deep as it is wide holds a horizon in feet that is read as metres: only the column tells.
void doubt_units(const Inspected& model, std::vector<Finding>& findings) {
  constexpr double foot = 0.3048;
  const bool in_feet = model.project.crs.unit.starts_with("ft");
  const double factor = in_feet ? 1 / foot : foot;
  const std::vector<const TriangulatedSurface*> horizons = horizons_in_column(model);
  if (horizons.size() < 3) return;  // of two it is not known which is meant
  const ColumnOrder order(horizons);
  const std::size_t n_all = order.n_against();
  if (n_all == 0) return;
  const double zero = model.project.output.origin.z;
  for (std::size_t one = 0; one < horizons.size(); ++one) {
    const bool is_the_only_one = order.n_against(one, [](double z) { return z; }) == n_all;
    if (!is_the_only_one || order.n_against(one, [&](double z) { return factor * (z + zero) - zero; }) > 0) continue;
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
  std::vector<MapLocator> locators;
  std::vector<std::string> names;
  for (const TriangulatedSurface* s : horizons_in_column(model)) locators.emplace_back(*s), names.push_back(s->name);
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

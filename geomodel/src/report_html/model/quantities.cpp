// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the quantities by which the viewer can colour a mesh, declared in viewer.hpp.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

#include "report_html/model/viewer.hpp"

namespace geomesh::geomodel::page {
namespace {

constexpr std::size_t most_quantities = 12;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Returns the range of the values without the outermost hundredth at both ends; the whole range if nothing is left.
std::pair<double, double> plain_range(const std::vector<double>& values) {
  std::vector<double> known;
  std::copy_if(values.begin(), values.end(), std::back_inserter(known), [](double v) { return std::isfinite(v); });
  if (known.empty()) return {0, 1};
  std::sort(known.begin(), known.end());
  const std::size_t cut = known.size() / 100;
  if (known[cut] < known[known.size() - 1 - cut]) return {known[cut], known[known.size() - 1 - cut]};
  return {known.front(), known.back()};
}

void set_steps(Quantity& quantity, const std::vector<double>& values) {
  constexpr double last = Quantity::not_known - 1;
  const double width = quantity.high - quantity.low;
  quantity.steps.reserve(values.size());
  for (const double v : values) {
    const double share = width > 0 ? (v - quantity.low) / width : 0.5;
    quantity.steps.push_back(std::isfinite(v)
                                 ? static_cast<std::uint8_t>(std::lround(last * std::clamp(share, 0.0, 1.0)))
                                 : Quantity::not_known);
  }
}

Quantity quantity_of(std::string name, std::string unit, const std::vector<double>& values, bool is_of_points = false) {
  Quantity quantity{std::move(name), std::move(unit), 0, 1, is_of_points};
  std::tie(quantity.low, quantity.high) = plain_range(values);
  set_steps(quantity, values);
  return quantity;
}

double mean_edge(const ModelMesh& mesh, const Tetrahedron& v) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Vec3 d = mesh.points[v[i]] - mesh.points[v[j]];
      sum += std::sqrt(dot(d, d));
    }
  return sum / 6;
}

/// Returns the quantities that describe element shapes and are known for every mesh: the first ones that the viewer
/// offers.
std::vector<Quantity> shapes(const ModelMesh& mesh) {
  std::vector<double> angles, edges;
  for (const Tetrahedron& v : mesh.tetrahedra) {
    angles.push_back(
        tetrahedron_shape(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]).min_dihedral);
    edges.push_back(mean_edge(mesh, v));
  }
  Quantity angle{"least angle", "degrees", 0, best_angle};
  set_steps(angle, angles);
  return {angle, quantity_of("edge length", mesh.unit, edges)};
}

}  // namespace

std::vector<Quantity> quantities_of(const ModelMesh& mesh) {
  std::vector<Quantity> all = shapes(mesh);
  for (const RegionAttribute& attribute : mesh.attributes) {
    std::vector<double> values;
    for (const std::int32_t region : mesh.tet_region) {
      const auto row = static_cast<std::size_t>(region - 1);
      values.push_back(row < attribute.by_region.size() ? attribute.by_region[row] : not_a_number);
    }
    all.push_back(quantity_of(attribute.name, "", values));
  }
  for (const CellArray& array : mesh.cell_arrays)
    if (array.values.size() == mesh.tetrahedra.size()) all.push_back(quantity_of(array.name, array.unit, array.values));
  for (const PointArray& array : mesh.point_arrays) {
    std::vector<double> values = array.values;
    values.resize(mesh.points.size(), not_a_number);  // midpoint nodes are not drawn
    all.push_back(quantity_of(array.name, array.unit, values, true));
  }
  if (all.size() > most_quantities) all.resize(most_quantities);
  return all;
}

MeshColours colours_of(const ModelMesh& mesh, const GivenColours& given) {
  MeshColours colours;
  Palette units(Palette::Of::units, given), surfaces(Palette::Of::surfaces, given);
  for (const Region& r : mesh.regions) colours.regions.push_back(units.colour_of(r.name));
  for (const NamedSurface& s : mesh.surfaces)
    colours.surfaces.push_back(s.kind == SurfaceKind::box ? colour_of_box_sides : surfaces.colour_of(s.name));
  constexpr Colour of_wells{0.10, 0.10, 0.12}, of_curves{0.35, 0.36, 0.40};
  for (const NamedCurve& c : mesh.curves) colours.curves.push_back(c.kind == "well" ? of_wells : of_curves);
  return colours;
}

}  // namespace geomesh::geomodel::page

// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/mesh/balancing_shift.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace geomesh::geomodel {
namespace {

/// Largest shift of the field at a vertex, as a share of the difference between its value there and the nearest
/// isovalue. With any share below 1 the vertex remains on its side of the isosurface.
constexpr double most_of_difference = 0.5;

/// Barycentric coordinates of the three quadrature points of a triangle, whose mean is exact for quadratic functions.
constexpr double most = 2.0 / 3, least = 1.0 / 6;
constexpr std::array<std::array<double, 3>, 3> samples{
    {{most, least, least}, {least, most, least}, {least, least, most}}};

double nearest_difference(const std::vector<double>& values, double at) {
  const auto above = std::lower_bound(values.begin(), values.end(), at);
  double nearest = std::numeric_limits<double>::infinity();
  if (above != values.end()) nearest = *above - at;
  if (above != values.begin()) nearest = std::min(nearest, at - *(above - 1));
  return nearest;
}

/// Sums over the isosurface triangles in the cells around a vertex: of areas, and of area times (isovalue - mean field
/// value).
struct Mean {
  double sum = 0, area = 0;
};

void add_surface(const BackgroundMesh& mesh, const ScalarField& field, const Isosurface& surface, double value,
                 std::vector<Mean>& at) {
  std::vector<Vec3> places;
  for (const Triangle& t : surface.triangles)
    for (const auto& s : samples)
      places.push_back(s[0] * surface.points[t[0]] + s[1] * surface.points[t[1]] + s[2] * surface.points[t[2]]);
  std::vector<double> found(places.size());
  field.values(places, found);
  for (std::size_t k = 0; k < surface.triangles.size(); ++k) {
    const Triangle& t = surface.triangles[k];
    const Vec3& a = surface.points[t[0]];
    const double area = length_of(cross(surface.points[t[1]] - a, surface.points[t[2]] - a));
    const double mean = (found[3 * k] + found[3 * k + 1] + found[3 * k + 2]) / 3;
    for (const VertexIndex v : mesh.cells()[surface.cell[k]].v) {
      at[v].sum += area * (value - mean);
      at[v].area += area;
    }
  }
}

}  // namespace

std::vector<double> balancing_shift(const BackgroundMesh& mesh, const ScalarField& field,
                                    const std::vector<Isosurface>& surfaces, const std::vector<double>& values) {
  std::vector<Mean> at(mesh.n_points());
  for (std::size_t v = 0; v < values.size(); ++v) add_surface(mesh, field, surfaces[v], values[v], at);
  std::vector<double> shift(mesh.n_points(), 0);
  for (VertexIndex v = 0; v < mesh.n_points(); ++v) {
    if (!(at[v].area > 0)) continue;
    const double limit = most_of_difference * nearest_difference(values, mesh.value(v));
    shift[v] = std::clamp(at[v].sum / at[v].area, -limit, limit);
  }
  return shift;
}

}  // namespace geomesh::geomodel

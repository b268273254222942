// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/column.hpp"

#include <algorithm>
#include <cmath>

#include "geomesh/core/error.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {

namespace {

/// If the cosine of the angle between a mesh face and its input triangle is smaller, the face does not show which
/// component is above the horizon.
constexpr double least_cosine = 0.1;

std::vector<Vec3> unit_normals(const TriangulatedSurface& surface) {
  std::vector<Vec3> normals;
  normals.reserve(surface.triangles.size());
  for (const Triangle& t : surface.triangles) {
    const Vec3 n = cross(surface.points[t[1]] - surface.points[t[0]], surface.points[t[2]] - surface.points[t[0]]);
    const double length = norm(n);
    normals.push_back(length > 0 ? (1 / length) * n : Vec3{});
  }
  return normals;
}

}  // namespace

Column make_column(const std::vector<std::string>& names, const std::vector<TriangulatedSurface>& surfaces,
                   std::vector<std::string>& warnings) {
  Column column;
  if (names.empty()) return column;
  if (names.size() % 2 == 0)
    throw Error(ErrorKind::usage,
                "column: " + std::to_string(names.size()) +
                    " entries; expected unit, horizon, unit, ..., unit, youngest first (an odd number)");
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i % 2 == 0) {
      column.units.push_back(names[i]);
      continue;
    }
    const auto at = std::find_if(surfaces.begin(), surfaces.end(), [&](const auto& s) { return s.name == names[i]; });
    if (at == surfaces.end())
      throw Error(ErrorKind::usage, "column: entry " + std::to_string(i + 1) + " (" + names[i] +
                                        ") must be a horizon and no surface has this name");
    column.horizons.push_back(static_cast<Index>(at - surfaces.begin()));
    column.sides.push_back(orient_upward(*at));
    column.normals.push_back(unit_normals(*at));
    if (column.sides.back().n_unorientable_sheets > 0)
      warnings.push_back(
          "horizon " + names[i] + ": " + std::to_string(column.sides.back().n_unorientable_sheets) +
          " of its sheets cannot be oriented; the upper side of each triangle there is the one that faces up");
  }
  return column;
}

std::vector<HorizonContacts> horizon_contacts(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup,
                                              const ModelPlc& plc, const Column& column) {
  std::vector<HorizonContacts> contacts(mesh.n_components);
  std::map<Index, Index> row_of_surface;
  for (Index h = 0; h < column.horizons.size(); ++h) row_of_surface[column.horizons[h]] = h;
  for (const auto& face : mesh.faces) {
    const Vec3& corner = mesh.points[face.vertices[0]];
    const Vec3 normal = cross(mesh.points[face.vertices[1]] - corner, mesh.points[face.vertices[2]] - corner);
    const double area = norm(normal) / 2;
    for (const PolygonSoup::Origin& o : origins_of(soup, plc, face.facet)) {
      const auto row = row_of_surface.find(o.surface);
      if (row == row_of_surface.end()) continue;
      const Index h = row->second;
      const Vec3& given = column.normals[h][o.triangle];
      const double agreement = dot(normal, given);
      if (std::abs(agreement) < least_cosine * norm(normal) * norm(given)) continue;
      if ((agreement < 0) != o.reversed) continue;  // rounding inverted the face
      const bool facet_normal_is_up = (column.sides[h].as_stored[o.triangle] != 0) != o.reversed;
      Index lower = component_of(mesh, face.tetrahedron_below), upper = component_of(mesh, face.tetrahedron_above);
      if (!facet_normal_is_up) std::swap(lower, upper);
      if (lower == upper) {
        if (lower != no_index) contacts[lower].on_both_sides[h] += area;
        continue;
      }
      if (lower != no_index) contacts[lower].lies_below[h] += area;
      if (upper != no_index) contacts[upper].lies_above[h] += area;
    }
  }
  return contacts;
}

namespace {

double area_in(const std::map<Index, double>& areas, Index h) {
  const auto at = areas.find(h);
  return at == areas.end() ? 0.0 : at->second;
}

/// Returns whether a horizon bounds a component that touches one side of it with `area`. It does not if one of the
/// horizons first .. last has the component on both sides over a larger area: then the component continues there.
bool bounds(const HorizonContacts& contacts, double area, Index first, Index last) {
  for (const auto& [h, both] : contacts.on_both_sides)
    if (h >= first && h <= last && both > area) return false;
  return true;
}

}  // namespace

UnitVerdict find_unit(const HorizonContacts& contacts, const Column& column) {
  UnitVerdict verdict;
  if (!column.given()) return verdict;
  const Index last_unit = static_cast<Index>(column.units.size() - 1);
  Index first = 0, last = last_unit;
  bool bounded_above = false, bounded_below = false;
  for (const auto& [h, area] : contacts.lies_below) {
    // A fold or thrust may put a horizon on both sides of the component. The side with the larger area is used.
    if (area < area_in(contacts.lies_above, h)) continue;
    if (!bounds(contacts, area, 0, h)) continue;
    first = std::max(first, h + 1);
    bounded_above = true;
  }
  for (const auto& [h, area] : contacts.lies_above) {
    if (area <= area_in(contacts.lies_below, h) || !bounds(contacts, area, h, last_unit)) continue;
    last = std::min(last, h);
    bounded_below = true;
  }
  verdict.first_possible = first;
  verdict.last_possible = last;
  if (first > last) {
    verdict.kind = UnitVerdict::Kind::pocket;
    verdict.first = verdict.last = last;
    return verdict;
  }
  if (first == last) {
    verdict.kind = UnitVerdict::Kind::unit;
    verdict.first = verdict.last = first;
    return verdict;
  }
  for (const auto& [h, area] : contacts.on_both_sides) {
    if (h < first || h >= last) continue;
    if (verdict.kind != UnitVerdict::Kind::joined) verdict.first = h;
    verdict.last = h + 1;
    verdict.kind = UnitVerdict::Kind::joined;
  }
  if (verdict.kind == UnitVerdict::Kind::joined || (!bounded_above && !bounded_below)) return verdict;
  verdict.kind = UnitVerdict::Kind::incomplete;
  verdict.first = verdict.last = bounded_above ? first : last;
  return verdict;
}

std::string unit_name(const UnitVerdict& verdict, const Column& column) {
  if (verdict.first == no_index) return "";
  std::string name = column.units[verdict.first];
  for (Index u = verdict.first + 1; u <= verdict.last; ++u) name += "+" + column.units[u];
  return name;
}

}  // namespace geomesh::geomodel

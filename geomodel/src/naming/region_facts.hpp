// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Collects what naming needs to know about the components of a tetrahedralization.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// One component: a maximal set of tetrahedra connected through unconstrained faces.
struct ComponentFacts {
  std::size_t n_tetrahedra = 0;
  double volume = 0;
  Vec3 centroid;
  Vec3 inside_point;          ///< centroid of the largest tetrahedron
  Vec3 min_point, max_point;  ///< lexicographically least and greatest of its points, by x, then y, then z
  /// Least (surface, triangle, side) of its faces; side is 0 if the component lies below the triangle as stored.
  std::array<Index, 3> first_triangle{no_index, no_index, no_index};
  bool enclosed = true;  ///< false if it is closed only by the surface that represents the convex hull
};

/// Returns the origins of facet f of the PLC (those of its first soup facet; all its soup facets have the same
/// surfaces).
inline std::span<const PolygonSoup::Origin> origins_of(const PolygonSoup& soup, const ModelPlc& plc, Index f) {
  const Index s = plc.facet_soup[plc.facet_soup_offsets[f]];
  return {soup.origins.data() + soup.origin_offsets[s], soup.origins.data() + soup.origin_offsets[s + 1]};
}

/// Returns the component of a tetrahedron, or no_index outside.
inline Index component_of(const ConstrainedTetrahedralization& mesh, Index tetrahedron) {
  return tetrahedron == no_index ? no_index : mesh.component[tetrahedron];
}

/// `hull_surface` is the surface that represents the convex hull, or no_index.
std::vector<ComponentFacts> component_facts(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup,
                                            const ModelPlc& plc, Index hull_surface);

/// Formats a place as "(x, y, z)", with six digits after the leading digit of the largest coordinate.
std::string to_text(const Vec3& place);
/// Formats a number with four significant digits.
std::string to_text(double measure);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Measures the components of a tetrahedralization and collects the other facts needed to name them.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// Facts about one component: a maximal set of tetrahedra connected through unconstrained faces.
struct ComponentFacts {
  std::size_t n_tetrahedra = 0;
  double volume = 0;
  Vec3 centroid;
  Vec3 inside_point;          ///< centroid of the largest tetrahedron of the component
  Vec3 min_point, max_point;  ///< Least and greatest point of the component, ordered by x, then y, then z.
  /// The lexicographically first (surface, triangle, side) of the component's faces; side is 0 if the component is
  /// below the triangle.
  std::array<Index, 3> first_triangle{no_index, no_index, no_index};
  bool enclosed = true;  ///< whether surfaces other than that of the convex hull enclose the component
};

/// Returns the origins of facet f of the PLC, from the first of its soup facets, which all have the same surfaces.
inline std::span<const PolygonSoup::Origin> origins_of(const PolygonSoup& soup, const ModelPlc& plc, Index f) {
  const Index s = plc.facet_soup[plc.facet_soup_offsets[f]];
  return {soup.origins.data() + soup.origin_offsets[s], soup.origins.data() + soup.origin_offsets[s + 1]};
}

/// Returns the component to which a tetrahedron belongs; no_index if `tetrahedron` is no_index, that is, the outside.
inline Index component_of(const ConstrainedTetrahedralization& mesh, Index tetrahedron) {
  return tetrahedron == no_index ? no_index : mesh.component[tetrahedron];
}

/// Collects the facts about all components. `hull_surface` is the surface that represents the convex hull, or no_index.
std::vector<ComponentFacts> component_facts(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup,
                                            const ModelPlc& plc, Index hull_surface);

/// Formats a point as "(x, y, z)", with six digits after the leading digit of the largest coordinate.
std::string to_text(const Vec3& place);
std::string to_text(double measure);

}  // namespace geomesh::geomodel

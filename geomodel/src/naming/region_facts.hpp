// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What naming needs to know of the components of a tetrahedralization.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// One component: a maximal set of tetrahedra joined through unconstrained faces.
struct ComponentFacts {
  std::size_t n_tetrahedra = 0;
  double volume = 0;
  Vec3 centroid;
  Vec3 inside_point;          ///< centroid of the largest tetrahedron
  Vec3 min_point, max_point;  ///< least and greatest of its points in x, then y, then z
  /// Least (surface, triangle, side) of its faces, side 0 where the component lies below the triangle as stored.
  std::array<Index, 3> first_triangle{no_index, no_index, no_index};
  bool enclosed = true;  ///< false: only the surface that stands for the convex hull closes it
};

/// The origins of facet f of the PLC (those of the first soup facet it stands for; all have the same surfaces).
inline std::span<const PolygonSoup::Origin> origins_of(const PolygonSoup& soup, const ModelPlc& plc, Index f) {
  const Index s = plc.facet_soup[plc.facet_soup_offsets[f]];
  return {soup.origins.data() + soup.origin_offsets[s], soup.origins.data() + soup.origin_offsets[s + 1]};
}

/// Component of a tetrahedron, no_index outside.
inline Index component_of(const ConstrainedTetrahedralization& mesh, Index tetrahedron) {
  return tetrahedron == no_index ? no_index : mesh.component[tetrahedron];
}

/// `hull_surface`: the surface that stands for the convex hull, or no_index.
std::vector<ComponentFacts> component_facts(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup,
                                            const ModelPlc& plc, Index hull_surface);

/// "(x, y, z)" as short as six digits after the leading one of the largest coordinate allow.
std::string to_text(const Vec3& place);
/// A number with four significant digits.
std::string to_text(double measure);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Converts surfaces, wells and points as read to the complex of the first round.
#pragma once

#include <string>
#include <vector>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// All surfaces of one arrangement: the given ones, followed by the six sides of the box if there is one.
struct SurfaceList {
  const std::vector<TriangulatedSurface>& given;
  const std::vector<TriangulatedSurface>& box_sides;
  std::size_t size() const { return given.size() + box_sides.size(); }
  std::vector<TriangulatedSurface> all() const;  ///< returns copies with names and kinds only
  const TriangulatedSurface& operator[](std::size_t i) const {
    return i < given.size() ? given[i] : box_sides[i - given.size()];
  }
};

struct Ingested {
  Complex complex;
  std::vector<std::vector<VertexIndex>> vertex_of_point;  ///< for each surface and point: vertex of the complex
  std::vector<double> area_outside;  ///< for each given surface: area of triangles entirely outside the box
  std::vector<std::string> warnings;
};

/// Merges points of equal coordinates, drops triangles without area (with a warning) and those entirely beyond a side
/// of the box. Throws Error{invalid_input} for coordinates that are not finite or out of the range of the exact
/// arithmetic, and for indices out of range.
Ingested ingest(const SurfaceList& surfaces, const std::vector<Polyline>& polylines,
                const std::vector<NamedPoint>& points, const std::optional<Box3>& box);

/// Returns the six sides with two triangles each and outward normals, in the order xmin xmax ymin ymax zmin zmax.
std::vector<TriangulatedSurface> make_box_sides(const Box3& box);

/// Formats a point as "(x, y, z)" to the millimetre, for messages.
std::string to_text(const Vec3& p);

}  // namespace geomesh::geomodel::arrangement

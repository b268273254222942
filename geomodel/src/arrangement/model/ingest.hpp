// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Converts surfaces, wells and points as they were read to the complex of the first round.
#pragma once

#include <string>
#include <vector>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// All surfaces of one arrangement: those of the input, followed by the six sides of the box if there is one.
struct SurfaceList {
  const std::vector<TriangulatedSurface>& given;
  const std::vector<TriangulatedSurface>& box_sides;
  std::size_t size() const { return given.size() + box_sides.size(); }
  std::vector<TriangulatedSurface> all() const;  ///< returns copies of the surfaces that hold names and kinds only
  const TriangulatedSurface& operator[](std::size_t i) const {
    return i < given.size() ? given[i] : box_sides[i - given.size()];
  }
};

struct Ingested {
  Complex complex;
  /// For each surface and each of its points: vertex of the complex.
  std::vector<std::vector<VertexIndex>> vertex_of_point;
  /// For each input surface: area of its triangles that are entirely outside the box.
  std::vector<double> area_outside;
  std::vector<std::string> warnings;
};

/// Builds the complex from the input. Merges points of equal coordinates, drops triangles without area (with a warning)
/// and triangles entirely beyond a side of the box. Throws Error{invalid_input} for coordinates that are not finite or
/// out of the range of the exact arithmetic, and for indices out of range.
Ingested ingest(const SurfaceList& surfaces, const std::vector<Polyline>& polylines,
                const std::vector<NamedPoint>& points, const std::optional<Box3>& box);

/// Returns the box's sides, two triangles each with outward normals, in the order xmin xmax ymin ymax zmin zmax.
std::vector<TriangulatedSurface> make_box_sides(const Box3& box);

/// Formats a point as "(x, y, z)" to the millimetre, for messages.
std::string to_text(const Vec3& p);

}  // namespace geomesh::geomodel::arrangement

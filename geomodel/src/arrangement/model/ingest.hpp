// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Converts surfaces, wells and points as read to the complex of the first round.
#pragma once

#include <string>
#include <vector>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// All surfaces of one arrangement: those given, then the six sides of the box where there is one.
struct SurfaceList {
  const std::vector<TriangulatedSurface>& given;
  const std::vector<TriangulatedSurface>& box_sides;
  std::size_t size() const { return given.size() + box_sides.size(); }
  std::vector<TriangulatedSurface> all() const;  ///< names and kinds alone
  const TriangulatedSurface& operator[](std::size_t i) const {
    return i < given.size() ? given[i] : box_sides[i - given.size()];
  }
};

struct Ingested {
  Complex complex;
  std::vector<std::vector<VertexIndex>> vertex_of_point;  ///< per surface and point: vertex of the complex
  std::vector<double> area_outside;                       ///< per given surface: of triangles wholly outside the box
  std::vector<std::string> warnings;
};

/// Merges points of equal coordinates, drops triangles without area (with a warning) and those wholly beyond a side of
/// the box. Throws Error{invalid_input} for coordinates that are not finite or out of the exact arithmetic's range, and
/// for indices out of range.
Ingested ingest(const SurfaceList& surfaces, const std::vector<Polyline>& polylines,
                const std::vector<NamedPoint>& points, const std::optional<Box3>& box);

/// The six sides, two triangles each, normals outward, in the order xmin xmax ymin ymax zmin zmax.
std::vector<TriangulatedSurface> make_box_sides(const Box3& box);

/// "(x, y, z)" with millimetres, for messages.
std::string to_text(const Vec3& p);

}  // namespace geomesh::geomodel::arrangement

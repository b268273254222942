// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Images of a piecewise linear complex for metamorphic tests.
#pragma once

#include <cstdint>
#include <functional>

#include "geomesh/core/plc.hpp"

namespace geomesh::test {

using PointMap = std::function<Vec3(const Vec3&)>;

/// The same complex with every coordinate mapped (seeds too); `orientation` -1 where the map mirrors: loops are then
/// reversed so that normals keep their side. Exact maps keep polygons planar; for others use `as_triangles` first.
PiecewiseLinearComplex mapped(PiecewiseLinearComplex plc, const PointMap& map, int orientation = 1);

/// Polygons replaced by their triangles (through inner segments and points), so that any rounding of coordinates keeps
/// facets flat.
PiecewiseLinearComplex as_triangles(const PiecewiseLinearComplex& plc);

/// Vertices renumbered and facets reordered by a seeded shuffle; loops begin elsewhere.
PiecewiseLinearComplex shuffled(const PiecewiseLinearComplex& plc, std::uint64_t seed);

PointMap axes_permuted();        ///< (x,y,z) -> (y,z,x), exact, keeps orientation
PointMap mirrored();             ///< x -> -x, exact
PointMap scaled(int power);      ///< by 2^power, exact
PointMap moved(const Vec3& by);  ///< exact where the sums are
PointMap flattened(double by);   ///< z -> by * z, rounded
PointMap turned();               ///< by odd angles about all axes, rounded
PointMap moved_to_utm();         ///< easting 5e5, northing 6e6, elevation kept, rounded

}  // namespace geomesh::test

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Analytic surfaces for the templates of `geomesh init`, as GOCAD TSurf text.
#pragma once

#include <functional>
#include <string>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// A grid of n x n cells over the map rectangle [x0, x1] x [y0, y1].
struct MapGrid {
  double x0, x1, y0, y1;
  int n;
};

TriangulatedSurface height_surface(const std::string& name, const MapGrid& grid,
                                   const std::function<double(double, double)>& height);

/// Returns a plane surface of points origin + s*u + t*v, with s and t in [0, 1] and n x n cells.
TriangulatedSurface sheet_surface(const std::string& name, const Vec3& origin, const Vec3& u, const Vec3& v, int n);

/// The vertical axis of a surface of revolution from bottom to top, with the numbers of rings and sectors.
struct Axis {
  double x, y, bottom, top;
  int rings, sectors;
};

/// Returns a closed body of revolution. Its radius is radius(t) at z = bottom + t (top - bottom), zero at t = 0 and 1.
TriangulatedSurface revolved_surface(const std::string& name, const Axis& axis,
                                     const std::function<double(double)>& radius);

std::string to_gocad(const Polyline& line);

/// Returns a surface as GOCAD TSurf text, with doubles that read back to the same values.
std::string to_gocad(const TriangulatedSurface& surface);

}  // namespace geomesh::geomodel

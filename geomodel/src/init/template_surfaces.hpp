// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Analytic surfaces for the templates of `geomesh init`, as GOCAD TSurf text.
#pragma once

#include <functional>
#include <string>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// z = height(x, y) on a grid of n x n cells over [x0, x1] x [y0, y1].
TriangulatedSurface height_surface(const std::string& name, double x0, double x1, double y0, double y1, int n,
                                   const std::function<double(double, double)>& height);

/// A plane sheet origin + s*u + t*v, s and t in [0, 1], of n x n cells.
TriangulatedSurface sheet_surface(const std::string& name, const Vec3& origin, const Vec3& u, const Vec3& v, int n);

/// A closed body of revolution about the vertical through (x, y). Its radius is radius(t) at z = bottom + t (top -
/// bottom), zero at t = 0 and 1.
TriangulatedSurface revolved_surface(const std::string& name, double x, double y, double bottom, double top, int rings,
                                     int sectors, const std::function<double(double)>& radius);

/// GOCAD PLine text of a line through points.
std::string to_gocad(const Polyline& line);

/// GOCAD TSurf text of a surface, doubles written so that they read back the same.
std::string to_gocad(const TriangulatedSurface& surface);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Interpolates surfaces from scattered points, remeshes surfaces with other edge lengths, and smooths them
/// (docs/input-formats.md).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// The plane over which a surface is a graph: the map for horizons, the mean plane for faults and bodies.
enum class GraphOver { map, mean_plane };

struct GriddingSpec {
  enum class Method {
    thin_plate,   ///< interpolation by a smooth surface on a regular grid, close to the points
    triangulate,  ///< Delaunay triangulation of the points, which passes through all of them
  };
  Method method = Method::thin_plate;
  /// Spacing of the interpolation grid; 0: about the mean distance between points, with at most 40,000 nodes.
  double spacing = 0;
  double smoothing = 0;     ///< length below which features are smoothed away; 0: a tenth of the spacing
  double max_distance = 0;  ///< grid nodes farther than this from every point are left out; 0: no node is left out
  bool to_box =
      /// Whether the grid covers the whole model box and not just the bounding rectangle of the points. Possible only
      /// for surfaces that are graphs over the map.
      false;
};

struct GriddedSurface {
  TriangulatedSurface surface;
  std::size_t n_points = 0, n_nodes = 0;
  double spacing = 0, smoothing = 0;
  double largest_residual = 0,
         /// Root mean square vertical distance of the surface from the points that lie above or below it.
      rms_residual = 0;
  Vec3 largest_place;         ///< the point with the largest difference in height from the surface
  std::size_t n_outside = 0;  ///< number of points that are not above or below the surface
};

/// Interpolates a surface from points (duplicates are allowed), over the whole `box` if spec.to_box is set. Throws
/// Error{invalid_input} if there are fewer than three points or all lie on one line; throws Error{usage} if the
/// requested spacing needs more than 1,000,000 nodes.
///
/// thin_plate: heights at the nodes of a grid minimise (A / n) sum (h(x_i) - z_i)^2 + s^4 * integral (h_uu^2 + 2 h_uv^2
/// + h_vv^2). h is linear on the triangles between nodes, derivatives are differences, A is the rectangle, s the
/// smoothing length; planes are reproduced (after Inoue, "A least-squares smooth fitting for irregularly spaced data",
/// Geophysics 51, 1986). One sparse Cholesky factorisation: about n_nodes^1.5; the number of points hardly matters.
GriddedSurface grid_points(const std::vector<Vec3>& points, const GriddingSpec& spec, GraphOver over, const Box3* box);

/// The points from which a horizon was interpolated over the map, and the settings of the interpolation.
struct GriddedPoints {
  std::vector<Vec3> points;
  GriddingSpec spec;
  double spacing = 0;  ///< of the grid
};
/// Points of interpolated horizons, by row of the surface.
using PointsOfHorizons = std::map<Index, GriddedPoints>;

/// How far remeshing or smoothing moved a surface.
struct SurfaceChange {
  double largest_move = 0, rms_move = 0;
  std::size_t n_triangles = 0;  ///< of the result
};

/// Remeshes a surface, a graph over the map or its mean plane, with edges of about `length`. Borders are subdivided and
/// keep their corners; points of a triangular lattice on the old surface fill the inside. Throws Error{usage} if the
/// surface is no such graph or is closed, or if more than 10,000,000 triangles would be made. Returns the heights of
/// the old vertices above the new surface.
SurfaceChange resample_surface(TriangulatedSurface& surface, double length, GraphOver over);

/// Smooths a surface in several passes. Each pass moves every inner vertex half-way to the plane fitted to it and its
/// neighbours: along z if the surface is a graph over the map, else along the normal of that plane. Vertices of borders
/// do not move. Planes do not change, up to rounding.
SurfaceChange smooth_surface(TriangulatedSurface& surface, int passes, GraphOver over);

}  // namespace geomesh::geomodel

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
    thin_plate,   ///< a smooth surface close to the points, on a regular grid
    triangulate,  ///< the Delaunay triangulation of the points, which passes through all of them
  };
  Method method = Method::thin_plate;
  double spacing = 0;    ///< spacing of the grid; 0: about the mean distance between points, with at most 40,000 nodes
  double smoothing = 0;  ///< length below which features are smoothed away; 0: a tenth of the spacing
  double max_distance = 0;  ///< nodes farther than this from every point are left out; 0: no node is left out
  bool to_box =
      /// Whether the grid covers the whole box (only for surfaces over the map) and not just the rectangle of the
      /// points.
      false;
};

struct GriddedSurface {
  TriangulatedSurface surface;
  std::size_t n_points = 0, n_nodes = 0;
  double spacing = 0, smoothing = 0;
  double largest_residual = 0,
         /// Root mean square of the surface's height minus the point's height, over all points that have the surface
         /// above or below them.
      rms_residual = 0;
  Vec3 largest_place;         ///< the point with the largest residual
  std::size_t n_outside = 0;  ///< number of points that are not above or below the surface
};

/// Interpolates a surface from points (duplicates are allowed). `box` is used if spec.to_box is set. Throws
/// Error{invalid_input} where there
/// are fewer than three points or all lie on one line; Error{usage} if the requested spacing needs more than
/// 1,000,000 nodes.
///
/// thin_plate: heights at the nodes of a grid minimise  (A / n) sum (h(x_i) - z_i)^2 + s^4 * integral (h_uu^2 + 2
/// h_uv^2 + h_vv^2). h is linear on the triangles between nodes, derivatives are differences, A is the rectangle, s the
/// smoothing length; planes are reproduced (after Inoue, "A least-squares smooth fitting for irregularly spaced data",
/// Geophysics 51, 1986). One sparse Cholesky factorisation: about n_nodes^1.5; the number of points hardly matters.
GriddedSurface grid_points(const std::vector<Vec3>& points, const GriddingSpec& spec, GraphOver over, const Box3* box);

/// The points from which a horizon was made over the map, and how.
struct GriddedPoints {
  std::vector<Vec3> points;
  GriddingSpec spec;
  double spacing = 0;  ///< of the grid
};
/// By row of the surface.
using PointsOfHorizons = std::map<Index, GriddedPoints>;

/// How far remeshing or smoothing moved a surface.
struct SurfaceChange {
  double largest_move = 0, rms_move = 0;
  std::size_t n_triangles = 0;  ///< of the result
};

/// The surface, a graph over the map or its mean plane, remeshed with edges of about `length`: its borders are
/// subdivided (corners are kept), points of a triangular lattice fill the inside, all on the old surface. Throws
/// Error{usage} if the surface is no such graph or is closed, or if more than 10,000,000 triangles would be made. The
/// change is the height of old vertices over the new surface.
SurfaceChange resample_surface(TriangulatedSurface& surface, double length, GraphOver over);

/// Each pass moves every vertex inside half-way to the plane fitted to it and its neighbours: along z over the map (x
/// and y do not change), else along its normal. Vertices of borders do not move. Planes do not change, up to
/// rounding.
SurfaceChange smooth_surface(TriangulatedSurface& surface, int passes, GraphOver over);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Surfaces from scattered points, surfaces remade with other edge lengths, and smoothing (docs/input-formats.md).
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Where a surface lies as a graph: horizons over the map, faults and bodies over their mean plane.
enum class GraphOver { map, mean_plane };

struct GriddingSpec {
  enum class Method {
    thin_plate,   ///< a smooth surface near the points, on a regular grid
    triangulate,  ///< the Delaunay triangulation of the points, which it passes through
  };
  Method method = Method::thin_plate;
  double spacing = 0;       ///< of the grid; 0: about the mean distance of the points, at most 40,000 nodes
  double smoothing = 0;     ///< length below which features are smoothed away; 0: a tenth of the spacing
  double max_distance = 0;  ///< nodes further than this from every point are left out; 0: none is
  bool to_box =
      false;  ///< the grid reaches over the whole box (surfaces over the map alone), else over the points' rectangle
};

struct GriddedSurface {
  TriangulatedSurface surface;
  std::size_t n_points = 0, n_nodes = 0;
  double spacing = 0, smoothing = 0;
  double largest_residual = 0,
         rms_residual = 0;    ///< height of the surface over the plane minus the point's, where there is surface
  Vec3 largest_place;         ///< the point of the largest residual
  std::size_t n_outside = 0;  ///< points that are not over the surface
};

/// A surface from points (duplicates allowed). `box` is used where spec.to_box. Throws Error{invalid_input} where there
/// are fewer than three points or all lie on one line; Error{usage} where the spacing asked for needs more than
/// 1,000,000 nodes.
///
/// thin_plate: heights at the nodes of a grid minimise  (A / n) sum (h(x_i) - z_i)^2 + s^4 * integral (h_uu^2 + 2
/// h_uv^2 + h_vv^2). h is linear on the triangles between nodes, derivatives are differences, A is the rectangle, s the
/// smoothing length; planes are reproduced (after Inoue, "A least-squares smooth fitting for irregularly spaced data",
/// Geophysics 51, 1986). One sparse Cholesky factorisation: about n_nodes^1.5; the number of points hardly matters.
GriddedSurface grid_points(const std::vector<Vec3>& points, const GriddingSpec& spec, GraphOver over, const Box3* box);

/// What remaking or smoothing changed.
struct SurfaceChange {
  double largest_move = 0, rms_move = 0;
  std::size_t n_triangles = 0;  ///< of the result
};

/// The surface, a graph over the map or its mean plane, remade with edges of about `length`: its borders are divided
/// anew (corners stay), points of a triangular lattice fill the inside, all on the old surface. Throws Error{usage}
/// where the surface is no such graph or is closed, and where more than 10,000,000 triangles would be made. The change
/// is the height of old vertices over the new surface.
SurfaceChange resample_surface(TriangulatedSurface& surface, double length, GraphOver over);

/// Each pass moves every vertex inside half-way to the plane fitted to it and its neighbours: along z over the map (x
/// and y stay), else along its normal. Vertices of borders stay. Planes do not move.
SurfaceChange smooth_surface(TriangulatedSurface& surface, int passes, GraphOver over);

}  // namespace geomesh::geomodel

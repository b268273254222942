// SPDX-License-Identifier: MIT
/// @file
/// The constants of refinement: lengths relative to the target size. `quality_bench --section peers` shows the points,
/// bad cells and time that they lead to, compared with tetgen and gmsh.
#pragma once

#include <cstddef>

namespace geomesh::remesh {

/// Ratios of lengths to the target size unless said otherwise. Together they keep refinement finite: edges that are
/// split are longer than edges that are collapsed, and no point is put nearer to others than `spacing`.
struct RefineRatios {
  double split_edge = 1.4;     ///< a longer edge is split at its middle; the halves are then longer than 1 / split_edge
  double collapse_edge = 0.6;  ///< a shorter edge is collapsed; it is below split_edge / 2, so that halves are kept
  double thin_out_edge = 0.5;  ///< the same for points that improvement turned out not to need
  /// On surfaces, such an edge is collapsed below this ratio. Edges longer than a third are promised, and the edges
  /// around need a margin.
  double thin_out_surface_edge = 0.4;
  double promised_edge = 0.34;       ///< an edge is too short below this, which has a margin over the promised third
  double stretched_edge = 0.355;     ///< an edge that cannot be collapsed is stretched to this length
  double spacing = 0.68;             ///< least distance of a new point to all others; improvement may halve it
  double surface_spacing_off = 0.3;  ///< factor of the spacing between a surface point and vertices off the surface
  double large_cell = 0.75;          ///< a cell with a larger circumradius gets a point; the regular one has 0.61
  double large_face = 0.72;          ///< a face with a larger circumradius gets a point; the equilateral one has 0.58
  double long_edge = 1.2;            ///< a face with a longer edge needs further points; below split_edge
  double hair = 1e-6;  ///< width of a strip of a kept surface below which points between its borders are useless
  /// Least squared height of a new point above its face, relative to the squared target edge.
  double least_height = 0.2;
  double least_way = 0.5;        ///< a new point moves towards the circumcentre by at least this share of the height
  double surface_shape = 1e-7;   ///< least shape of a cell created by a new point on a surface, where more follow
  double collapse_floor = 0.05;  ///< a contraction must not bring better shapes below this
  double regular_floor = 1e-3;   ///< the same for flips and moves on surfaces
  unsigned regular_rounds = 4;   ///< rounds of flips and moves on surfaces; the fourth changes one face in a hundred
  /// A vertex is moved only if the worst face around it improves by this factor. At 1.01, with good faces left alone,
  /// refinement takes a tenth less time, but six times as many cells end below 24.85 degrees.
  double regular_rise = 1.001;
  /// Share of all cells. If insertion slows down while this many large cells are left, the mesh is far from Delaunay
  /// there.
  double many_stuck = 0.15;
  std::size_t slow_front = 20;   ///< insertion counts as slow with more large cells than this for each point of a round
  std::size_t idle_front = 100;  ///< from this number on, circumcentres are tried instead
};
inline constexpr RefineRatios refine_ratios{};

}  // namespace geomesh::remesh

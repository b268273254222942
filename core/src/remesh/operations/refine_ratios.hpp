// SPDX-License-Identifier: MIT
/// @file
/// The constants of refinement: lengths relative to the target size. `quality_bench --section peers` shows the
/// resulting numbers of points and bad cells and the time, compared with tetgen and gmsh.
#pragma once

#include <cstddef>

namespace geomesh::remesh {

/// Ratios of lengths to the target size unless said otherwise. Together these ratios keep refinement finite: edges that
/// are split are longer than edges that are collapsed, and no point is put nearer to others than `spacing`.
struct RefineRatios {
  double split_edge = 1.4;  ///< a longer edge is split at its middle; its halves are longer than split_edge / 2
  /// An edge shorter than this is collapsed. Below split_edge / 2, so that the halves of split edges are kept.
  double collapse_edge = 0.6;
  double thin_out_edge = 0.5;  ///< an edge shorter than this is collapsed if improvement does not need its points
  /// A shorter edge on a surface is collapsed if improvement does not need its points. It leaves a margin
  /// above a third of the target size, because the result shall have no edges below that.
  double thin_out_surface_edge = 0.4;
  double promised_edge = 0.34;    ///< edges shorter than this are too short; none may remain below a third of the size
  double stretched_edge = 0.355;  ///< an edge that cannot be collapsed is stretched to this length
  double spacing = 0.68;          ///< least distance of a new point to all others; improvement may halve it
  /// Required distance of surface points from vertices off the surface, as a factor of `spacing`.
  double surface_spacing_off = 0.3;
  double large_cell =
      0.75;  ///< a cell with a larger circumradius gets a point; a regular cell with edges of 1 has 0.61
  double large_face =
      0.72;  ///< a face with a larger circumradius gets a point; an equilateral one with edges of 1 has 0.58
  double long_edge = 1.2;  ///< a face with a longer edge needs further points; must be below split_edge
  /// Width of a strip of triangles on a kept surface below which points between the borders of the strip are useless.
  double hair = 1e-6;
  /// Least squared height of a new point above its face, relative to the squared target edge.
  double least_height = 0.2;
  /// A new point has at least this share of its ideal height, even if the circumcentre is lower.
  double least_way = 0.5;
  double surface_shape = 1e-7;  ///< least shape of a cell made by a point on a surface, around which more points follow
  double collapse_floor = 0.05;  ///< a contraction must not lower the worst shape from above to below this limit
  double regular_floor = 1e-3;   ///< flips and moves on surfaces must not lower shapes from above to below this limit
  unsigned regular_rounds = 4;   ///< rounds of flips and moves on surfaces; the fourth changes one face in a hundred
  /// A vertex is moved only if the worst face around it improves by this factor. At 1.01, with good faces left alone,
  /// refinement takes a tenth less time, but six times as many cells end below 24.85 degrees.
  double regular_rise = 1.001;
  /// If insertion slows down while more than this share of all cells are too large, the mesh is far from Delaunay.
  double many_stuck = 0.15;
  /// Insertion counts as slow if a round leaves more than this many large cells for each new point.
  std::size_t slow_front = 20;
  std::size_t idle_front = 100;  ///< from so many large cells per inserted point on, circumcentres are tried
};
inline constexpr RefineRatios refine_ratios{};

}  // namespace geomesh::remesh

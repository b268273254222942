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
  double split_edge = 1.4;  ///< length from which an edge is halved: halves are then above 1 / split_edge
  double collapse_edge =
      0.6;  ///< length below which an edge is collapsed; below split_edge / 2, so that halves are kept
  double thin_out_edge = 0.5;  ///< the same for points that improvement turned out not to need
  /// For surfaces. The promise is a third; the surroundings of an edge need a margin.
  double thin_out_surface_edge = 0.4;
  double promised_edge = 0.34;    ///< length below which an edge is one too many, with a margin over the promised third
  double stretched_edge = 0.355;  ///< length to which an edge is stretched that cannot go
  double spacing = 0.68;          ///< distance of a new point to all others: half of it again is left to improvement
  double surface_spacing_off =
      0.3;                    ///< of the spacing, 0..1: required of a surface point from vertices off the surface
  double large_cell = 0.75;   ///< circumradius from which a cell gets a point; 0.61 for the regular one
  double large_face = 0.72;   ///< circumradius from which a face gets a point; 0.58 for the equilateral one
  double long_edge = 1.2;     ///< length from which an edge of a face is not done; below split_edge
  double hair = 1e-6;         ///< width of a strip of a kept surface below which points between its borders are in vain
  double least_height = 0.2;  ///< square of a new point's height above its face, over that of the target edge
  double least_way = 0.5;     ///< of the height, 0..1: a new point moves at least so far towards the circumcentre
  double inside_shape = 1e-3;    ///< least shape of a cell that a new point inside makes
  double surface_shape = 1e-7;   ///< the same on surfaces, whose neighbourhood is filled later
  double collapse_floor = 0.05;  ///< shape that a contraction may fall to where it was better
  double regular_floor = 1e-3;   ///< shape that flips and moves on surfaces may fall to, as `surface_shape`
  unsigned regular_rounds = 4;   ///< of flips and moves on surfaces; the fourth changes one face in a hundred
  /// Factor of the worst face about a vertex, > 1, that is worth its move. At 1.01, with good faces left alone, a tenth
  /// of refinement is saved, and six times as many cells end below 24.85 degrees.
  double regular_rise = 1.001;
  /// Share of all cells, 0..1. A front that slows with so many large cells left stands before cells far from Delaunay.
  double many_stuck = 0.15;
  std::size_t slow_front = 20;   ///< large cells for one point of a round from which a front counts as slow
  std::size_t idle_front = 100;  ///< the same from which centres are tried instead
};
inline constexpr RefineRatios refine_ratios{};

}  // namespace geomesh::remesh

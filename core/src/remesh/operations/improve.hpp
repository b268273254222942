// SPDX-License-Identifier: MIT
/// @file
/// Operations that raise the worst shape about a place.
#pragma once

#include <optional>

#include "quality/measure/shape.hpp"
#include "remesh/operations/operations.hpp"
#include "remesh/operations/star_optimizer.hpp"

namespace geomesh::remesh {

enum class SmoothGoal {
  worst,  ///< the worst shape about the vertex rises
  mean,   ///< the sum of their worths (MeanGoal) rises, the worst of them does not fall below `floor` and what it was
};

struct SmoothRule {
  unsigned max_steps = 12;
  double good_enough = 2;  ///< vertices whose worst shape is above are optimised no further
  SmoothGoal goal = SmoothGoal::worst;
  double floor = 0;
  double least_rise = 1.0005;  ///< of the worst shape, as a factor
  double least_gain = 0.02;    ///< for the mean: of the sum of worths about the vertex
  bool slides_on_edges =
      false;  ///< where surfaces are kept: vertices on input edges move along these, and else not at all
};

/// For flips that raise the mean worth (CellQuality::worth) of the mesh's cells: over the exchanged cells, however many
/// they become, the sum of their worths above `mean` must rise. No shape may fall below both `floor` and the worst
/// shape before.
struct MeanGoal {
  double floor, mean;
  static constexpr double least_gain = 1e-6;
  double least_after(double worst_before) const { return worst_before > floor ? floor : (1 - 1e-9) * worst_before; }
};

/// Moves v (within its patch, along its curve) where that raises the worst shape about it: the paper's smart smoothing,
/// with the optimal place as well as the centroid. Returns whether it moved.
bool smooth_vertex(Toolbox& tools, VertexIndex v, const SmoothRule& rule);

/// Smooths v with scratch of its own, for vertices that are smoothed concurrently: allowed if no two of them share an
/// edge and none evaluates sizes. The move is not counted in the statistics. Returns how much it raised the sum of
/// worths, if that is the goal (otherwise 0), or nothing if v was not moved.
std::optional<double> smooth_beside_others(Toolbox& tools, VertexIndex v, const SmoothRule& rule, Workspace& work);

/// Removes the edge (a, b) of cell c by the triangulation of its ring that has the best worst shape (Klincsek 1980;
/// Shewchuk 2002, "Two discrete optimization algorithms for the topological improvement of tetrahedral meshes"): 3-2,
/// 4-4 and n-to-m flips. An edge inside a patch is exchanged on the surface too (2-2) if the envelope admits it. Only
/// if the worst shape rises.
bool remove_edge(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b);

/// Exchanges an edge inside a patch for the other diagonal of its two faces where the surface is more nearly Delaunay
/// with it. That is where the opposite angles sum to more than half a turn. Shapes of cells may fall to `floor`: for
/// surfaces that have just been split and whose neighbourhood is still to be filled.
bool flip_surface_edge(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, double floor);

/// Returns whether that criterion requires a flip: the angles at x and y, opposite the edge in its faces, sum to more
/// than 180 degrees and a little, so that ties are left alone.
bool surface_asks_for_flip(const DomainMesh& mesh, VertexIndex a, VertexIndex b, VertexIndex x, VertexIndex y);

/// Moves a vertex within its patch to the centroid of its faces if their worst shape (4 sqrt 3 area / sum of squared
/// sides) rises. No cell at it may fall below both `floor` and its former shape. May run concurrently, like
/// smooth_beside_others.
bool smooth_on_surface(Toolbox& tools, VertexIndex v, double floor, Workspace& work);

/// Replaces the face i of c, and faces beside it as far as that helps, by the edge between the two vertices opposite:
/// the 2-3 flip and multi-face removal (Shewchuk 2002, section 3). Only where the worst shape rises.
bool remove_face(Toolbox& tools, CellIndex c, unsigned i);

/// Removes the edge whatever the result, as long as the new shapes are above `floor`: an opening of sequences that look
/// ahead.
bool remove_edge_above(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, double floor);
bool remove_face_above(Toolbox& tools, CellIndex c, unsigned i, double floor);

bool remove_edge_for_mean(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, const MeanGoal& goal);

/// A new point keeps this share of the target size from the vertices around it. With less room, points only crowd.
inline constexpr double usual_room = 0.5;

/// Inserts a vertex into the cell so that the worst shape about it rises: the cavity grows over the faces that would
/// make the worst new cells (Klingner and Shewchuk 2007, section 3.4, greedily), the place is optimised.
bool insert_to_improve(Toolbox& tools, CellIndex c, double room = usual_room);
/// Splits an edge where that, with the new vertex at its best place, raises the worst shape about it.
bool split_to_improve(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, double room = usual_room);

/// @name One operation about a cell, the first of its kind that raises the worst shape there.
/// Edges in the order of edge_vertices, faces by their index. Each returns whether something changed.
/// @{
bool flip_about_cell(Toolbox& tools, CellIndex c);
bool collapse_about_cell(Toolbox& tools, CellIndex c);
bool add_point_about_cell(Toolbox& tools, CellIndex c, double room);
/// @}

}  // namespace geomesh::remesh

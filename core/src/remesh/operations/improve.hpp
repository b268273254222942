// SPDX-License-Identifier: MIT
/// @file
/// Local operations that raise the worst or the mean shape of cells.
#pragma once

#include <optional>

#include "quality/measure/shape.hpp"
#include "remesh/operations/operations.hpp"
#include "remesh/operations/star_optimizer.hpp"

namespace geomesh::remesh {

enum class SmoothGoal {
  worst,  ///< the worst shape around the vertex must rise
  /// The sum of the worths of the cells (CellQuality::worth) must rise. The worst shape must not fall below both
  /// `floor` and its former value.
  mean,
};

struct SmoothRule {
  unsigned max_steps = 12;
  double good_enough = 2;  ///< a vertex is not moved any further once the worst shape around it is above this limit
  SmoothGoal goal = SmoothGoal::worst;
  double floor = 0;
  double least_rise = 1.0005;  ///< a move must raise the worst shape by at least this factor
  double least_gain = 0.02;    ///< least rise of the sum of worths (CellQuality), when the mean shape is raised
  /// If surfaces are kept exactly: whether vertices on input edges may move along these edges.
  bool slides_on_edges = false;
};

/// The goal of flips that raise the mean worth (CellQuality::worth) of all cells of the mesh. A flip must raise the sum
/// of (worth - `mean`) over the exchanged cells, whatever their number. No shape may fall below both `floor` and the
/// worst shape before the flip.
struct MeanGoal {
  double floor, mean;
  static constexpr double least_gain = 1e-6;
  double least_after(double worst_before) const { return worst_before > floor ? floor : (1 - 1e-9) * worst_before; }
};

/// Moves v, within its patch or along its curve, if this raises the worst shape around it. Both the optimal place and
/// the centroid are tried (smart smoothing). Returns whether v was moved.
bool smooth_vertex(Toolbox& tools, VertexIndex v, const SmoothRule& rule);

/// Smooths v with its own temporary storage, so that several vertices can be smoothed concurrently, if no two of them
/// share an edge and none evaluates sizes. The move is not counted in the statistics. Returns whether v was moved.
bool smooth_beside_others(Toolbox& tools, VertexIndex v, const SmoothRule& rule, Workspace& work);

/// Removes the edge (a, b) of cell c by the triangulation of its ring that has the best worst shape (Klincsek 1980;
/// Shewchuk 2002, "Two discrete optimization algorithms for the topological improvement of tetrahedral meshes"): 3-2,
/// 4-4 and n-to-m flips. An edge inside a patch is exchanged on the surface too (2-2) if the envelope admits it. The
/// edge is removed only if the worst shape rises.
bool remove_edge(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b);

/// Flips an edge inside a patch to the other diagonal of its two faces if the surface is more nearly Delaunay with it,
/// which is so if the opposite angles sum to more than 180 degrees. Shapes of cells may fall to `floor`, because this
/// is used on surfaces that have just been split and whose neighbourhood is still to be filled.
bool flip_surface_edge(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, double floor);

/// Returns whether the Delaunay criterion requires a flip: the angles at x and y, opposite the edge in its faces, sum
/// to more than 180 degrees by a margin, so that cocircular points are left alone.
bool surface_asks_for_flip(const DomainMesh& mesh, VertexIndex a, VertexIndex b, VertexIndex x, VertexIndex y);

/// Moves a vertex within its patch to the centroid of its faces if their worst shape (4 sqrt 3 area / sum of squared
/// sides) rises. The shape of no cell at the vertex may fall below both `floor` and its former value. May run
/// concurrently for vertices that share no edge.
bool smooth_on_surface(Toolbox& tools, VertexIndex v, double floor, Workspace& work);

/// Replaces face i of c by the edge between the two opposite vertices (2-3 flip) if this raises the worst shape.
bool remove_face(Toolbox& tools, CellIndex c, unsigned i);

/// Removes the edge a-b if all new shapes are above `floor`, even if they are worse than before. Later
/// operations are expected to repair them.
bool remove_edge_above(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, double floor);
bool remove_face_above(Toolbox& tools, CellIndex c, unsigned i, double floor);

bool remove_edge_for_mean(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, const MeanGoal& goal);

/// Least distance of a new point from vertices around it, as a share of the target size. Closer points crowd the mesh.
inline constexpr double usual_room = 0.5;

/// Inserts a vertex into the cell if this raises the worst shape around it. The cavity grows greedily across the faces
/// that would make the worst new cells (Klingner and Shewchuk 2007, section 3.4), and its place is optimised.
bool insert_to_improve(Toolbox& tools, CellIndex c, double room = usual_room);
/// Splits an edge if this, with the new vertex at its best place, raises the worst shape around it.
bool split_to_improve(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, double room = usual_room);

/// @name Operations around one cell
/// Each performs the first one of its kind that raises the worst shape there, trying edges in the order of
/// edge_vertices and faces by their index, and returns whether something changed.
/// @{
bool flip_about_cell(Toolbox& tools, CellIndex c);
bool collapse_about_cell(Toolbox& tools, CellIndex c);
bool add_point_about_cell(Toolbox& tools, CellIndex c, double room);
/// @}

}  // namespace geomesh::remesh

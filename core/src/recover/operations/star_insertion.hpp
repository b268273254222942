// SPDX-License-Identifier: MIT
/// @file
/// Insertion of a vertex by a star-shaped cavity: the paper's equation 1 (section 2.1) with the exact P2, in a mesh
/// with constraints. The cavity grows over each boundary face that the point does not strictly see; locked faces and
/// foreign subsegments stop it.
#pragma once

#include <span>

#include "recover/model/constrained_mesh.hpp"
#include "recover/model/constraints.hpp"

namespace geomesh::recover {

/// Joins x (a point not yet in the mesh) with the boundary of the cavity that grows from `seeds`. Subsegment `split`
/// (or none) may lie inside the cavity, other ones not; locked faces inside the seeds have to be unlocked before.
/// False: nothing was changed.
bool insert_in_star(ConstrainedMesh& mesh, const Constraints& constraints, VertexIndex x,
                    std::span<const CellIndex> seeds, Index split = no_index);

/// Joins x with the boundary of its Delaunay cavity, which ends at locked faces and shrinks where x does not see its
/// boundary; where it would swallow a subsegment, to `about`, the cells that have x inside or on their boundary. False
/// (x lies on a locked face or on a subsegment): nothing was changed.
bool insert_beside_constraints(ConstrainedMesh& mesh, const Constraints& constraints, VertexIndex x,
                               std::span<const CellIndex> about);

/// A finite cell that has vertex v, which need not be in the mesh yet, inside or on its boundary; walks from `start`.
/// no_cell: v is outside the box.
CellIndex locate_vertex(ConstrainedMesh& mesh, VertexIndex v, CellIndex start);
/// The finite cells that have v inside or on their boundary, from one of them.
std::vector<CellIndex> cells_about_vertex(ConstrainedMesh& mesh, VertexIndex v, CellIndex cell);

/// The finite cells that have p inside or on their boundary, from one of them.
std::vector<CellIndex> cells_about(ConstrainedMesh& mesh, const Vec3& p, CellIndex cell);

}  // namespace geomesh::recover

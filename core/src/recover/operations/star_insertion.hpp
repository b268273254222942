// SPDX-License-Identifier: MIT
/// @file
/// Insertion of a vertex by a star-shaped cavity in a mesh with constraints (Cavalcanti and Mello 1999, equation 1 in
/// section 2.1, with exact predicates). The cavity grows across each boundary face that the point does not strictly
/// see. Locked faces and subsegments stop its growth.
#pragma once

#include <span>

#include "recover/model/constrained_mesh.hpp"
#include "recover/model/constraints.hpp"

namespace geomesh::recover {

/// Connects x (a point not yet in the mesh) with the boundary of the cavity that grows from the cells `seeds`. The
/// subsegment `split` may lie inside the cavity, but no other subsegment may; locked faces between the seeds must be
/// unlocked before. Returns false if nothing was changed.
bool insert_in_star(ConstrainedMesh& mesh, const Constraints& constraints, VertexIndex x,
                    std::span<const CellIndex> seeds, Index split = no_index);

/// Connects x with the boundary of its Delaunay cavity, which ends at locked faces and loses cells of which x does not
/// see the outer faces. If the cavity would enclose a subsegment, the insertion starts from `about` instead, the cells
/// that contain x inside or on their boundary. Returns false, changing nothing, if x is on a locked face or subsegment.
bool insert_beside_constraints(ConstrainedMesh& mesh, const Constraints& constraints, VertexIndex x,
                               std::span<const CellIndex> about);

/// Returns a finite cell that contains vertex v, which need not be in the mesh yet, inside or on its boundary; walks
/// from `start`. Returns no_cell if v is outside the box.
CellIndex locate_vertex(ConstrainedMesh& mesh, VertexIndex v, CellIndex start);
/// Returns the finite cells that contain v inside or on their boundary, given one of them.
std::vector<CellIndex> cells_about_vertex(ConstrainedMesh& mesh, VertexIndex v, CellIndex cell);

/// Returns the finite cells that contain point p inside or on their boundary; `cell` is one of them.
std::vector<CellIndex> cells_about(ConstrainedMesh& mesh, const Vec3& p, CellIndex cell);

}  // namespace geomesh::recover

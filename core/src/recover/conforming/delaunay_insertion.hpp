// SPDX-License-Identifier: MIT
/// @file
/// Insertion of a point into the Delaunay mesh of conforming mode by the cavity algorithm (Cavalcanti and Mello 1999,
/// section 2.1). The mesh is the perturbed Delaunay triangulation of its vertices before and after, so the cavity is
/// star-shaped (equation 1, checked).
#pragma once

#include "recover/model/constrained_mesh.hpp"

namespace geomesh::recover {

struct DelaunayInsertion {
  VertexIndex vertex = no_vertex;  ///< the new vertex; no_vertex if the point equals a vertex or lies outside the box
  std::vector<std::array<VertexIndex, 2>>
      edges;                    ///< mesh edges that the insertion removed, some repeatedly, and a few that it kept
  std::vector<Triangle> faces;  ///< faces that the insertion removed: those between two cells in conflict with it
};

/// Inserts point p by the Delaunay cavity algorithm and stores the result in `out`, whose lists are reused.
void insert_delaunay(ConstrainedMesh& mesh, const Vec3& p, CellIndex start, DelaunayInsertion& out);

/// Returns the cells in conflict with point p, first one that contains p; none if p is a vertex or off the model's box.
std::vector<CellIndex> conflict_cells(ConstrainedMesh& mesh, const Vec3& p, CellIndex start);
/// Replaces the cells in conflict with p by the star of p. `cavity` must contain all of them and not be empty.
void insert_into(ConstrainedMesh& mesh, const Vec3& p, std::span<const CellIndex> cavity, DelaunayInsertion& out);

/// Returns whether every finite cell without a box vertex is locally Delaunay: decided exactly, ties allowed.
bool is_locally_delaunay(const ConstrainedMesh& mesh);

}  // namespace geomesh::recover

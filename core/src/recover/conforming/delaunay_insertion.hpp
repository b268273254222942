// SPDX-License-Identifier: MIT
/// @file
/// Insertion of a point into the Delaunay mesh of conforming mode by the cavity algorithm (section 2.1 of the paper).
/// The mesh is the perturbed Delaunay triangulation of its vertices before and after, so the cavity is star-shaped
/// (equation 1, checked).
#pragma once

#include "recover/model/constrained_mesh.hpp"

namespace geomesh::recover {

struct DelaunayInsertion {
  VertexIndex vertex = no_vertex;  ///< no_vertex where the point equals a vertex or lies outside the box
  std::vector<std::array<VertexIndex, 2>>
      edges;                    ///< all that are gone, and some that are still there; some more than once
  std::vector<Triangle> faces;  ///< that are gone: between two cells that conflicted
};

/// Inserts into `out`, whose lists are reused.
void insert_delaunay(ConstrainedMesh& mesh, const Vec3& p, CellIndex start, DelaunayInsertion& out);

/// The cells that p conflicts with, the one that holds p first; none where p equals a vertex or lies outside the box.
std::vector<CellIndex> conflict_cells(ConstrainedMesh& mesh, const Vec3& p, CellIndex start);
/// Replaces the cells that p conflicts with, all of them and not none, by the star of p.
void insert_into(ConstrainedMesh& mesh, const Vec3& p, std::span<const CellIndex> cavity, DelaunayInsertion& out);

/// Whether every finite cell that has no box vertex is Delaunay towards its neighbours: exactly, ties allowed.
bool is_locally_delaunay(const ConstrainedMesh& mesh);

}  // namespace geomesh::recover

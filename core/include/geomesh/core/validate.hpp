// SPDX-License-Identifier: MIT
/// @file
/// Validators of the simplicial complex: each checks one list of invariants and collects all faults (at most `limit`),
/// never stopping at the first.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

struct MeshFault {
  std::string what;  ///< the invariant that does not hold
  CellIndex cell = no_cell;
};

/// What is beyond the hull's faces: ghost cells, or nothing.
enum class Outside { ghosts, open };

/// Invariants 1 to 4 of simplex_mesh.hpp. Linear.
std::vector<MeshFault> validate_topology(const TetMesh& mesh, std::size_t limit = 100,
                                         Outside outside = Outside::ghosts);
/// Every finite cell is exactly positive. Linear.
std::vector<MeshFault> validate_geometry(const TetMesh& mesh, std::span<const Vec3> points, std::size_t limit = 100);
/// Every face is locally Delaunay under the perturbation, hull faces and convexity included. With validate_topology and
/// validate_geometry this makes the mesh the Delaunay tetrahedralization (Delaunay 1934). Linear.
std::vector<MeshFault> validate_delaunay(const TetMesh& mesh, std::span<const Vec3> points, std::size_t limit = 100);

}  // namespace geomesh

// SPDX-License-Identifier: MIT
/// @file
/// Validators of the simplicial complex: each checks a list of invariants and collects all faults (at most `limit`)
/// instead of stopping at the first.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

struct MeshFault {
  std::string what;  ///< the violated invariant
  CellIndex cell = no_cell;
};

/// The outside of the hull's faces: ghost cells, or nothing.
enum class Outside { ghosts, open };

/// Checks invariants 1 to 4 of simplex_mesh.hpp. Linear.
std::vector<MeshFault> validate_topology(const TetMesh& mesh, std::size_t limit = 100,
                                         Outside outside = Outside::ghosts);
/// Checks that every finite cell is exactly positive. Linear.
std::vector<MeshFault> validate_geometry(const TetMesh& mesh, std::span<const Vec3> points, std::size_t limit = 100);
/// Checks that every face is locally Delaunay under the perturbation, including hull faces and convexity. Together with
/// validate_topology and validate_geometry this proves that the mesh is the Delaunay tetrahedralization (Delaunay
/// 1934). Linear.
std::vector<MeshFault> validate_delaunay(const TetMesh& mesh, std::span<const Vec3> points, std::size_t limit = 100);

}  // namespace geomesh

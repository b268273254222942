// SPDX-License-Identifier: MIT
/// @file
/// Validators of the simplicial complex: each checks a list of invariants and collects all violations (at most `limit`)
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

/// Whether faces of the convex hull have ghost cells as neighbours outside, or none.
enum class Outside { ghosts, open };

/// Checks the topological invariants 1 to 4 that simplex_mesh.hpp lists. Linear time.
std::vector<MeshFault> validate_topology(const TetMesh& mesh, std::size_t limit = 100,
                                         Outside outside = Outside::ghosts);
/// Checks that every finite cell has exactly positive orientation. Linear time.
std::vector<MeshFault> validate_geometry(const TetMesh& mesh, std::span<const Vec3> points, std::size_t limit = 100);
/// Checks that every face is locally Delaunay under the perturbation, including hull faces and convexity. Together with
/// validate_topology and validate_geometry this proves that the mesh is the Delaunay tetrahedralization (Delaunay
/// 1934). Linear time.
std::vector<MeshFault> validate_delaunay(const TetMesh& mesh, std::span<const Vec3> points, std::size_t limit = 100);

}  // namespace geomesh

// SPDX-License-Identifier: MIT
/// @file
/// Tetrahedra without added points for a small polyhedron given by its triangulated boundary: first a fan from one
/// vertex, then a search with backtracking (after Liu, Chen and Sun 2009, "Small polyhedron reconnection"; the order of
/// the search is that of gift wrapping of the Delaunay tetrahedra, so that where the constrained Delaunay filling
/// exists it is mostly found at once).
///
/// No intersection test is needed for the answer to be right: positive tetrahedra whose faces cancel in pairs but for
/// the boundary cover each point as often as the boundary winds about it. That is once inside. Crossings are tested
/// only to end hopeless branches early.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "recover/model/constrained_mesh.hpp"
#include "recover/model/constraints.hpp"

namespace geomesh::recover {

/// The vertices of the triangles, sorted.
std::vector<VertexIndex> vertices_of(std::span<const Triangle> boundary);

struct FillingLimits {
  std::size_t max_faces = 120;
  std::size_t max_nodes = 400;  ///< tetrahedra tried
};

/// `boundary`: triangles counter-clockwise seen from inside. A triangle may stand in it in both orientations (a sheet
/// that hangs inside); it is a face of the filling then. Polyhedra of more than 64 vertices are refused.
std::optional<std::vector<Tetrahedron>> fill_polyhedron(const ConstrainedMesh& mesh, const Constraints& constraints,
                                                        std::span<const Triangle> boundary,
                                                        const FillingLimits& limits = {});

/// All of `boundary` joined with v, where every triangle without v is seen from it exactly.
std::optional<std::vector<Tetrahedron>> fan_from(const ConstrainedMesh& mesh, const Constraints& constraints,
                                                 std::span<const Triangle> boundary, VertexIndex v);

}  // namespace geomesh::recover

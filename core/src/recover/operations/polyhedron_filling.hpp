// SPDX-License-Identifier: MIT
/// @file
/// Fills a small polyhedron without added points, given by its triangulated boundary: first a fan from one
/// vertex, then a search with backtracking (after Liu, Chen and Sun 2009, "Small polyhedron reconnection"; the order of
/// the search is that of gift wrapping of the Delaunay tetrahedra, so that the constrained Delaunay filling, if it
/// exists, is usually found at once).
///
/// No intersection test is needed for the answer to be right: positive tetrahedra whose faces cancel in pairs except
/// for the boundary cover each point as often as the boundary winds around it, which is once inside. Crossings are
/// tested only to end hopeless branches early.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "recover/model/constrained_mesh.hpp"
#include "recover/model/constraints.hpp"

namespace geomesh::recover {

std::vector<VertexIndex> vertices_of(std::span<const Triangle> boundary);

struct FillingLimits {
  std::size_t max_faces = 120;
  std::size_t max_nodes = 400;  ///< tetrahedra tried
};

/// Returns cells that fill a polyhedron, or nothing. `boundary` contains triangles that are counter-clockwise as seen
/// from inside. A triangle inside may occur in both orientations and is then a face of the filling. Polyhedra of more
/// than 64 vertices are rejected.
std::optional<std::vector<Tetrahedron>> fill_polyhedron(const ConstrainedMesh& mesh, const Constraints& constraints,
                                                        std::span<const Triangle> boundary,
                                                        const FillingLimits& limits = {});

/// Returns the cells that connect v with the triangles of `boundary` that do not have v, if all these triangles are
/// visible from v, decided exactly; otherwise nothing.
std::optional<std::vector<Tetrahedron>> fan_from(const ConstrainedMesh& mesh, const Constraints& constraints,
                                                 std::span<const Triangle> boundary, VertexIndex v);

}  // namespace geomesh::recover

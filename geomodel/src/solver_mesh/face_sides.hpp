// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the tetrahedra on both sides of faces.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

struct TetrahedronSide {
  std::size_t tetrahedron;  ///< row of the tetrahedron; no_side if there is no tetrahedron on that side of the face
  unsigned opposite;        ///< position (0 to 3) in the tetrahedron of the vertex opposite the face
};
inline constexpr std::size_t no_side = SIZE_MAX;

/// Returns for each face the tetrahedron that its normal points away from, and the one that its normal points to.
std::vector<std::array<TetrahedronSide, 2>> tetrahedra_at_faces(const std::vector<Tetrahedron>& tetrahedra,
                                                                const std::vector<Triangle>& faces);

/// The four neighbours of one tetrahedron: the row of the tetrahedron across the face opposite each vertex, or
/// no_neighbour at the boundary.
using Neighbours = std::array<std::uint32_t, 4>;
inline constexpr std::uint32_t no_neighbour = UINT32_MAX;

using TetrahedronRows = std::span<const VertexIndex>;
/// Returns the neighbours of tetrahedra across their faces: of all tetrahedra, or of those whose rows are in `pieces`,
/// which are then numbered consecutively. O(n log n); takes about 3 bytes per tetrahedron besides the result.
std::vector<Neighbours> tetrahedra_across(const std::vector<Tetrahedron>& tetrahedra,
                                          std::span<const TetrahedronRows> pieces = {});

}  // namespace geomesh::geomodel

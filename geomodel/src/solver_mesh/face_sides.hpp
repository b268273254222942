// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which tetrahedra lie at a face.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

struct TetrahedronSide {
  std::size_t tetrahedron;  ///< row; no_side where outside
  unsigned opposite;        ///< the vertex that the face is opposite to
};
inline constexpr std::size_t no_side = SIZE_MAX;

/// For each face: the tetrahedron that its normal points away from, and that which it points to.
std::vector<std::array<TetrahedronSide, 2>> tetrahedra_at_faces(const std::vector<Tetrahedron>& tetrahedra,
                                                                const std::vector<Triangle>& faces);

/// The tetrahedra across the faces of one: its row for the face opposite to each vertex, no_neighbour on the outside.
using Neighbours = std::array<std::uint32_t, 4>;
inline constexpr std::uint32_t no_neighbour = UINT32_MAX;

/// Rows of some tetrahedra.
using TetrahedronRows = std::span<const VertexIndex>;
/// Of the tetrahedra of all pieces, numbered through; of none: of all as they are. O(n log n); takes about 3 bytes a
/// tetrahedron beside the result.
std::vector<Neighbours> tetrahedra_across(const std::vector<Tetrahedron>& tetrahedra,
                                          std::span<const TetrahedronRows> pieces = {});

}  // namespace geomesh::geomodel

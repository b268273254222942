// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which tetrahedra lie at a face.
#pragma once

#include <array>
#include <cstdint>
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

/// For each tetrahedron: those across its faces, face i opposite to vertex i; no_side on the outside. O(n log n).
std::vector<std::array<std::size_t, 4>> tetrahedra_across(const std::vector<Tetrahedron>& tetrahedra);

}  // namespace geomesh::geomodel

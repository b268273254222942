// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where triangles cross a fault, and where its continuation beyond the end that it has inside the model.
#pragma once

#include <cstdint>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// The box that nothing is outside of.
inline constexpr Box3 everywhere{Box3{}.max, Box3{}.min};

/// A fault across which a horizon has throw, and where its own continuation begins (its number of triangles where there
/// is none).
struct ThrowFault {
  const TriangulatedSurface* surface;
  Index first_made;
};

/// What a triangle crosses: nothing, a fault as it is, or the continuation of one (which wins over the fault itself:
/// the fault ends in that triangle).
enum class Crossing : std::uint8_t { none, fault, continuation };

/// Of the horizon's triangles from row `first` on; by exact orientation of edges against triangles. Continuations count
/// inside the box.
std::vector<Crossing> find_crossings(const TriangulatedSurface& horizon, std::size_t first,
                                     const std::vector<ThrowFault>& faults, const Box3& box);

}  // namespace geomesh::geomodel

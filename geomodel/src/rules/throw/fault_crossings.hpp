// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds triangles that cross a fault, and those that cross its extension beyond an end inside the model.
#pragma once

#include <cstdint>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// A box without limits, which contains every point.
inline constexpr Box3 everywhere{Box3{}.max, Box3{}.min};

/// A fault across which a horizon has throw; its triangles from index `first_made` on extend it beyond its ends.
struct ThrowFault {
  const TriangulatedSurface* surface;
  Index first_made;
};

/// Returns whether the fault has an extension inside the box. It has none if it ends on the sides, up to rounding.
bool ends_inside(const ThrowFault& fault, const Box3& box);

/// The kind of surface that a triangle crosses: nothing, a given fault, or the extension of a fault (which takes
/// precedence over the fault itself, because the fault ends in that triangle).
enum class Crossing : std::uint8_t { none, fault, continuation };

/// Classifies the horizon's triangles from index `first` on, by exact orientation of edges against triangles.
/// Extensions of faults count only inside the box.
std::vector<Crossing> find_crossings(const TriangulatedSurface& horizon, std::size_t first,
                                     const std::vector<ThrowFault>& faults, const Box3& box);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Single vertices of a horizon far above or below all of their neighbours: a slip of a digit, a bad pick.
#pragma once

#include <cstddef>
#include <string>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

struct Spikes {
  std::size_t n = 0;
  Vec3 place;         ///< the vertex that stands out most
  double height = 0;  ///< from its nearest neighbour along z; negative: below all neighbours
  double around = 0;  ///< the largest step along z between neighbours of that vertex that are joined
};

/// Vertices inside the surface that lie above all of their neighbours, or below all. The distance along z to the
/// nearest of them is ten times the steps between these neighbours, and between neighbours on the surface at large
/// (median), and a quarter of the range of the surface's heights without the tenth that is most extreme. Smeared
/// faults, peaks among mountains and noise are none. Nor has a surface of fewer than 100 vertices any. Linear in the
/// triangles, up to sorting.
Spikes find_spikes(const TriangulatedSurface& surface);

/// "2 vertices stand far above or below all of their neighbours, ...", with the place moved by `origin`.
std::string spikes_words(const Spikes& spikes, const Vec3& origin);

/// The advice that follows a message about spikes.
constexpr const char* spikes_remedy =
    "if it is a slip in the file, correct it there; no_data: VALUE in the entry leaves out all points of that height";

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds single vertices of a horizon far above or below all neighbours, caused by a wrong digit or a bad pick.
#pragma once

#include <cstddef>
#include <string>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

struct Spikes {
  std::size_t n = 0;
  Vec3 place;         ///< position of the highest spike of the surface, compared with its surroundings
  double height = 0;  ///< vertical distance of the spike from its nearest neighbour; negative if below all
  double around = 0;  ///< largest height difference between two neighbours of the spike that are joined by an edge
};

/// Returns inner vertices that lie far above, or far below, all of their neighbours. The vertical distance of such a
/// vertex to the nearest neighbour is at least ten times the steps between these neighbours, ten times the median step
/// on the surface, and a quarter of the range of the surface's heights without the most extreme tenth. This excludes
/// smeared faults, peaks among mountains, noise, and surfaces with fewer than 100 vertices. Linear up to sorting.
Spikes find_spikes(const TriangulatedSurface& surface);

/// Formats spikes as "2 vertices stand far above or below all of their neighbours, ..."; `origin` is added to places.
std::string spikes_words(const Spikes& spikes, const Vec3& origin);

constexpr const char* spikes_remedy =
    "if it is a slip in the file, correct it there; no_data: VALUE in the entry leaves out all points of that height";

}  // namespace geomesh::geomodel

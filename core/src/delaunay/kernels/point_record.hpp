// SPDX-License-Identifier: MIT
/// @file
/// Points as used by insertion: copies in insertion order, so that neighbours in space are neighbours in memory.
#pragma once

#include <cstdint>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// A point of 32 bytes, half a cache line. Slicing to Vec3 gives the coordinates.
struct PointRecord : Vec3 {
  VertexIndex id = no_vertex;      ///< the caller's index of the point
  std::uint16_t local = no_local;  ///< during an insertion, index among the vertices of the cavity's boundary
  std::uint16_t place = 0;         ///< part of the Hilbert curve in which the point lies (SpatialOrder::place)
  static constexpr std::uint16_t no_local = 0xFFFF;
};
static_assert(sizeof(PointRecord) == 32);

/// The part [first, end) of the Hilbert curve to which an insertion is restricted. It may change only cells with all
/// vertices on this part; other cells are only read.
struct Ownership {
  std::uint16_t first = 0, end = 0xFFFF;
};

}  // namespace geomesh

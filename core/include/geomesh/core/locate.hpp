// SPDX-License-Identifier: MIT
/// @file
/// Point location by an exact walk through adjacency (Cavalcanti and Mello 1999, section 2.2; Devillers, Pion and
/// Teillaud 2002, "Walking in a triangulation": the remembering stochastic walk).
#pragma once

#include <cstdint>
#include <span>

#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

enum class LocationKind {
  inside_cell,   ///< strictly inside `cell`
  on_face,       ///< strictly inside face `i` of `cell`
  on_edge,       ///< strictly inside the edge of `cell` between local vertices `i` and `j`
  at_vertex,     ///< equal to local vertex `i` of `cell`
  outside_hull,  ///< strictly beyond the hull face of the ghost `cell`
};

struct Location {
  LocationKind kind = LocationKind::inside_cell;
  CellIndex cell = no_cell;
  unsigned i = 0, j = 0;
};

/// A cheap seeded generator: the walk tries faces in random order, so that it cannot cycle for ever in meshes that are
/// not Delaunay.
class WalkRandom {
 public:
  explicit WalkRandom(std::uint64_t seed = 1) : state_(seed | 1) {}
  std::uint32_t next() {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<std::uint32_t>(state_ >> 33);
  }

 private:
  std::uint64_t state_;
};

/// Walks from `hint` (a live cell, finite or ghost) to p. The mesh must fill its convex hull with exactly positive
/// cells. Expected O(n^(1/3)) steps from a random hint, O(1) from a near one; `steps`, where given, is increased by the
/// cells visited.
Location locate(const TetMesh& mesh, std::span<const Vec3> points, const Vec3& p, CellIndex hint, WalkRandom& random,
                std::size_t* steps = nullptr);

}  // namespace geomesh

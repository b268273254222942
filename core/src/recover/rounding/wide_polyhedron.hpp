// SPDX-License-Identifier: MIT
/// @file
/// Finds doubles in an open convex polyhedron that may be far thinner than the spacing of doubles around it.
///
/// A thin polyhedron need not be empty. A slab of 1e-15 m by 10 m by 10 m has 1e23 points of a lattice of 1e-12 m,
/// unless it is parallel to a plane of the lattice. These points are seldom near a given place in the slab, so they are
/// not searched around one. Instead, the basis of the lattice is reduced in the shape of the polyhedron (Lenstra 1983,
/// integer programming in a fixed dimension).
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "predicates/two_double.hpp"

namespace geomesh::recover {

using WidePoint = std::array<exact::TwoDouble, 3>;

/// The half-space of the points y with at + normal . y > 0.
struct WidePlane {
  WidePoint normal;
  exact::TwoDouble at;
};

/// A bounded polyhedron. The point `inside` is on the positive side of all planes. Places are relative to `origin`.
struct WidePolyhedron {
  Vec3 origin;   ///< origin of coordinates in the polyhedron; a multiple of the lattice spacing on each axis
  Vec3 spacing;  ///< lattice spacing by axis: powers of two whose multiples are doubles everywhere in the polyhedron
  std::vector<WidePlane> planes;
  WidePoint inside;
};

/// Passes lattice points in the polyhedron, up to rounding, to `accept` until it returns true. Points far from all
/// planes tend to come first. Returns false if none was accepted. O(planes^2) for each of at most a thousand points.
bool find_double_inside(const WidePolyhedron& polyhedron, const std::function<bool(const Vec3&)>& accept);

}  // namespace geomesh::recover

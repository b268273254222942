// SPDX-License-Identifier: MIT
/// @file
/// The Chebyshev centre of a small polyhedron: the point with the greatest least distance to its planes.
#pragma once

#include <array>
#include <span>

namespace geomesh::recover {

/// A point's height over a plane as a linear function of the point's displacement: `at` zero, and slope by direction.
struct LinearHeight {
  double at;
  std::array<double, 3> slope;
};

/// Returns the displacement in the first `n_directions` directions (1 to 3) for which the least of `heights` is
/// greatest. This is a linear program in the displacement and that height, solved from vertex to vertex by active sets.
/// All heights must be positive at 0. The least height never decreases, so any end of the walk is valid. Complexity:
/// O(heights) for each of at most `most_steps` steps; about ten steps suffice for stars.
std::array<double, 3> chebyshev_centre(std::span<const LinearHeight> heights, unsigned n_directions,
                                       unsigned most_steps);

/// Returns the least of a point's heights over several planes, each a linear function of its displacement.
double least_height(std::span<const LinearHeight> heights, const std::array<double, 3>& displacement);

}  // namespace geomesh::recover

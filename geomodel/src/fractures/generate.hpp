// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Generates networks of disc-shaped fractures from statistical distributions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fractures/fracture.hpp"

namespace geomesh::geomodel {

/// A family of disc-shaped fractures. Their poles scatter around that of a mean plane by the distribution of Fisher
/// (1953), and their radii follow a power law between bounds. Their centres are uniform in the box and around it up to
/// the largest radius, so that the density near the sides of the box equals that inside.
struct FractureFamily {
  std::string name;
  double dip_direction = 0, dip = 0;  ///< degrees
  double kappa = 0;                   ///< concentration of the poles around their mean; 0: uniform over all directions
  double least_radius = 0, greatest_radius = 0;
  double exponent = 0;  ///< the probability density of radii is proportional to r to the power -(1 + exponent)
  double p32 = 0;  ///< target for the area of discs in the box divided by the volume of the box; 0: `count` is used
  std::size_t count = 0;  ///< number of discs of the family that meet the box
};

/// Generates the fractures of all families, with the names family_1, family_2 ... The same families, box and seed give
/// the same discs. Precondition: the reader of the project has checked the families. Throws Error{usage} if more than
/// 200,000 discs would be needed.
std::vector<Fracture> generate_fractures(const std::vector<FractureFamily>& families, const Box3& box, int n_corners,
                                         std::uint64_t seed);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fracture networks drawn from distributions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fractures/fracture.hpp"

namespace geomesh::geomodel {

/// Discs whose poles scatter about that of a mean plane by the distribution of Fisher (1953), whose radii follow a
/// power law between bounds, and whose centres are uniform in the box and as far about it as the largest radius, so
/// that the density near its sides is that inside.
struct FractureFamily {
  std::string name;
  double dip_direction = 0, dip = 0;  ///< degrees
  double kappa = 0;                   ///< concentration of the poles; 0: all directions alike
  double least_radius = 0, greatest_radius = 0;
  double exponent = 0;    ///< the density of radii falls as r to the power -(1 + exponent)
  double p32 = 0;         ///< area in the box over the volume of the box that is reached; 0: `count`
  std::size_t count = 0;  ///< discs that meet the box
};

/// Names are family_1, family_2 ... The same families, box and seed give the same discs. Precondition: checked by the
/// reader of the project. Throws Error{usage} where more than 200,000 discs would be needed.
std::vector<Fracture> generate_fractures(const std::vector<FractureFamily>& families, const Box3& box, int n_corners,
                                         std::uint64_t seed);

}  // namespace geomesh::geomodel

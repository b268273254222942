// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Networks of random discs in the unit cube, intersected with each other and with the sides of the cube.
#pragma once

#include "recovery_families.hpp"

namespace geomesh::geomodel::testing {

/// `n` discs of 12 corners, their centres and directions uniform at random. The radius is such that the number of discs
/// that one disc meets does not depend on `n`, which makes the network's size proportional to `n`.
test::FamilyModel disc_network(unsigned seed, unsigned n);

/// As disc_network with all radii `radius`: the network's size grows with the square of `n` and faster.
test::FamilyModel disc_network(unsigned seed, unsigned n, double radius);

/// 10 to 2,000 discs.
test::ModelFamily disc_family();

}  // namespace geomesh::geomodel::testing

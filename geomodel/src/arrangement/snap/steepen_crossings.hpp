// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Surfaces that cross at a very small angle, moved so that they cross at a greater one.
#pragma once

#include "arrangement/model/contacts.hpp"
#include "arrangement/snap/join_surfaces.hpp"

namespace geomesh::geomodel::arrangement {

/// Between two surfaces that cross at a small angle there is a wedge in which no element has a good shape. Of two that
/// cross so somewhere one is moved off the other: up to a slope of 2 degrees beside their curve, by the asked height at
/// most, and by less where they are farther from each other than that already. What lay over the other lies over it
/// still, and the curve stays where it was. Facets beside the curve are split first. Vertices that other surfaces or
/// wells share stay. `volume`: points on its box keep to its planes, and its sides stay. Gives what was moved. Nothing
/// changes where no two surfaces cross so. O(n log n) for the surfaces that do.
Displacement steepen_crossings(Complex& complex, const Contacts& contacts, const ArrangementOptions::Steepening& asked,
                               const Joining& volume);

}  // namespace geomesh::geomodel::arrangement

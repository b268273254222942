// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Parts of a surface that hang from the rest of it and are thinner than the distance within which surfaces are brought
/// together.
#pragma once

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

struct CutFlaps {
  std::size_t n_flaps = 0;
  Displacement moved;  ///< of the corners of what went, to the surface that stays
  std::vector<VanishedFacet> vanished;
};

/// A flap is a piece of one surface between its hinge and edges at which it ends. At the edges of the hinge the surface
/// has three facets or more. Where a needle beside it vanished, the surface is whole without it. Flaps of which all
/// is within the distance of their hinge are taken off the surface. Each edge of the hinge keeps two facets of it
/// or more. Where one other surface ends on the flap, the flap becomes that one's, which so goes on to the hinge. Where
/// more meets it the flap stays. No facet moves, so nothing new can cross. Points that nothing names may be left.
/// O(n log n).
CutFlaps cut_flaps(Complex& complex, double distance);

}  // namespace geomesh::geomodel::arrangement

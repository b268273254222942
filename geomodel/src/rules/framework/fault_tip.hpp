// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Edges at which faults end inside the model.
#pragma once

#include "geomesh/core/geometry.hpp"
#include "rules/planar/reach.hpp"

namespace geomesh::geomodel {

/// An edge of a fault's border that lies on no other fault.
struct FaultTip {
  EdgeEnds ends;
  Vec3 normal;  ///< normal of the fault's facet at the edge, not normalised
  Index fault;  ///< index of the fault among the surfaces
};

}  // namespace geomesh::geomodel

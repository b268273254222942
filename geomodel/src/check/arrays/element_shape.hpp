// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Measures the shape of one element for the checker, with formulas independent of those of the mesher.
#pragma once

#include <array>

#include "check/mesh/checked_mesh.hpp"

namespace geomesh::geomodel::checking {

/// Shape measures of one tetrahedron, as defined in docs/meshing.md, "What the statistics mean".
struct ElementShape {
  std::array<double, 6> dihedral;  ///< degrees
  double min_dihedral, max_dihedral;
  double radius_ratio, mean_ratio, aspect;
  double shortest_edge, longest_edge;
  /// Upper bound in radians on the rotation of a face by rounding of the coordinates. It is above 1 for elements as
  /// flat as rounding, and infinite if the volume is zero in floating point (shape ratios are 0 then).
  double turn;
  double ulp;  ///< as given
  /// Bounds on the amount by which rounding may make another program's measures of this tetrahedron differ: its angles
  /// (in degrees), its ratios and its lengths.
  double slack_of_angles() const;
  double slack_of_ratios() const;
  double slack_of_lengths() const;
};

/// Measures a tetrahedron with these corners. `ulp` is the distance between neighbouring numbers at the mesh's largest
/// coordinate. Precondition: the tetrahedron's volume is positive.
ElementShape element_shape(const std::array<Vec3, 4>& corners, double ulp);
ElementShape element_shape(const CheckedMesh& mesh, const Tetrahedron& cell, double ulp);

}  // namespace geomesh::geomodel::checking

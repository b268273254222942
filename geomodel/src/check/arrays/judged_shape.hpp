// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The shape of one element as the judge measures it, by formulas apart from those of the mesher.
#pragma once

#include <array>

#include "check/judged/judged_mesh.hpp"

namespace geomesh::geomodel::checking {

/// Definitions: docs/meshing.md, "What the statistics mean".
struct JudgedShape {
  std::array<double, 6> dihedral;  ///< degrees
  double min_dihedral, max_dihedral;
  double radius_ratio, mean_ratio, aspect;
  double shortest_edge, longest_edge;
  /// How far rounding of the coordinates may turn a face, in radians; above 1 for elements as low as rounding, infinite
  /// where floats tell no volume (ratios are 0 then).
  double turn;
  double ulp;  ///< as given
  /// How far another program's angles (degrees), ratios and lengths may be off these.
  double slack_of_angles() const;
  double slack_of_ratios() const;
  double slack_of_lengths() const;
};

/// `ulp`: the distance between neighbouring numbers at the mesh's largest coordinate. The volume is positive.
JudgedShape judged_shape(const std::array<Vec3, 4>& corners, double ulp);
JudgedShape judged_shape(const JudgedMesh& mesh, const Tetrahedron& cell, double ulp);

}  // namespace geomesh::geomodel::checking

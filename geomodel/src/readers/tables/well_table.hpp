// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Computes well paths from deviation surveys: measured depth, inclination and azimuth.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

struct SurveyStation {
  double md = 0;           ///< measured depth: length along the well path
  double inclination = 0;  ///< angle of the well path from the vertical in degrees: 0 is straight down
  double azimuth = 0;      ///< direction of the well path in degrees clockwise from north (y)
};

/// Returns a well path from its survey by the minimum curvature method (arcs of circles that are tangent to the
/// directions at both stations; S. J. Sawaryn and J. L. Thorogood, 2005), relative to its head, with z up and in the
/// unit of `md`. Points are at the stations and along each arc, at most `most_turn` degrees apart, so that lengths
/// along the chords are measured depths to 2e-5. If the first station is below the head, the path begins at the head
/// and leads straight down. Precondition: md does not decrease.
std::vector<Vec3> path_of_survey(const std::vector<SurveyStation>& stations, double most_turn = 1);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The checker's own allowances for rounding.
#pragma once

namespace geomesh::geomodel::checking {

/// Relative error of values that other programs, or the mesher, compute in doubles and write with enough digits.
inline constexpr double agreement = 1e-9;
/// Number of ulps by which they may round the coordinates of a point differently: sides that are not along the axes are
/// rounded, surfaces are joined to them within 32 ulps, and points between these are rounded again.
inline constexpr double ulps_of_places = 40;

}  // namespace geomesh::geomodel::checking

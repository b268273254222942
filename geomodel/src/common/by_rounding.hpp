// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Returns a bound on the effect of rounding of coordinates on lengths.
#pragma once

namespace geomesh::geomodel {

/// Share of a length by which a few operations on doubles may change it: much more than the actual error (about 1e-15),
/// much less than the accuracy of any data.
inline constexpr double by_rounding = 1e-9;

}  // namespace geomesh::geomodel

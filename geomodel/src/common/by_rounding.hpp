// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A bound on what rounding does to lengths.
#pragma once

namespace geomesh::geomodel {

/// Share of a length by which a few operations on doubles may change it: far more than they do (some 1e-15), far less
/// than any data are accurate.
inline constexpr double by_rounding = 1e-9;

}  // namespace geomesh::geomodel

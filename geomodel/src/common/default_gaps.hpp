// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What gaps between surfaces ask for where the project does not say.
#pragma once

namespace geomesh::geomodel {

/// Elements across a gap, with surfaces within a tolerance: edges are at most two and a half times as long as a layer
/// is thick. A derived size goes without where gaps alone come to too many elements (pipeline/target_elements.hpp).
inline constexpr double default_gap_layers = 0.4;

}  // namespace geomesh::geomodel

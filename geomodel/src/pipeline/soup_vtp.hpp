// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `--stop-after intersect` leaves for viewing.
#pragma once

#include <filesystem>
#include <vector>

#include "geomesh/geomodel/arrangement.hpp"

namespace geomesh::geomodel {

/// Writes STEM.soup.vtp (the facets; cell arrays `surface`, row in field data `surface_names`, `source_triangle` and `n_origins`; point
/// array `kind`: 0 input, 1 intersection, 2 triple point) and STEM.spots.vtp (one vertex a spot; cell arrays `what`, `surface_a`,
/// `surface_b`, `count`, `measure`). Returns what was written.
std::vector<std::filesystem::path> write_soup_vtp(const ArrangementResult& arrangement, const std::vector<TriangulatedSurface>& surfaces,
                                                  const std::filesystem::path& stem);

}  // namespace geomesh::geomodel

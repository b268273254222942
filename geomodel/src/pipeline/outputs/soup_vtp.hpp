// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes what `--stop-after intersect` leaves for viewing.
#pragma once

#include <filesystem>
#include <vector>

#include "geomesh/geomodel/arrangement.hpp"
#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// Writes STEM.soup.vtp (the facets; cell arrays `surface`, which the field array `surface:NAME` holds,
/// `source_triangle` and `n_origins`, for the first origin; field data `origin_offsets` by facet into
/// `origin_surfaces` and `origin_triangles`, for all; point array `kind`: 0 input, 1 intersection, 2 triple point),
/// STEM.soup.curves.vtp (a line for each edge of a curve; cell array `curve`, which the field array `curve:KIND NAME`
/// holds) and STEM.spots.vtp (one vertex a spot; cell arrays `what`, `surface_a`, `surface_b`, `count`, `measure`,
/// `description`). Returns what was written.
std::vector<std::filesystem::path> write_soup_vtp(const ArrangementResult& arrangement, const ModelPlc& plc,
                                                  const std::vector<TriangulatedSurface>& surfaces,
                                                  const std::filesystem::path& stem);

}  // namespace geomesh::geomodel

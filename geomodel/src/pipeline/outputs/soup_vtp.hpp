// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes the polygon soup after intersection for viewing (`--stop-after intersect`).
#pragma once

#include <filesystem>
#include <vector>

#include "geomesh/geomodel/arrangement.hpp"
#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// Writes three files and returns them. STEM.soup.vtp has the facets of the polygon soup. Its cell arrays describe the
/// first origin of each facet: `surface` (the id that the field array `surface:NAME` gives), `source_triangle` and
/// `n_origins`. Its field data list all origins: `origin_offsets` by facet into `origin_surfaces` and
/// `origin_triangles`. Its point array `kind` is 0 for input points, 1 for intersections, 2 for triple points.
/// STEM.soup.curves.vtp has a line for each edge of a curve; its cell array `curve` has the id that the field array
/// `curve:KIND NAME` gives. STEM.spots.vtp has one vertex for each problematic spot, with the cell arrays `what`,
/// `surface_a`, `surface_b`, `count`, `measure` and `description`.
std::vector<std::filesystem::path> write_soup_vtp(const ArrangementResult& arrangement, const ModelPlc& plc,
                                                  const std::vector<TriangulatedSurface>& surfaces,
                                                  const std::filesystem::path& stem);

}  // namespace geomesh::geomodel

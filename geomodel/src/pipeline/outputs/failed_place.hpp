// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes what `--stop-after recover` leaves for viewing if recovery fails.
#pragma once

#include <filesystem>
#include <vector>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// Writes STEM.failed.vtu (the tetrahedra about the place) and STEM.failed.vtp (the constraints there: facets, with
/// cell array `surface`, which the field array `surface:NAME` holds, -1 for segments; segments as lines; the vertices
/// of the items in trouble as points). Cell array `what`: 0 trouble, 1 segment, 2 facet. Returns what was written.
std::vector<std::filesystem::path> write_failed_place(const MeshExcerpt& place, const ModelPlc& model,
                                                      const PolygonSoup& soup,
                                                      const std::vector<TriangulatedSurface>& surfaces,
                                                      const std::filesystem::path& stem);

}  // namespace geomesh::geomodel

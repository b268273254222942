// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes the surroundings of a failed recovery for viewing (`--stop-after recover`).
#pragma once

#include <filesystem>
#include <vector>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// Writes the surroundings of a failed recovery. STEM.failed.vtu has the tetrahedra. STEM.failed.vtp has the
/// constraints: facets, segments as lines, and the vertices of the facets and segments in trouble as points. Its cell
/// array `surface` has the id that the field array `surface:NAME` gives to a surface, -1 for segments; its cell array
/// `what` is 0 for items in trouble, 1 for segments, 2 for facets. Returns the written files.
std::vector<std::filesystem::path> write_failed_place(const MeshExcerpt& place, const ModelPlc& model,
                                                      const PolygonSoup& soup,
                                                      const std::vector<TriangulatedSurface>& surfaces,
                                                      const std::filesystem::path& stem);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Names in VTK files are stored as numbered field arrays. The array `region:chalk` contains the id of the region
/// chalk.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"
#include "writers/vtk_xml.hpp"

namespace geomesh::geomodel {

/// Adds `region:NAME` with the region's id, and `group:NAME` with the ids of a group's regions.
void add_region_fields(const ModelMesh& mesh, std::vector<VtkField>& fields);
/// Adds `surface:NAME` with the surface's id and `surface_kinds` in the order of the names (0 surface, 1 horizon, 2
/// fault, 3 body, 4 box); sets of surfaces as `surface_set_offsets` (one more than sets) into `surface_set_ids`.
void add_surface_fields(const ModelMesh& mesh, std::vector<VtkField>& fields);
/// Adds `curve:NAME` and `point:NAME` with ids, and `curve_kinds` in the order of the curves (0 intersection, 1 border,
/// 2 fault_tip, 3 well, 4 other).
void add_curve_fields(const ModelMesh& mesh, std::vector<VtkField>& fields);
/// Returns an empty vector if nothing was subtracted.
std::vector<double> origin_of(const ModelMesh& mesh);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Stores names in VTK files as numbered field arrays: the array `region:chalk` contains the id of the region chalk.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"
#include "writers/vtk_xml.hpp"

namespace geomesh::geomodel {

/// Adds field arrays with the names of regions: `region:NAME` with the id of the region, and `group:NAME` with the ids
/// of the regions of a group.
void add_region_fields(const ModelMesh& mesh, std::vector<VtkField>& fields);
/// Adds field arrays with the names of surfaces: `surface:NAME` with the id of the surface, and `surface_kinds` in the
/// order of the names (0 surface, 1 horizon, 2 fault, 3 body, 4 box). Sets of surfaces are lists in `surface_set_ids`;
/// `surface_set_offsets` has their ends, beginning with 0.
void add_surface_fields(const ModelMesh& mesh, std::vector<VtkField>& fields);
/// Adds field arrays with the names of curves and points: `curve:NAME` and `point:NAME` with ids, and `curve_kinds` in
/// the order of the curves (0 intersection, 1 border, 2 fault_tip, 3 well, 4 other).
void add_curve_fields(const ModelMesh& mesh, std::vector<VtkField>& fields);
/// Returns the origin that was subtracted from the coordinates of a mesh; an empty vector if none was.
std::vector<double> origin_of(const ModelMesh& mesh);

}  // namespace geomesh::geomodel

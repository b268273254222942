// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks the names and ids of regions against the project's seeds, bodies and column.
#pragma once

#include "check/mesh/checked_faces.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {

/// Checks that every region has the name that the project gives it (`wrong_region_names`), the suffix that follows from
/// its position (`wrong_name_suffixes`) and the id that follows from name and position (`wrong_region_ids`), and that
/// names in the mesh and in the files beside it are equal (`names_differ`). Seeds are located exactly, bodies by
/// winding numbers at points inside the region, units of the column by the mesh faces that bound the region and by
/// vertical lines. `allowed` limits the distance of mesh faces from their input triangles.
void check_region_names(const CheckedFaces& checked, const Allowed& allowed, CheckResult& result);

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks the names and ids of regions against the project's seeds, bodies and column.
#pragma once

#include "check/mesh/checked_faces.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {

/// Checks that every region has the name that the project gives it (`wrong_region_names`), the suffix that follows from
/// its place (`wrong_name_suffixes`) and the id that follows from name and place (`wrong_region_ids`), and that names
/// in the mesh and in the files beside it are equal (`names_differ`). Seeds are located exactly, bodies by winding
/// numbers of places inside the region, the column by the faces at the region and by verticals. `allowed` is how far
/// faces may be from their triangles.
void check_region_names(const CheckedFaces& checked, const Allowed& allowed, CheckResult& result);

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The names and ids of regions against the project's seeds, bodies and column.
#pragma once

#include "check/judged/claimed_faces.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {

/// Every region bears the name that the project gives it (`wrong_region_names`). It has the suffix that its place
/// gives it (`wrong_name_suffixes`) and the id that name and place give it (`wrong_region_ids`); names are the same in
/// the mesh and beside it (`names_differ`). Seeds are located exactly, bodies by winding numbers of places inside the
/// region, the column by the faces at the region and by verticals. `allowed`: how far faces may be off their triangles.
void check_region_names(const ClaimedFaces& claimed, const Allowed& allowed, CheckResult& result);

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks fault zones in the mesh, then closes (collapses) them, so that the result is checked like any mesh.
#pragma once

#include <optional>
#include <vector>

#include "check/mesh/checked_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel::checking {

/// The files of a mesh without its fault zones: the zones' elements, their plus walls and their faces on sides of the
/// model are removed. Points are at the positions in the array `before_zones`; names and ids are those of a mesh that
/// never had zones. If the array is wrong, the result does not pass the checks against the project.
struct ClosedFiles {
  MeshFile mesh;
  FacesFile faces;
  std::optional<CurvesFile> curves;
};

/// Removes a mesh's fault zones. Returns nothing if the files lack data, which is reported as `wrong_fault_zones`.
std::optional<ClosedFiles> close_zones(const CheckedMesh& mesh, const FacesFile& faces, const CurvesFile* curves,
                                       const std::vector<FaultZone>& zones, CheckResult& result);

/// Checks that each fault zone is a region with the fault's name between its two walls (`wrong_fault_zones`). Between
/// facing nodes of the walls there are as many elements as the project requests. The distance between the walls is the
/// requested thickness: at each face within a factor of two (because of bends and oblique surfaces), and for the whole
/// zone, as volume divided by area, within an eighth.
void check_zones(const CheckedMesh& mesh, const FacesFile& faces, const std::vector<FaultZone>& zones,
                 CheckResult& result);

}  // namespace geomesh::geomodel::checking

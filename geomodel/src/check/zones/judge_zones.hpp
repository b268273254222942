// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fault zones: judged as they stand, then closed, so that what is left is judged against the project like any mesh.
#pragma once

#include <optional>
#include <vector>

#include "check/judged/judged_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel::checking {

/// The files of a mesh without its zones. Their elements, their plus walls and their faces on sides of the model are
/// gone. Points are where the array `before_zones` tells; names and ids are those of a mesh that never had zones.
/// Nothing of the array is believed: where it is wrong, what comes out is no mesh of the project.
struct ClosedFiles {
  MeshFile mesh;
  FacesFile faces;
  std::optional<CurvesFile> curves;
};

/// Nothing where the files do not tell enough: `wrong_fault_zones` is reported then.
std::optional<ClosedFiles> close_zones(const JudgedMesh& mesh, const FacesFile& faces, const CurvesFile* curves,
                                       const std::vector<FaultZone>& zones, CheckResult& result);

/// Each zone is a region of the fault's name between its two walls. Between nodes that face each other there are as
/// many elements as the project asks. Walls are apart as it asks: by face within a factor of two (bends and slanting
/// surfaces), in the whole zone, as its volume over its area, within an eighth (`wrong_fault_zones`).
void check_zones(const JudgedMesh& mesh, const FacesFile& faces, const std::vector<FaultZone>& zones,
                 CheckResult& result);

}  // namespace geomesh::geomodel::checking

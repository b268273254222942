// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Split faults: the doubling is judged as it stands, then undone, so that what is left is judged like any mesh.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/judged/judged_mesh.hpp"

namespace geomesh::geomodel::checking {

/// What a project asks of the two sides.
struct AskedSplits {
  std::vector<std::string> surfaces;
  bool cohesive = false;  ///< a prism between the two sides of each face, but where all its nodes are at a tip
};

/// The files of a mesh as they would be without `split`. Points in one place are one, the first of them. Faces of
/// NAME.plus are gone, those of NAME.minus bear NAME, and have the regions of both sides. So have curves.
struct JoinedFiles {
  MeshFile mesh;
  FacesFile faces;
  std::optional<CurvesFile> curves;
};

/// Undoes the doubling, and judges it (`wrong_splits`): each face of a minus side has one of the plus side in its
/// place; both are on the boundary, with normals out of their own side; about each point there are as many nodes as
/// sectors that the split faces divide, one a sector; cohesive prisms are the pairs of faces with a node of two.
/// Nothing where the files do not tell enough: `wrong_splits` is reported then. Precondition: coordinates are finite.
/// O(n log n).
std::optional<JoinedFiles> join_splits(const MeshFile& mesh, const FacesFile& faces,
                                       const std::optional<CurvesFile>& curves, const AskedSplits& asked,
                                       CheckResult& result);

}  // namespace geomesh::geomodel::checking

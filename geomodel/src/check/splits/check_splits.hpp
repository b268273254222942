// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks the duplicated nodes of split faults as they are, then merges these nodes, so that the result is checked like
/// any mesh.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/mesh/checked_mesh.hpp"

namespace geomesh::geomodel::checking {

struct AskedSplits {
  std::vector<std::string> surfaces;
  /// Whether there is a cohesive prism between the two sides of each face. A face with all nodes at a fault tip has
  /// none.
  bool cohesive = false;
};

/// The files of a mesh as they would be without `split`. Points with equal coordinates are merged into the first of
/// them. Faces of NAME.plus are removed; those of NAME.minus are called NAME and have the regions of both sides. The
/// same applies to curves.
struct JoinedFiles {
  MeshFile mesh;
  FacesFile faces;
  std::optional<CurvesFile> curves;
};

/// Merges the duplicated nodes of split faults and checks them (`wrong_splits`): each face of a minus side coincides
/// with one of the plus side; both are on the boundary of their side, with normals out of their own side; at each point
/// there is one node for each sector of tetrahedra between the split faces; cohesive prisms connect the pairs of faces
/// that differ in a node. Returns nothing if the files lack data, which is reported as `wrong_splits`. Precondition:
/// coordinates are finite. O(n log n).
std::optional<JoinedFiles> join_splits(const MeshFile& mesh, const FacesFile& faces,
                                       const std::optional<CurvesFile>& curves, const AskedSplits& asked,
                                       CheckResult& result);

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Split faults: checks the duplicated nodes as they are, then merges them, so that the result is checked like any
/// mesh.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/mesh/checked_mesh.hpp"

namespace geomesh::geomodel::checking {

/// A project's requests for the two sides of split faults.
struct AskedSplits {
  std::vector<std::string> surfaces;
  /// Whether there is a prism between the two sides of each face, except if all its nodes are at a tip.
  bool cohesive = false;
};

/// The files of a mesh as they would be without `split`. Points at one place are merged into the first of them. Faces
/// of NAME.plus are removed; those of NAME.minus are called NAME and have the regions of both sides. The same applies
/// to curves.
struct JoinedFiles {
  MeshFile mesh;
  FacesFile faces;
  std::optional<CurvesFile> curves;
};

/// Merges the duplicated nodes and checks them (`wrong_splits`): each face of a minus side has one of the plus side at
/// the same place; both are on the boundary, with normals out of their own side; around each point there are as many
/// nodes as sectors between the split faces, one for each sector; cohesive prisms connect the pairs of faces that
/// differ in a node. Returns nothing if the files lack data, which is reported as `wrong_splits`. Precondition:
/// coordinates are finite. O(n log n).
std::optional<JoinedFiles> join_splits(const MeshFile& mesh, const FacesFile& faces,
                                       const std::optional<CurvesFile>& curves, const AskedSplits& asked,
                                       CheckResult& result);

}  // namespace geomesh::geomodel::checking

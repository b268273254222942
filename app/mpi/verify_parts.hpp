// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What is promised of the mesh of all ranks, proven before anything is written.
#pragma once

#include <vector>

#include "mesh_faces.hpp"
#include "ranks.hpp"

namespace geomesh::app {

/// Of all ranks together.
struct VerifiedParts {
  std::size_t n_tetrahedra = 0;
  std::size_t n_faces_between_ranks = 0;  ///< matched bit by bit
  std::vector<double> volume_of_region;   ///< by region id - 1
};

/// Every tetrahedron is exactly positive. Every face is on the outside of the model, or has a tetrahedron on each side.
/// Where these are of two ranks its places are the same bit by bit. Regions meet at faces of the model alone, each of
/// which is there once on each of its sides; every edge of a curve is there. Volumes of regions are those of the
/// sparse mesh, which has the same surfaces. Throws InternalError on any rank where one of these does not hold.
VerifiedParts verify_parts(const RankModel& model, const RankMesh& mesh, const MeshFaces& faces, const Ranks& ranks);

}  // namespace geomesh::app

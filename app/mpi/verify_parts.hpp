// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Verifies the guarantees for the mesh of all ranks before anything is written.
#pragma once

#include <vector>

#include "mesh_faces.hpp"
#include "ranks.hpp"

namespace geomesh::app {

/// Counts and volumes of the verified mesh, summed over all ranks.
struct VerifiedParts {
  std::size_t n_tetrahedra = 0;
  std::size_t n_faces_between_ranks = 0;  ///< faces with tetrahedra on two ranks, which have equal coordinates
  std::vector<double> volume_of_region;   ///< volume of each region, by region id - 1
};

/// Verifies the following. Every tetrahedron is exactly positive. Every face is on the outside of the model, or has a
/// tetrahedron on each side. If these tetrahedra are on two ranks, the coordinates of the face are equal bit by bit.
/// Regions meet only at faces of the model, each of which exists once on each of its sides; every edge of a curve
/// exists. Volumes of regions are those of the sparse mesh, which has the same surfaces. Throws InternalError on any
/// rank where one of these conditions is violated.
VerifiedParts verify_parts(const RankModel& model, const RankMesh& mesh, const MeshFaces& faces, const Ranks& ranks);

}  // namespace geomesh::app

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The part of a rank as files have it: with global numbers, ghosts, and what of the model it is.
#pragma once

#include "part.hpp"
#include "partition/mesh_parts.hpp"
#include "ranks.hpp"
#include "shared_points.hpp"

namespace geomesh::app {

/// A part with ghosts. `mesh`: points of the model first, all of them, then its own and those of ghosts; its own
/// tetrahedra, then ghosts. Regions, faces, curves are those of the whole model.
struct NumberedPart {
  geomodel::ModelMesh mesh;
  geomodel::GivenPart part;
  std::size_t n_own = 0;
};

/// Numbers: points of the model in their order, then those of rank 0, 1 ... which own what they share with higher
/// ranks. Tetrahedra by region, and within one by rank.
NumberedPart number_part(const RankModel& model, const RankMesh& mesh, const MeshFaces& faces, const Ranks& ranks);

}  // namespace geomesh::app

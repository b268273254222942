// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The part of a rank in the form needed for files: with global numbers, ghosts, and its relation to the model.
#pragma once

#include "part.hpp"
#include "partition/mesh_parts.hpp"
#include "ranks.hpp"
#include "shared_points.hpp"

namespace geomesh::app {

/// A part with ghosts. `mesh` contains all points of the model first, followed by the part's own and those of ghosts;
/// its own tetrahedra, followed by ghosts. Regions, faces and curves are those of the whole model.
struct NumberedPart {
  geomodel::ModelMesh mesh;
  geomodel::GivenPart part;
  std::size_t n_own = 0;
};

/// Assigns numbers: points of the model in their order, followed by those of rank 0, 1 ... which own the points that
/// they share with higher ranks; tetrahedra by region, and within one by rank.
NumberedPart number_part(const RankModel& model, const RankMesh& mesh, const MeshFaces& faces, const Ranks& ranks);

}  // namespace geomesh::app

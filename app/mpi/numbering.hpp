// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The part of a rank in the form needed for files: with global numbers, ghosts, and its relation to the model.
#pragma once

#include "part.hpp"
#include "partition/mesh_parts.hpp"
#include "ranks.hpp"
#include "shared_points.hpp"

namespace geomesh::app {

/// A part with ghosts. `mesh` contains all points of the model, followed by the part's own points and those of ghosts,
/// and the part's own tetrahedra, followed by ghosts. Regions, faces and curves are those of the whole model.
struct NumberedPart {
  geomodel::ModelMesh mesh;
  geomodel::GivenPart part;
  std::size_t n_own = 0;
};

/// Assigns global numbers. Points of the model come first in their order, followed by those of rank 0, rank 1 and so
/// on; a shared point belongs to the lowest of its ranks. Tetrahedra are numbered by region, then by rank.
NumberedPart number_part(const RankModel& model, const RankMesh& mesh, const MeshFaces& faces, const Ranks& ranks);

}  // namespace geomesh::app

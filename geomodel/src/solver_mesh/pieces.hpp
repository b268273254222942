// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Divides the faces on surfaces and the edges of curves into pieces, so that each face and each edge belongs to only
/// one group.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// All mesh faces that lie on the same surfaces and separate the same two regions.
struct FacePiece {
  std::int32_t id;  ///< id of the surface if this piece of it is the whole surface, else a new id
  std::int32_t surface_set, region_minus, region_plus;
  /// Names of the surfaces of this piece, joined by `+`; if they have several pieces, followed by `/` and the regions.
  std::string full_name;
  std::vector<std::size_t> faces;
};

/// All mesh edges that lie on the same set of curves.
struct CurvePiece {
  std::int32_t id;
  std::vector<std::int32_t> curves;
  std::string full_name;
  std::vector<std::size_t> edges;  ///< rows of the edges in curve_edges; each mesh edge occurs once
};

struct SolverPieces {
  std::vector<FacePiece> faces;
  std::vector<CurvePiece> curves;
};
/// Divides the faces on surfaces and the edges of curves into pieces. New ids follow the largest id of the mesh.
SolverPieces make_pieces(const ModelMesh& mesh);

/// Returns the largest id of a region, surface, curve, point or set.
std::int32_t largest_id(const ModelMesh& mesh);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Divides faces and edges of curves into pieces, so that each belongs to only one group.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Faces with the same surfaces and the same regions on both sides.
struct FacePiece {
  std::int32_t id;  ///< id of the surface if this is its only piece, else a new one
  std::int32_t surface_set, region_minus, region_plus;
  /// Names of the surfaces joined by `+`; if a surface has several pieces, followed by `/` and the regions.
  std::string full_name;
  std::vector<std::size_t> faces;
};

/// Edges that lie on the same curves.
struct CurvePiece {
  std::int32_t id;
  std::vector<std::int32_t> curves;
  std::string full_name;
  std::vector<std::size_t> edges;  ///< rows of curve_edges, each mesh edge once
};

struct SolverPieces {
  std::vector<FacePiece> faces;
  std::vector<CurvePiece> curves;
};
/// Ids of new pieces follow the largest id of the mesh.
SolverPieces make_pieces(const ModelMesh& mesh);

/// Returns the largest id of a region, surface, curve, point or set.
std::int32_t largest_id(const ModelMesh& mesh);

}  // namespace geomesh::geomodel

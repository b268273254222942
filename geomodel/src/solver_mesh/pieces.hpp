// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Pieces by which each face and each edge of a curve is in one group alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Faces with the same surfaces and the same regions on both sides.
struct FacePiece {
  std::int32_t id;  ///< that of the surface where it is the surface's only piece, else a new one
  std::int32_t surface_set, region_minus, region_plus;
  std::string full_name;  ///< surfaces joined by `+`; where a surface has several pieces, `/` and the regions
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

/// The largest id of a region, surface, curve, point or set.
std::int32_t largest_id(const ModelMesh& mesh);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Names and groups for solver files: sanitised names, and the pieces by which each face and curve edge is in one group
/// alone.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

inline constexpr std::size_t max_solver_name = 24;

/// Hands out names that match [A-Za-z][A-Za-z0-9_.-]*, have at most 24 characters and differ even where case is
/// ignored. A name that had to be shortened or is taken gets a number at its end.
class SolverNames {
 public:
  std::string give(const std::string& full_name);

 private:
  std::set<std::string> taken_;  // in lower case
};

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

struct SolverGroups {
  std::vector<FacePiece> faces;
  std::vector<CurvePiece> curves;
};
/// Ids of new pieces follow the largest id of the mesh.
SolverGroups make_groups(const ModelMesh& mesh);

}  // namespace geomesh::geomodel

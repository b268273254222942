// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A plane section of a mesh for viewing, computed in floating point and never used for decisions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel::page {

/// The intersection of a mesh with the plane `axis = at` (axis 0, 1, 2 for x, y, z). Points have the plane's two
/// coordinates: (y, z), (x, z) or (x, y).
struct Section {
  std::size_t axis = 0;
  double at = 0;
  struct Cut {
    std::int32_t region;
    std::vector<Vec2> polygon;  ///< corners of the polygon in which the plane cuts a tetrahedron, in order around it
  };
  std::vector<Cut> cuts;  ///< polygons in which the plane cuts tetrahedra, in the order of the tetrahedra
  struct Trace {
    std::int32_t surface;
    Vec2 a, b;
  };
  std::vector<Trace> traces;  ///< lines in which the plane cuts mesh faces of surfaces, in the order of the faces
};

/// Cuts all tetrahedra and faces of the mesh by a plane. A vertex on the plane counts as above it, so each cut has
/// three or four corners, some of which may coincide. Time is linear in the mesh.
Section cut_mesh(const ModelMesh& mesh, std::size_t axis, double at);

}  // namespace geomesh::geomodel::page

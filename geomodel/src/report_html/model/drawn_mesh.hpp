// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The mesh as pictures draw it: whole, or made coarser where a browser could not turn it.
#pragma once

#include <cstdint>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel::page {

/// What a browser turns smoothly, and a page can carry.
struct DrawingLimits {
  std::size_t faces = 300'000, tetrahedra = 200'000;
};

/// Rows of what is drawn, and at which vertex each corner is drawn.
struct DrawnMesh {
  std::vector<VertexIndex> corner;   ///< by row of ModelMesh::points: the vertex that stands for it
  std::vector<std::uint32_t> faces;  ///< rows of ModelMesh::faces
  std::vector<std::uint32_t> cells;  ///< rows of ModelMesh::tetrahedra
  bool is_whole = true;              ///< nothing was left out
};

/// All of the mesh within the limits. Beyond them the vertices in each cell of a grid become one of them (Rossignac and
/// Borrel 1993), with the finest grid that fits. A vertex on the box's sides stands for those inside, and one on
/// several surfaces for those on fewer: so outlines and lines between units stay. What loses a corner is left out. For
/// looking at: thin elements may turn round. Heights count `stretch` times. Time linear in the mesh.
DrawnMesh drawn_mesh(const ModelMesh& mesh, double stretch, const DrawingLimits& limits = {});

/// Where the two upright walls of the picture's open corner meet, in x and y: the middle of the box, or that of the
/// largest unit that reaches no side and that walls through the middle would not cut.
Vec2 open_corner(const ModelMesh& mesh, const Box3& bounds);

}  // namespace geomesh::geomodel::page

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The mesh as pictures draw it: whole, or coarsened if a browser could not rotate it.
#pragma once

#include <cstdint>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel::page {

/// Limits of what a browser rotates smoothly, and of the size of a page.
struct DrawingLimits {
  std::size_t faces = 300'000, tetrahedra = 200'000;
};

/// Rows of what is drawn, and the vertex at which each corner is drawn.
struct DrawnMesh {
  std::vector<VertexIndex> corner;   ///< by row of ModelMesh::points: the vertex that represents it
  std::vector<std::uint32_t> faces;  ///< rows of ModelMesh::faces
  std::vector<std::uint32_t> cells;  ///< rows of ModelMesh::tetrahedra
  bool is_whole = true;              ///< whether nothing was left out
};

/// Returns all of the mesh if it is within the limits. Otherwise the vertices in each cell of a grid are replaced by
/// one of them (Rossignac and Borrel 1993), with the finest grid that fits. A vertex on the box's sides represents
/// those inside, and one on several surfaces those on fewer, so that outlines and lines between units are kept. Cells
/// and faces that lose a corner are left out. Only for viewing: thin elements may be inverted. Heights are multiplied
/// by `stretch`. Time linear in the mesh.
DrawnMesh drawn_mesh(const ModelMesh& mesh, double stretch, const DrawingLimits& limits = {});

/// Returns the x and y at which the two vertical walls of the picture's open corner meet: the centre of the box, or
/// that of the largest unit that reaches no side and that walls through the centre would not cut.
Vec2 open_corner(const ModelMesh& mesh, const Box3& bounds);

}  // namespace geomesh::geomodel::page

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Prepares the mesh for pictures: the whole mesh, or a coarsened one if a browser could not rotate the whole.
#pragma once

#include <cstdint>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel::page {

/// Limits on the drawn mesh, so that a browser can rotate it smoothly and the HTML file remains small.
struct DrawingLimits {
  std::size_t faces = 300'000, tetrahedra = 200'000;
};

/// The cells and faces of a mesh that are drawn, and the vertex at which each corner is drawn.
struct DrawnMesh {
  std::vector<VertexIndex> corner;   ///< for each mesh point, the point that is drawn in its place
  std::vector<std::uint32_t> faces;  ///< rows of ModelMesh::faces
  std::vector<std::uint32_t> cells;  ///< rows of ModelMesh::tetrahedra
  bool is_whole = true;              ///< whether all of the mesh is drawn
};

/// Returns all of the mesh if it is within the limits. Otherwise the vertices in each cell of a grid are replaced by
/// one of them (Rossignac and Borrel 1993), with the finest grid that fits. Vertices on the box's sides are preferred
/// to those inside, and vertices on several surfaces to those on fewer, so that outlines and lines between units are
/// kept. Cells and faces that lose a corner are left out. The result is only for viewing, because thin elements may be
/// inverted. Heights are multiplied by `stretch`. Time is linear in the mesh.
DrawnMesh drawn_mesh(const ModelMesh& mesh, double stretch, const DrawingLimits& limits = {});

/// Returns the x and y at which the two vertical walls of the picture's open corner meet: the centre of the box, or
/// that of the largest unit that reaches no side and that walls through the centre would not cut.
Vec2 open_corner(const ModelMesh& mesh, const Box3& bounds);

}  // namespace geomesh::geomodel::page

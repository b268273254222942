// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Computes finite volumes around the points of a mesh: the cells of its Voronoi dual.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

struct ControlVolumes {
  std::vector<double> volume;  ///< volume of the Voronoi cell around each point; their sum is the volume of the mesh
  std::vector<std::int32_t> region;  ///< for each point: the region with the largest share of its Voronoi cell
  struct Connection {
    VertexIndex a, b;
    double area;  ///< area of the face between the Voronoi cells of a and b, perpendicular to edge ab at its midpoint
  };
  /// Pairs of Voronoi cells whose common face has an area above zero. A deque grows without copying its entries.
  std::deque<Connection> connections;
  std::size_t n_negative_areas = 0;  ///< number of Voronoi faces omitted at the boundary, with circumcentres beyond it
};

/// Computes the Voronoi cells around the points of a mesh. Two-point fluxes between the cells are consistent only in a
/// Delaunay mesh. Throws Error{cannot_mesh} with the place and advice if a vertex lies strictly inside the circumsphere
/// of a neighbouring tetrahedron, decided exactly, or if a cell would have no volume.
ControlVolumes control_volumes(const ModelMesh& mesh);

/// Share of one point in the outer area of a surface, to which boundary conditions apply: a third of the area of each
/// face at the point.
struct BoundaryShare {
  VertexIndex point;
  double area;
};
std::vector<BoundaryShare> boundary_shares(const ModelMesh& mesh, std::int32_t surface);

}  // namespace geomesh::geomodel

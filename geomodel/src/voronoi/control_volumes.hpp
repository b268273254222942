// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finite volumes around the points of a mesh: the cells of its Voronoi dual.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

struct ControlVolumes {
  std::vector<double> volume;        ///< volume by point; their sum is the volume of the mesh
  std::vector<std::int32_t> region;  ///< for each point: the region with the largest share of its cell
  struct Connection {
    VertexIndex a, b;
    double area;  ///< area of the face between the cells, which is perpendicular to the edge at its midpoint
  };
  /// Connections with an area above zero; a deque, because it does not copy as it grows.
  std::deque<Connection> connections;
  std::size_t n_negative_areas = 0;  ///< number of faces omitted at the boundary, because circumcentres lie beyond it
};

/// Fluxes between two cells along their edge are consistent only in a Delaunay mesh. Throws Error{cannot_mesh} with the
/// place and what to do if a vertex lies strictly inside the circumsphere of a neighbouring tetrahedron, decided
/// exactly, or if a cell would have no volume.
ControlVolumes control_volumes(const ModelMesh& mesh);

/// Share of a surface's outer area that belongs to each point, a third of each of its faces; boundary conditions apply
/// there.
struct BoundaryShare {
  VertexIndex point;
  double area;
};
std::vector<BoundaryShare> boundary_shares(const ModelMesh& mesh, std::int32_t surface);

}  // namespace geomesh::geomodel

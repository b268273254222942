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
  std::vector<double> volume;        ///< by point; together the volume of the mesh
  std::vector<std::int32_t> region;  ///< by point: the one with the largest share of its cell
  struct Connection {
    VertexIndex a, b;
    double area;  ///< of the face between the cells, which is perpendicular to the edge at its middle
  };
  std::deque<Connection> connections;  ///< those with an area above zero; a deque, because it does not copy as it grows
  std::size_t n_negative_areas = 0;    ///< faces left out at the boundary, where circumcentres lie beyond it
};

/// Fluxes between two cells along their edge are consistent only in a Delaunay mesh. Throws Error{cannot_mesh} with the
/// place and what to do if a vertex lies strictly inside the circumsphere of a neighbouring tetrahedron, decided
/// exactly, or if a cell would have no volume.
ControlVolumes control_volumes(const ModelMesh& mesh);

/// Share of a surface's outer area that each point has, a third of each of its faces: where boundary conditions apply.
struct BoundaryShare {
  VertexIndex point;
  double area;
};
std::vector<BoundaryShare> boundary_shares(const ModelMesh& mesh, std::int32_t surface);

}  // namespace geomesh::geomodel

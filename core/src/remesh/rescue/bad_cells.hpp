// SPDX-License-Identifier: MIT
/// @file
/// Lists of cells of poor shape, as they were when they were listed.
#pragma once

#include <vector>

#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

struct BadCell {
  double shape;
  CellIndex cell;
  Tetrahedron vertices;
};

/// The worst first.
std::vector<BadCell> cells_below(const DomainMesh& mesh, double limit);
BadCell bad_cell(const DomainMesh& mesh, CellIndex c);

/// Whether it is there still; a vertex may have moved.
bool is_left(const DomainMesh& mesh, const BadCell& b);
/// Whether something about one of its vertices has changed since that moment of the mesh.
bool changed_since(const DomainMesh& mesh, const BadCell& b, std::uint64_t time);

}  // namespace geomesh::remesh

// SPDX-License-Identifier: MIT
/// @file
/// Which bad cells nothing of the input forces: what the search for better cells asks.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// Tells the bad cells that nothing of the input forces.
struct FreeCellJudge {
  std::function<std::vector<CellIndex>(const DomainMesh&)> find;
  /// Those of some cells that are such, the worst first, by what is near to them: quick, and in doubt they are.
  std::function<std::vector<CellIndex>(const DomainMesh&, std::span<const CellIndex>)> find_among;
};

}  // namespace geomesh::remesh

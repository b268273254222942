// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Describes in an Exodus file of one part its relation to other parts: the arrays of Nemesis.
#pragma once

#include <array>
#include <cstddef>

#include "formats/exodus/netcdf_writer.hpp"
#include "partition/solver_part.hpp"

namespace geomesh::geomodel {

/// Side of a tetrahedron by its opposite vertex: 1 = (1 2 4), 2 = (2 3 4), 3 = (1 4 3), 4 = (1 3 2).
inline constexpr std::array<int, 4> exodus_side_opposite{2, 3, 1, 4};

/// A part, together with the mesh to which it belongs.
struct ExodusPart {
  const SolverMesh& whole;
  const MeshParts& parts;
  const SolverPart& part;
};

/// Numbers of sets in each file; they are the same in all parts.
struct ExodusSets {
  std::size_t sides, nodes;
};

/// Adds the numbers in the whole mesh, and what is shared with which other part. The file's dimensions of nodes and
/// elements must have been added before. Parallel readers use these to combine parts (Hennigan and Shadid, "NEMESIS I",
/// SAND 98-2649).
void add_exodus_part(NetcdfWriter& file, const ExodusPart& part, const ExodusSets& sets);

}  // namespace geomesh::geomodel

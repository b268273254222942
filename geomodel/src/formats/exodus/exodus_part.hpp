// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Describes in the Exodus file of one part how it is connected to other parts, by the arrays of Nemesis.
#pragma once

#include <array>
#include <cstddef>

#include "formats/exodus/netcdf_writer.hpp"
#include "partition/solver_part.hpp"

namespace geomesh::geomodel {

/// Side of an Exodus tetrahedron opposite each vertex: 1 = (1 2 4), 2 = (2 3 4), 3 = (1 4 3), 4 = (1 3 2).
inline constexpr std::array<int, 4> exodus_side_opposite{2, 3, 1, 4};

struct ExodusPart {
  const SolverMesh& whole;
  const MeshParts& parts;
  const SolverPart& part;
};

/// Number of side sets and node sets in an Exodus file, which is the same in the files of all parts of a mesh.
struct ExodusSets {
  std::size_t sides, nodes;
};

/// Adds to the Exodus file of one mesh part the numbers of its nodes and elements in the whole mesh, and which of them
/// it shares with which other part. Parallel readers use these arrays to combine parts (Hennigan and Shadid, "NEMESIS
/// I", SAND 98-2649). The file's dimensions of nodes and elements must have been added before.
void add_exodus_part(NetcdfWriter& file, const ExodusPart& part, const ExodusSets& sets);

}  // namespace geomesh::geomodel

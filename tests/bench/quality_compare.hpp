// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Element shapes beside TetGen and gmsh on the same surfaces with as many tetrahedra.
#pragma once

#include <string>

namespace geomesh::bench {

struct CompareOptions {
  double peer_limit_s = 120, own_limit_s = 120;  ///< of processor time, a run
  std::string only;                              ///< models whose names contain this; empty: all
};

/// Prints a table of runs and one of verdicts. For each peer our number of tetrahedra is brought within a tenth of the
/// peer's by the size that is asked; the time is that of the run that met it.
void compare_peers(const CompareOptions& options);

}  // namespace geomesh::bench

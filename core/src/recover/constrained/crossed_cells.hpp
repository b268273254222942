// SPDX-License-Identifier: MIT
/// @file
/// Which cells go where a Steiner point is put on a missing segment.
#pragma once

#include <vector>

#include "recover/model/crossing.hpp"
#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// The cells of the simplex crossed: two of a face, all of an edge.
std::vector<CellIndex> crossed_cells(const ConstrainedMesh& mesh, const Crossing& c);

/// The crossings of a missing subsegment, with their parameters on it.
struct CrossingsOnLine {
  LineCrossings line;
  std::vector<double> parameters;
  double length = 0;
};

/// The cells of crossing i and of what the point x there would have beside it at the distance of a rounding error:
/// other crossings, and edges of the face crossed. Were they left, the next crossing would be an ulp from x.
std::vector<CellIndex> cells_near_crossing(const ConstrainedMesh& mesh, const CrossingsOnLine& on, std::size_t i,
                                           const Vec3& x);

/// Square of the distance to the nearest of the segment's ends and of the vertices of the simplex crossed.
double clearance(const ConstrainedMesh& mesh, const Crossing& c, const Vec3& x, const Vec3& a, const Vec3& b);

/// Ends the attempt where another segment is crossed. True: it has.
bool ends_at_crossed_segment(Recovery& recovery, Index subsegment, const LineCrossings& line);

}  // namespace geomesh::recover

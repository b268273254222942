// SPDX-License-Identifier: MIT
/// @file
/// Determines which cells are removed when a Steiner point is added on a missing segment.
#pragma once

#include <vector>

#include "recover/model/crossing.hpp"
#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// Returns the cells of the crossed simplex: two for a face, all around an edge.
std::vector<CellIndex> crossed_cells(const ConstrainedMesh& mesh, const Crossing& c);

/// The crossings of a missing subsegment, with their parameters on it.
struct CrossingsOnLine {
  LineCrossings line;
  std::vector<double> parameters;
  double length = 0;
};

/// Returns the cells of crossing i, and those of items that would be at the distance of a rounding error from a point x
/// there: other crossings, and edges of the crossed face. If they were kept, the next crossing would be an ulp from x.
std::vector<CellIndex> cells_near_crossing(const ConstrainedMesh& mesh, const CrossingsOnLine& on, std::size_t i,
                                           const Vec3& x);

/// Returns the squared distance to the nearest of the segment's ends and of the vertices of the crossed simplex.
double clearance(const ConstrainedMesh& mesh, const Crossing& c, const Vec3& x, const Vec3& a, const Vec3& b);

/// Ends the attempt if another segment is crossed; returns whether it has.
bool ends_at_crossed_segment(Recovery& recovery, Index subsegment, const LineCrossings& line);

}  // namespace geomesh::recover

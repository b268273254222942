// SPDX-License-Identifier: MIT
/// @file
/// Determines which cells are removed when a Steiner point is added on a missing segment.
#pragma once

#include <vector>

#include "recover/model/crossing.hpp"
#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// Returns the cells at a mesh face or edge that a line crosses: two cells at a face, or all cells around an edge.
std::vector<CellIndex> crossed_cells(const ConstrainedMesh& mesh, const Crossing& c);

/// The mesh edges and faces that a missing subsegment crosses, and the parameters of the crossings on the subsegment.
struct CrossingsOnLine {
  LineCrossings line;
  std::vector<double> parameters;
  double length = 0;
};

/// Returns the cells at crossing i, and the cells at other crossings and at edges of the crossed face that are within a
/// rounding error of a point x at the crossing. If they were kept, the next crossing would be an ulp from x.
std::vector<CellIndex> cells_near_crossing(const ConstrainedMesh& mesh, const CrossingsOnLine& on, std::size_t i,
                                           const Vec3& x);

/// Returns the squared distance of x from the nearest of the segment's ends and the vertices of the crossed simplex.
double clearance(const ConstrainedMesh& mesh, const Crossing& c, const Vec3& x, const Vec3& a, const Vec3& b);

/// Ends the attempt at recovery if the subsegment crosses another segment; returns whether it does.
bool ends_at_crossed_segment(Recovery& recovery, Index subsegment, const LineCrossings& line);

}  // namespace geomesh::recover

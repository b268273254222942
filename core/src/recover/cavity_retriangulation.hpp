// SPDX-License-Identifier: MIT
/// @file
/// Recovery without points by emptying a cavity and filling it again with the constraint as a sheet in it (the cavities of Shewchuk 2002
/// and of Si and Gaertner 2011, filled by search instead of by gift wrapping, as the mesh is not Delaunay any more).
#pragma once

#include "recover/polyhedron_filling.hpp"
#include "recover/recover.hpp"

namespace geomesh::recover {

/// Cells to be emptied, with their boundary; none where a vertex, a subsegment or a locked face lies inside.
struct Cavity {
  std::vector<CellIndex> cells;
  std::vector<Triangle> boundary;  ///< counter-clockwise seen from inside
};
std::optional<Cavity> make_cavity(const Recovery& recovery, std::vector<CellIndex> cells);

/// Makes a-b an edge as the border of a triangle a,b,c over a vertex c that is joined with both already.
bool recover_segment_by_cavity(Recovery& recovery, VertexIndex a, VertexIndex b, std::size_t max_nodes);

/// Makes the triangle a face, given the cells that edges piercing it have. Its edges are present.
bool recover_face_by_cavity(Recovery& recovery, const Triangle& t, std::vector<CellIndex> pierced, std::size_t max_nodes);

}  // namespace geomesh::recover

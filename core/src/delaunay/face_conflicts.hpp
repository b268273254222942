// SPDX-License-Identifier: MIT
/// @file
/// The filter of in-sphere for all four neighbours of a cavity cell at once.
#pragma once

#include "delaunay/point_record.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// in_sphere of the four neighbours of a cell as filter estimates: lane i is the neighbour across face i, certain where
/// |value[i]| > error[i], in conflict where value[i] > 0.
struct FaceConflicts {
  alignas(32) double value[4];
  alignas(32) double error[4];
};

/// `cell` is finite and positively oriented; `apex[i]` is the vertex of neighbour i that is not on face i. Where an apex is
/// infinite its lane means nothing. The four determinants share the differences of the cell's vertices; the bound is that of
/// filters.hpp.
void face_conflicts(const PointRecord* points, const VertexIndex* cell, const VertexIndex* apex, const Vec3& p,
                    FaceConflicts& result);

}  // namespace geomesh

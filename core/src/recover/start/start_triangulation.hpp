// SPDX-License-Identifier: MIT
/// @file
/// The mesh that recovery starts from. In conforming mode it is the Delaunay triangulation. In constrained mode any
/// triangulation of the vertices will do. Some models are stretched (layers of kilometres' extent, metres thick). There
/// the Delaunay triangulation of the vertices with an axis scaled up misses far fewer segments: as a scaling by a power
/// of two is exact and affine, its cells are exactly positive in the model's own frame too.
#pragma once

#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "recover/model/declare.hpp"

namespace geomesh::recover {

struct StartTriangulation {
  TetMesh mesh;
  std::vector<Vec3> points;  ///< the model's vertices, then the eight of the box
  DelaunayStatistics statistics;
  std::size_t missing_edges = 0;  ///< of the Delaunay triangulation itself
  std::size_t missing_facets = 0;
  std::size_t tetrahedra = 0;  ///< its finite cells without the box's
};

enum class StartFrame {
  as_given,
  may_be_stretched,  ///< axes scaled by powers of two, where more than one segment in ten is missing
};

/// Searches the scales by hill climbing, one axis after the other: for fewer missing segments, then, where these cross
/// several times as many simplices as there are cells, for fewer crossings.
StartTriangulation triangulate_start(const PiecewiseLinearComplex& plc, const ModelNames& names, DeclaredModel& model,
                                     const DelaunayOptions& options, const RunContext& context, StartFrame frame);

}  // namespace geomesh::recover

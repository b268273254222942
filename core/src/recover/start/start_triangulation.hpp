// SPDX-License-Identifier: MIT
/// @file
/// The mesh that recovery starts from. In conforming mode it is the Delaunay triangulation. In constrained mode any
/// triangulation of the vertices is possible. Some models are very flat (layers that are kilometres wide and metres
/// thick). The Delaunay triangulation of their vertices with one axis scaled up misses far fewer segments. Because a
/// scaling by a power of two is exact and affine, its cells are exactly positive in the model's own frame, too.
#pragma once

#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "recover/model/declare.hpp"

namespace geomesh::recover {

struct StartTriangulation {
  TetMesh mesh;
  std::vector<Vec3> points;  ///< the model's vertices, followed by the eight of the box
  DelaunayStatistics statistics;
  std::size_t missing_edges = 0;  ///< segments that are no edges of the unscaled Delaunay triangulation
  std::size_t missing_facets = 0;
  std::size_t tetrahedra = 0;  ///< number of tetrahedra that have vertices of the model only, not of the box
};

enum class StartFrame {
  as_given,
  may_be_stretched,  ///< axes are scaled by powers of two if more than one segment in ten is no Delaunay edge
};

/// Makes the triangulation from which recovery starts. Searches the scales by hill climbing, one axis after the other:
/// first for fewer missing segments, then, if the missing segments cross several times as many simplices as there are
/// cells, for fewer crossings.
StartTriangulation triangulate_start(const PiecewiseLinearComplex& plc, const ModelNames& names, DeclaredModel& model,
                                     const DelaunayOptions& options, const RunContext& context, StartFrame frame);

}  // namespace geomesh::recover

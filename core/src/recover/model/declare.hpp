// SPDX-License-Identifier: MIT
/// @file
/// Converts the input complex to the segments and facets that the mesh must contain, with vertices numbered anew.
#pragma once

#include "geomesh/core/plc.hpp"
#include "geomesh/core/run_context.hpp"
#include "plc/model_names.hpp"
#include "recover/model/constraints.hpp"

namespace geomesh::recover {

struct DeclaredModel {
  std::vector<VertexIndex> input_vertex;  ///< row in plc.points of each vertex; only points of items, in input order
  Constraints constraints;
  std::vector<Index> segment_of_row;  ///< for each segment of the complex, its row in constraints.segments
  std::vector<VertexIndex> isolated_points;
  std::size_t n_facets = 0;
};

/// Declares the segments and facets of a complex. Polygons become the triangles of their constrained Delaunay
/// triangulation. Facets that are not exactly planar are reported in the log with their deviation. Throws
/// Error{invalid_input} for polygons that cannot be triangulated, with items named by `names`.
DeclaredModel declare_constraints(const PiecewiseLinearComplex& plc, const ModelNames& names,
                                  const RunContext& context);

}  // namespace geomesh::recover

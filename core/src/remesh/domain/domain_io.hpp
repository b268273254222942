// SPDX-License-Identifier: MIT
/// @file
/// Conversion of a ConstrainedTetrahedralization to the mesh that operations work on, and back.
#pragma once

#include "common/epoch_marks.hpp"
#include "geomesh/core/refine.hpp"
#include "remesh/domain/domain_mesh.hpp"
#include "remesh/domain/merge_pieces.hpp"

namespace geomesh::remesh {

/// Returns the patch of each facet as the options say. Exact: facets that are kept as one are one patch; otherwise
/// facet_patch, or facets of equal provenance.
std::vector<Index> patches_of_facets(const PiecewiseLinearComplex& plc, const RefineOptions& options,
                                     const MergedFacets& merged);
/// The patches that users name (sizes), whatever the honour mode.
std::vector<Index> named_patches(const PiecewiseLinearComplex& plc, const RefineOptions& options);

/// Vertices and cells keep their rows. Curves: edges where not exactly two faces of one patch meet, or two that turn by
/// more than the sharp angle, and listed segments. O(n log n). Throws InternalError where the mesh breaks its
/// invariants. `patches`: patches_of_facets(plc, options, merge_pieces(...)), where they are known.
DomainMesh import_domain(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                         const RefineOptions& options, std::vector<Index> patches);
DomainMesh import_domain(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                         const RefineOptions& options);

/// Input vertices that are still where they were first, in input order, then the others by row. Cells by row; faces by
/// facet.
ConstrainedTetrahedralization export_domain(const DomainMesh& domain, const ConstrainedTetrahedralization& before,
                                            unsigned threads = 1);

/// Row of v in the input PLC where it is still at its place.
VertexIndex input_vertex(const DomainMesh& domain, const ConstrainedTetrahedralization& before, VertexIndex v);

/// Rows of vertices and cells in a piece. Of the size of the mesh, so it is kept from call to call.
struct ExportScratch {
  EpochMarks marks;
  std::vector<VertexIndex> vertex_row;
  std::vector<Index> cell_row;
};
/// Exports a part of the mesh: the given cells, in their order, then the cells that share a vertex with them, and so on
/// by rings, with points, faces and edges of these alone. O(k log k) in its size.
ConstrainedTetrahedralization export_about(const DomainMesh& domain, std::span<const CellIndex> cells, unsigned rings,
                                           const ConstrainedTetrahedralization& before, ExportScratch& scratch);

}  // namespace geomesh::remesh

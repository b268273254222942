// SPDX-License-Identifier: MIT
/// @file
/// Conversion of a ConstrainedTetrahedralization to the mesh that refinement works on (DomainMesh), and back.
#pragma once

#include "common/epoch_marks.hpp"
#include "geomesh/core/refine.hpp"
#include "remesh/domain/domain_mesh.hpp"
#include "remesh/domain/merge_pieces.hpp"

namespace geomesh::remesh {

/// Returns the patch of each facet. If surfaces are kept exactly, all facets that were merged into one (`merged`) form
/// a patch. Otherwise patches are those of RefineOptions::facet_patch; if that is empty, facets of equal provenance
/// form a patch.
std::vector<Index> patches_of_facets(const PiecewiseLinearComplex& plc, const RefineOptions& options,
                                     const MergedFacets& merged);
/// Returns the patch of each facet by which users set target sizes, whether or not surfaces are kept exactly.
std::vector<Index> named_patches(const PiecewiseLinearComplex& plc, const RefineOptions& options);

/// Builds the editable mesh; vertices and cells keep their numbers. Curves are the listed segments, the edges at which
/// not exactly two faces of one patch meet, and the edges at which two faces meet at more than the sharp angle. O(n log
/// n). Throws InternalError if the mesh violates its invariants. `patches` is the result of patches_of_facets(plc,
/// options, merge_pieces(...)), if it has been computed already.
DomainMesh import_domain(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                         const RefineOptions& options, std::vector<Index> patches);
DomainMesh import_domain(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                         const RefineOptions& options);

/// Converts the mesh back to the caller's format. Input vertices that have not moved come first, in input order, then
/// all others by their numbers in the domain. Cells are ordered by number, faces by facet.
ConstrainedTetrahedralization export_domain(const DomainMesh& domain, const ConstrainedTetrahedralization& before,
                                            unsigned threads = 1);

/// Returns the index of v in the input PLC if it has not moved, otherwise no_vertex.
VertexIndex input_vertex(const DomainMesh& domain, const ConstrainedTetrahedralization& before, VertexIndex v);

/// Numbers of vertices and cells in an exported part of a mesh. The arrays are as large as the whole mesh, so they are
/// reused from call to call.
struct ExportScratch {
  EpochMarks marks;
  std::vector<VertexIndex> vertex_row;
  std::vector<Index> cell_row;
};
/// Exports a part of the mesh: the given cells in their order, then the cells that share a vertex with them, and so on
/// ring by ring, with only their points, faces and edges. O(k log k) for k cells.
ConstrainedTetrahedralization export_about(const DomainMesh& domain, std::span<const CellIndex> cells, unsigned rings,
                                           const ConstrainedTetrahedralization& before, ExportScratch& scratch);

}  // namespace geomesh::remesh

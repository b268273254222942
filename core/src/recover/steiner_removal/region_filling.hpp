// SPDX-License-Identifier: MIT
/// @file
/// A region of the mesh filled again without some of its points, decided as a formula: a variable for each tetrahedron
/// of its vertices that crosses nothing, one for each triangle; each boundary face has exactly one tetrahedron on its
/// inner side, each other triangle as many above it as below, at most one. Positive tetrahedra whose faces cancel in
/// pairs but for the boundary cover the region exactly once. So a solution is a filling, and where there is none the
/// formula is unsatisfiable. Whether a polyhedron has a filling is NP-complete (Ruppert and Seidel 1992); for some tens
/// of vertices the solver decides it in milliseconds. Where the search of polyhedron_filling.hpp sees one polyhedron,
/// this sees what lies about it: Schoenhardt's octahedra, whose free diagonals are held by neighbours of the same kind,
/// come apart. (Own design; neither in the paper nor, to our knowledge, in other meshers.)
#pragma once

#include <optional>
#include <vector>

#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// Invariants: `boundary` is closed (each edge once in each direction, counted with multiplicity); no cell is a ghost.
struct Region {
  std::vector<CellIndex> cells;
  std::vector<VertexIndex> vertices;  ///< sorted, those dropped left out
  std::vector<Triangle> boundary;     ///< counter-clockwise seen from inside; locked faces inside from both sides
  std::vector<std::array<VertexIndex, 2>> segments;  ///< subsegments of the cells, smaller vertex first, sorted
  std::vector<Tetrahedron> kept;                     ///< cells without a dropped vertex
};

/// `seeds` and cells about them, breadth first over faces that are not locked, up to `max_vertices` (at most 64)
/// vertices. Cells of `dropped` vertices are seeds or forbidden; locked faces and subsegments with one of them are left
/// out, so the caller puts others in their place. The region does not spread to cells in `forbidden` (sorted). None
/// where the seeds alone are too many. O(k log k) for k cells.
std::optional<Region> region_about(const Recovery& recovery, const std::vector<CellIndex>& seeds,
                                   std::span<const VertexIndex> dropped, std::size_t max_vertices,
                                   std::span<const CellIndex> forbidden = {});

/// Cells for the region that have all of its boundary and segments; none where there are none or `max_conflicts` do not
/// suffice. They may lack added points, as one beyond the facets that the boundary has now, but no input vertex.
/// O(n^4) for n vertices before the search.
std::optional<std::vector<Tetrahedron>> fill_region(const ConstrainedMesh& mesh, const Constraints& constraints,
                                                    const Region& region, std::size_t max_conflicts);
/// The same within recovery's budget, but for regions that have been found to have none: they are remembered.
std::optional<std::vector<Tetrahedron>> fill_region_once(Recovery& recovery, const Region& region);

/// Exchanges cells for a filling of theirs. Vertices that it lacks are in the mesh no more. O(k log k) for k cells.
void refill(ConstrainedMesh& mesh, const std::vector<CellIndex>& cells, const std::vector<Tetrahedron>& filling);

}  // namespace geomesh::recover

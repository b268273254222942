// SPDX-License-Identifier: MIT
/// @file
/// Refills a region of the mesh without some of its points, decided by a formula: a variable for each tetrahedron of
/// its vertices that crosses nothing, one for each triangle; each boundary face has exactly one tetrahedron on its
/// inner side, each other triangle as many above it as below, at most one. Positive tetrahedra whose faces cancel in
/// pairs except for the boundary cover the region exactly once. A solution is therefore a filling, and if there is none
/// the formula is unsatisfiable. Whether a polyhedron has a filling is NP-complete (Ruppert and Seidel 1992); for some
/// tens of vertices the solver decides it in milliseconds. The search of polyhedron_filling.hpp handles one polyhedron,
/// whereas this includes its surroundings: it fills Schoenhardt's polyhedra whose free diagonals are blocked by
/// neighbours of the same kind. (Own design; neither in the paper nor, to our knowledge, in other meshers.)
#pragma once

#include <optional>
#include <vector>

#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// Invariants: `boundary` is closed (each edge once in each direction, counted with multiplicity); no cell is a ghost.
struct Region {
  std::vector<CellIndex> cells;
  std::vector<VertexIndex> vertices;  ///< sorted, without the dropped ones
  /// Counter-clockwise as seen from the region's inside. A locked face between two of its cells is listed twice, once
  /// in each orientation.
  std::vector<Triangle> boundary;
  std::vector<std::array<VertexIndex, 2>> segments;  ///< subsegments of the cells, smaller vertex first, sorted
  std::vector<Tetrahedron> kept;                     ///< cells without a dropped vertex
};

/// Returns `seeds` and cells around them, breadth first across faces that are not locked, up to `max_vertices` (at most
/// 64) vertices. Cells of `dropped` vertices are seeds or forbidden; locked faces and subsegments with one of them are
/// left out, so the caller puts others in their place. The region does not spread to cells in `forbidden` (sorted).
/// Returns nothing if the seeds alone are too many. O(k log k) for k cells.
std::optional<Region> region_about(const Recovery& recovery, const std::vector<CellIndex>& seeds,
                                   std::span<const VertexIndex> dropped, std::size_t max_vertices,
                                   std::span<const CellIndex> forbidden = {});

/// Returns cells for the region that have all of its boundary and segments; nothing if there are none or
/// `max_conflicts` do not suffice. They may lack added points, for example one beyond the facets that the boundary has
/// now, but no input vertex. O(n^4) for n vertices before the search.
std::optional<std::vector<Tetrahedron>> fill_region(const ConstrainedMesh& mesh, const Constraints& constraints,
                                                    const Region& region, std::size_t max_conflicts);
/// Like fill_region, within recovery's budget; regions found to have no filling are remembered and not tried again.
std::optional<std::vector<Tetrahedron>> fill_region_once(Recovery& recovery, const Region& region);

/// Exchanges cells for a filling. Vertices that it lacks are removed from the mesh. O(k log k) for k cells.
void refill(ConstrainedMesh& mesh, const std::vector<CellIndex>& cells, const std::vector<Tetrahedron>& filling);

}  // namespace geomesh::recover

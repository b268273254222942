// SPDX-License-Identifier: MIT
/// @file
/// Fills a region of the mesh anew without some of its points. Whether this is possible is decided by a propositional
/// formula with a variable for each tetrahedron of the region's vertices that crosses no required item, and one for
/// each triangle. It states that each boundary face has exactly one tetrahedron on its inner side, and each other
/// triangle as many above it as below, at most one. Positive tetrahedra whose faces cancel in pairs except for the
/// boundary cover the region exactly once. A solution is therefore a filling, and if there is none the formula is
/// unsatisfiable. Whether a polyhedron has a filling is NP-complete (Ruppert and Seidel 1992); for some tens of
/// vertices the solver decides it in milliseconds. The search of polyhedron_filling.hpp handles one polyhedron, whereas
/// a region includes the surroundings: this method fills Schoenhardt's polyhedra whose free diagonals are blocked by
/// neighbours of the same kind. (Own design, to our knowledge in no other mesher.)
#pragma once

#include <optional>
#include <vector>

#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// A region of the mesh to be filled anew. Invariants: `boundary` is closed (each edge once in each direction, counted
/// with multiplicity); no cell is a ghost.
struct Region {
  std::vector<CellIndex> cells;
  std::vector<VertexIndex> vertices;  ///< vertices of `cells` without the points to be removed from the mesh, sorted
  /// Boundary triangles, counter-clockwise as seen from the region's inside. A locked face between two of its cells is
  /// listed twice, once in each orientation.
  std::vector<Triangle> boundary;
  std::vector<std::array<VertexIndex, 2>> segments;  ///< subsegments in the region, smaller vertex first, sorted
  std::vector<Tetrahedron> kept;                     ///< cells of the region none of whose vertices is to be removed
};

/// Returns `seeds` and cells around them, breadth first across faces that are not locked, up to `max_vertices` (at most
/// 64) vertices. All cells with a vertex of `dropped` must be seeds or forbidden. Locked faces and subsegments with
/// such a vertex are left out, so the caller must add others in their place. The region does not spread to cells in
/// `forbidden` (sorted). Returns nothing if the seeds alone have too many vertices. O(k log k) for k cells.
std::optional<Region> region_about(const Recovery& recovery, const std::vector<CellIndex>& seeds,
                                   std::span<const VertexIndex> dropped, std::size_t max_vertices,
                                   std::span<const CellIndex> forbidden = {});

/// Returns cells that fill the region and have all of its boundary and segments. Returns nothing if there are no such
/// cells or `max_conflicts` do not suffice to decide. The cells have all input vertices of the region but may lack
/// added points, for example a point beyond the new facets of the boundary. O(n^4) for n vertices before the search.
std::optional<std::vector<Tetrahedron>> fill_region(const ConstrainedMesh& mesh, const Constraints& constraints,
                                                    const Region& region, std::size_t max_conflicts);
/// Fills the region as fill_region does, but returns nothing at once if an earlier call found no filling for it.
std::optional<std::vector<Tetrahedron>> fill_region_once(Recovery& recovery, const Region& region);

/// Replaces cells by others that fill the same region, and removes vertices that these lack. O(k log k) for k cells.
void refill(ConstrainedMesh& mesh, const std::vector<CellIndex>& cells, const std::vector<Tetrahedron>& filling);

}  // namespace geomesh::recover

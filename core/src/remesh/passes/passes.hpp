// SPDX-License-Identifier: MIT
/// @file
/// The passes that refine the mesh to the size field: first curves, then surfaces, then the interior.
#pragma once

#include <cstdint>
#include <functional>

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/operations.hpp"
#include "remesh/rescue/rescue.hpp"

namespace geomesh::remesh {

/// Throws Error{cannot_mesh} because a pass would create more than max_cells cells.
[[noreturn]] void throw_too_many_cells(std::size_t max_cells);

/// Runs the schedule of refinement, which consists of all passes declared in passes.hpp.
void refine_to_size(Toolbox& tools, const RefineOptions& options, const RunContext& context);

enum class ShortEdges : bool {
  on_surfaces,  ///< edges on curves and surfaces, if these may be remeshed
  inside,       ///< edges with at least one end inside a region
};
/// Collapses edges shorter than RefineRatios::collapse_edge, the shortest first. O(n log n).
std::size_t collapse_short_edges(Toolbox& tools, ShortEdges which, const RunContext& context);

/// Collapses edges shorter than RefineRatios::thin_out_edge inside, or thin_out_surface_edge on surfaces (within the
/// tolerance), because their points turned out not to be needed. The worst shape does not fall below both `floor` and
/// its former value. Examines only edges around whose ends the mesh has changed after its time `since`
/// (DomainMesh::tick); all edges if this is 0. O(n log n).
std::size_t thin_out(Toolbox& tools, ShortEdges which, double floor, std::uint64_t since, const RunContext& context);

/// Collapses edges shorter than RefineRatios::promised_edge, or else lengthens them. The cells around may become bad as
/// long as they can be repaired. Skips edges without a change around them after the time `since`.
std::size_t thin_out_mending(Toolbox& tools, ShortEdges which, const RescueRule& rule, std::uint64_t since,
                             const RunContext& context);

enum class LongEdges : bool { of_curves, of_surfaces };
/// Splits edges longer than RefineRatios::split_edge, the longest first. Throws Error{cannot_mesh} beyond max_cells, as
/// the other passes that add points do.
std::size_t split_long_edges(Toolbox& tools, LongEdges which, std::size_t max_cells, const RunContext& context);

/// Visits vertices in groups that are apart in space. Vertices of a group may be moved concurrently with those of other
/// groups, because no two groups have a cell in common; the vertices between groups are visited last. The groups depend
/// only on the mesh. O(n log n).
void for_each_block(const DomainMesh& mesh, std::vector<VertexIndex> movable, unsigned threads,
                    const std::function<void(const std::vector<VertexIndex>&, Workspace&)>& visit);

/// For each vertex on a surface, the mesh's times (DomainMesh::tick) of the last flip and the last move that failed.
struct InVainOnSurfaces {
  std::vector<std::uint64_t> flips, moves;
};
/// Improves the shapes of faces within patches, as far as the cells permit: rounds of Delaunay flips on the surface,
/// and of moves to the centroid of the faces. A failed operation is tried again only if something around it has changed
/// since, also in later calls. Runs in parallel; the result does not depend on the number of threads. O(vertices of the
/// mesh), plus the stars of changed vertices on surfaces.
void make_surfaces_regular(Toolbox& tools, InVainOnSurfaces& in_vain, const RunContext& context);

/// Inserts points on faces larger than the target size, advancing from curves and small faces.
std::size_t refine_surfaces(Toolbox& tools, std::size_t max_cells, const RunContext& context);

/// Inserts points into cells larger than the target size until no cell admits a further point.
std::size_t refine_inside(Toolbox& tools, std::size_t max_cells, const RunContext& context);

/// Refines the interior of all components concurrently; the result does not depend on the number of threads. If sizes
/// are a function of the caller, one thread is used.
std::size_t refine_components_inside(Toolbox& tools, std::size_t max_cells, const RunContext& context);

}  // namespace geomesh::remesh

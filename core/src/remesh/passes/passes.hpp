// SPDX-License-Identifier: MIT
/// @file
/// The passes that bring the mesh to the size field: curves, then surfaces, then the inside.
#pragma once

#include <cstdint>
#include <functional>

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/operations.hpp"
#include "remesh/rescue/rescue.hpp"

namespace geomesh::remesh {

/// Throws Error{cannot_mesh}: a pass that adds points would exceed the number of cells allowed.
[[noreturn]] void throw_too_many_cells(std::size_t max_cells);

/// The schedule of refinement: all passes below.
void refine_to_size(Toolbox& tools, const RefineOptions& options, const RunContext& context);

enum class ShortEdges : bool {
  on_surfaces,  ///< on curves and surfaces, where these may be remeshed
  inside,       ///< of which one end at least lies inside
};
/// Collapses edges shorter than RefineRatios::collapse_edge, the shortest first. O(n log n).
std::size_t collapse_short_edges(Toolbox& tools, ShortEdges which, const RunContext& context);

/// Collapses edges that are shorter than RefineRatios::thin_out_edge inside, thin_out_surface_edge on surfaces (within
/// the tolerance): points that turn out not to be needed. The worst shape does not fall below the lesser of what it was
/// and `floor`. Only those about whose ends the mesh has changed after the moment `since` (DomainMesh::tick); all where
/// it is 0. O(n log n).
std::size_t thin_out(Toolbox& tools, ShortEdges which, double floor, std::uint64_t since, const RunContext& context);

/// Collapses those below RefineRatios::promised_edge at any cost for the cells about, as long as these can be mended
/// (collapse_mending). `since`: as in thin_out.
std::size_t thin_out_mending(Toolbox& tools, ShortEdges which, const RescueRule& rule, std::uint64_t since,
                             const RunContext& context);

enum class LongEdges : bool { of_curves, of_surfaces };
/// Splits edges longer than RefineRatios::split_edge, the longest first. Throws Error{cannot_mesh} beyond max_cells, as
/// the other passes that add points do.
std::size_t split_long_edges(Toolbox& tools, LongEdges which, std::size_t max_cells, const RunContext& context);

/// Visits vertices parted in space, by lists of those that may move at once on as many threads, then those between. No
/// vertex of a list shares a cell with one of another. The lists depend on the mesh alone. O(n log n).
void for_each_block(const DomainMesh& mesh, std::vector<VertexIndex> movable, unsigned threads,
                    const std::function<void(const std::vector<VertexIndex>&, Workspace&)>& visit);

/// The mesh's time of the last failed attempt on surfaces, by vertex.
struct InVainOnSurfaces {
  std::vector<std::uint64_t> flips, moves;
};
/// Faces of good shape within patches, cells allowing: rounds of surface flips towards Delaunay and of moves to the
/// centroid of the faces. What was in vain is tried again only where something about it has changed, also from one
/// call to the next. On all cores, with the same result whatever their number. O(vertices of the mesh), and the
/// stars of those on surfaces that have changed.
void make_surfaces_regular(Toolbox& tools, InVainOnSurfaces& in_vain, const RunContext& context);

/// Inserts points on faces larger than the target size, front by front from curves and small faces.
std::size_t refine_surfaces(Toolbox& tools, std::size_t max_cells, const RunContext& context);

/// How many points are to come: where many are, cells are put in order first and each keeps its circumsphere.
enum class Insertions : bool { few, many };

/// Inserts points into cells larger than the target size until none admits one.
std::size_t refine_inside(Toolbox& tools, std::size_t max_cells, const RunContext& context,
                          Insertions expected = Insertions::many);

/// Does so in all components at once, on all cores, with the same result whatever their number. On one core if sizes
/// are a function of the caller.
std::size_t refine_components_inside(Toolbox& tools, std::size_t max_cells, const RunContext& context);

}  // namespace geomesh::remesh

// SPDX-License-Identifier: MIT
/// @file
/// Operations on the whole mesh: facets of faces made anew, breaches mended, flips towards Delaunay.
#pragma once

#include <cstdint>
#include <optional>

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

/// Gives each face the facet of its patch that is nearest to it, oriented as it is.
void renew_facets(DomainMesh& mesh, const SurfaceGuard& guard, const PiecewiseLinearComplex& plc);

/// How a vertex is brought to a place that has none near enough.
enum class MendBy : std::uint8_t {
  moves_and_splits,  ///< a vertex that is moved may leave its old place uncovered
  splits,
};

/// Puts a vertex of the nearest face (or curve edge), new or moved, to the place of each breach. Cells must stay
/// positive and of some shape, and fewer faces must be off the input than were (none, where none was). Returns how many
/// were treated: other places may be off then, so verify again. O(n log n).
std::size_t mend_surfaces(Toolbox& tools, const std::vector<Breach>& breaches, MendBy by = MendBy::moves_and_splits);

/// Flips (2-3 and 3-2) until no face admits one that makes it locally Delaunay: insertion works best from there. Where
/// the mesh was so at the time `since`, only cells are looked at that were changed later, or a vertex of which was.
std::size_t flip_towards_delaunay(Toolbox& tools, const RunContext& context,
                                  std::optional<std::uint64_t> since = std::nullopt);

}  // namespace geomesh::remesh

// SPDX-License-Identifier: MIT
/// @file
/// Operations on all surfaces of the mesh: assignment of facets to faces, repair of breaches, Delaunay flips.
#pragma once

#include <cstdint>
#include <optional>

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

/// Gives each face the facet of its patch that is nearest to it, oriented as it is.
void renew_facets(DomainMesh& mesh, const SurfaceGuard& guard, const PiecewiseLinearComplex& plc);

/// How a vertex is brought to the place of a breach, where no vertex is near enough.
enum class MendBy : std::uint8_t {
  /// A vertex is moved or an edge is split. A vertex that is moved may leave its former place without any vertex near
  /// enough.
  moves_and_splits,
  splits,
};

/// Puts a vertex of the nearest face or curve edge, new or moved, to the place of each breach. Cells must remain
/// positive and not too flat, and fewer faces must be too far from the input than before (or none before and after).
/// Returns the number of breaches treated. Other places may be too far off then, so the mesh must be verified again.
/// O(n log n).
std::size_t mend_surfaces(Toolbox& tools, const std::vector<Breach>& breaches, MendBy by = MendBy::moves_and_splits);

/// Flips faces (2-3 and 3-2) until none can be made locally Delaunay, which helps later insertions. If this was so at
/// the mesh's time `since`, only cells that have changed later, or of which a vertex has, are examined.
std::size_t flip_towards_delaunay(Toolbox& tools, const RunContext& context,
                                  std::optional<std::uint64_t> since = std::nullopt);

}  // namespace geomesh::remesh

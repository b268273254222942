// SPDX-License-Identifier: MIT
/// @file
/// Operations on all surfaces of the mesh: assignment of facets to faces, repair outside the tolerance, Delaunay flips.
#pragma once

#include <cstdint>
#include <optional>

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

/// Assigns to each face of a surface the nearest facet of its patch, with the orientation of the face.
void renew_facets(DomainMesh& mesh, const SurfaceGuard& guard, const PiecewiseLinearComplex& plc);

/// How a surface is repaired at a place that is too far from the input.
enum class MendBy : std::uint8_t {
  /// At a place that is too far from the input, a vertex is moved or an edge is split. A move may take the surface too
  /// far from the old position of the vertex.
  moves_and_splits,
  splits,
};

/// Repairs each place where a surface or curve is too far from the input: moves a vertex of the nearest face or curve
/// edge there, or adds one. Cells must remain positive and not too flat, and fewer faces must be too far from the input
/// than before (or none before and after). Returns the number of places repaired. Other places may be too far from the
/// input afterwards, so the mesh must be verified again. O(n log n).
std::size_t mend_surfaces(Toolbox& tools, const std::vector<Breach>& breaches, MendBy by = MendBy::moves_and_splits);

/// Flips faces (2-3 and 3-2) until none can be made locally Delaunay, which helps later insertions. If the mesh was
/// flipped at its time `since`, only cells that have changed since then, or of which a vertex has, are examined.
std::size_t flip_towards_delaunay(Toolbox& tools, const RunContext& context,
                                  std::optional<std::uint64_t> since = std::nullopt);

}  // namespace geomesh::remesh

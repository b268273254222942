// SPDX-License-Identifier: MIT
/// @file
/// Adds points on edges and facets at the target distances before anything is meshed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>

#include "geomesh/core/error.hpp"
#include "geomesh/core/plc.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/core/size_field.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "remesh/domain/merge_pieces.hpp"

namespace geomesh::remesh {

/// Parts of the complex to which no points are added.
struct WholeParts {
  std::set<std::array<VertexIndex, 2>>
      edges;               ///< edges of the complex that get no points, each with its lower vertex first
  std::set<Index> facets;  ///< facets (before merging) that get no inner points

  std::size_t size() const { return edges.size() + facets.size(); }
};

/// A complex with additional points on edges and facets, after the original ones. Facets and segments keep their order.
struct SampledComplex {
  PiecewiseLinearComplex plc;
  std::vector<Index> segment;  ///< for each segment, the original segment of which it is a piece
  /// For each point that was added on an edge of the original complex, the ends of that edge.
  std::vector<std::array<VertexIndex, 2>> edge_of_point;
};

/// Whether thin triangles on which rounded points would make edges intersect may be flipped at their longest edge.
enum class Slivers : std::uint8_t { may_go, stay };

/// Divides edges of facets and segments into pieces of about the target length, and adds points in each facet from the
/// border inwards, at the target distance from each other. Each point keeps at least 0.75 of this distance from all
/// others in the facet, as in the advancing front of refine_inside, but without a triangulation. `mesh` is a mesh of
/// the PLC before facets were merged; it gives the components beside a facet. Edges of slivers that are kept are not
/// divided; other slivers are flipped in `merged`. The edges in `whole` get no points, and its facets get none inside.
/// Deterministic. Near-linear in the points if sizes vary slowly.
SampledComplex sample_surfaces(MergedFacets& merged, const ConstrainedTetrahedralization& mesh, const SizeField& size,
                               Slivers slivers, const RunContext& context, WholeParts whole = {});

/// Meshes the sampled complex. The result has vertices, segments and components of the PLC before facets were merged,
/// as in `mesh`; merged facets get the first original facet, and components that `mesh` does not have are left out.
/// Returns nothing if rounding made facets cross, or components cannot be identified; `trouble` then contains the
/// place.
std::optional<ConstrainedTetrahedralization> mesh_sampled(const MergedFacets& merged,
                                                          const ConstrainedTetrahedralization& mesh,
                                                          const SampledComplex& sampled, const RunContext& context,
                                                          ErrorContext* trouble = nullptr);

/// Adds to `whole` the facets that `trouble` lists with their edges, and the edges and facets that contain points
/// listed there. Returns whether any of these is new.
bool keep_whole(const MergedFacets& merged, const SampledComplex& sampled, const ErrorContext& trouble,
                WholeParts& whole);

}  // namespace geomesh::remesh

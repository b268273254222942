// SPDX-License-Identifier: MIT
/// @file
/// Puts points on edges and facets at the target distances before anything is meshed. This is for `exact` mode, in
/// which surfaces are kept as they are.
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
  std::set<std::array<VertexIndex, 2>> edges;  ///< edges of the complex, with the lower vertex first
  std::set<Index> facets;                      ///< facets without new inner points; rows before facets were merged

  std::size_t size() const { return edges.size() + facets.size(); }
};

/// The merged facets and the segments in their order, with additional points. The rows of the original points come
/// first.
struct SampledComplex {
  PiecewiseLinearComplex plc;
  std::vector<Index> segment;  ///< for each segment, the original segment of which it is a piece
  /// For each new point on an edge, the edge; starts at the first such point.
  std::vector<std::array<VertexIndex, 2>> edge_of_point;
};

/// Thin triangles on which rounded points would make edges intersect. Either their longest edge is flipped, or they are
/// kept.
enum class Slivers : std::uint8_t { may_go, stay };

/// Cuts edges of facets and segments into pieces of about the target length, equal in units of it. In each facet points
/// follow from the border inwards, at the target distance from each other. Each has at least 0.75 of it from all others
/// there: this is the front of the inside refinement one dimension down, without a triangulation. `mesh` is of the PLC
/// before facets were merged, and gives the components beside a facet. Edges of slivers that are kept are not cut; the
/// others are flipped in `merged`. Edges in `whole` are not cut either, and its facets get no points inside.
/// Deterministic. Near-linear in the points if sizes vary slowly.
SampledComplex sample_surfaces(MergedFacets& merged, const ConstrainedTetrahedralization& mesh, const SizeField& size,
                               Slivers slivers, const RunContext& context, WholeParts whole = {});

/// Returns the mesh of the sampled complex as one of the PLC before facets were merged: vertices, segments and
/// components as in `mesh`, facets by the first of those that were merged, without components that it lacks. Returns
/// nothing if rounding made facets cross, or components cannot be identified; `trouble` then has the engine's message
/// with the place.
std::optional<ConstrainedTetrahedralization> mesh_sampled(const MergedFacets& merged,
                                                          const ConstrainedTetrahedralization& mesh,
                                                          const SampledComplex& sampled, const RunContext& context,
                                                          ErrorContext* trouble = nullptr);

/// Adds the facets in trouble with their edges, and the edges and facets on which points in trouble lie. Returns
/// whether any of them is new.
bool keep_whole(const MergedFacets& merged, const SampledComplex& sampled, const ErrorContext& trouble,
                WholeParts& whole);

}  // namespace geomesh::remesh

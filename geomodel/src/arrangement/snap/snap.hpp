// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Snaps everything closer than a distance: the tolerance, or some ulps, to resolve overlaps too thin for rounding.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "arrangement/model/complex.hpp"
#include "arrangement/snap/join_rule.hpp"

namespace geomesh::geomodel::arrangement {

/// The vertices that snapping moves to a plane of the box if they are closer to it than the snapping distance.
enum class MoveToBox : std::uint8_t { none, of_free_borders, all };

struct SnapOptions {
  double distance = 0;
  std::optional<Box3> box;  ///< vertices on the planes of the model's box remain on them
  MoveToBox move_to_box = MoveToBox::none;
  JoinRule rule{};
  /// For each vertex, if the volume is not a box: the sides of the volume on which it lies up to rounding, as bits
  /// modulo 64. New vertices on edges along a side are kept on that side. Empty if there are no sides.
  std::vector<std::uint64_t> sides_of{};
};

struct SnapOutcome {
  std::size_t n_vertices_merged = 0, n_vertices_inserted = 0, n_facets_merged = 0;
  std::vector<VanishedFacet> vanished;
  Displacement moved;  ///< movement of vertices merged with others, and of edges and facets to inserted vertices
  bool changed() const { return n_vertices_merged + n_vertices_inserted + vanished.size() + n_facets_merged > 0; }
};

/// Snaps the facets with active[f] and all wells' segments. Vertices closer than the distance are merged; of two, the
/// one on more box planes is kept, then the one from the input, then the earlier. Edges and facets are split at
/// vertices that are closer to them than the distance. Two edges closer than that are split at a common new vertex.
/// Facets without area are removed, equal ones merged. Everything that changed is marked dirty. Points keep their
/// indices; `vertex_now`, if not null, receives for each vertex the one that replaced it. Snapping need not separate
/// everything: the exact check that follows decides. Deterministic; near-linear if few items are within that distance
/// of each.
SnapOutcome snap_near(Complex& complex, const std::vector<std::uint8_t>& active, const SnapOptions& options,
                      std::vector<VertexIndex>* vertex_now = nullptr);

/// Vertices inserted in edges and in facets; those on an edge are in order from its end with the smaller index.
struct Insertions {
  std::map<EdgeKey, std::vector<VertexIndex>> on_edge;
  std::map<Index, std::vector<VertexIndex>> in_facet;
};

/// Splits a facet at vertices on its edges and inside, and returns triangles with the facet's orientation. Edges of
/// `wanted` between these vertices exist in the result unless they cross something. Returns nothing if the facet's
/// border crosses itself in projection along the normal, and along the axes from which the border is well visible; the
/// facet is best left unchanged. The result is empty if no area is left.
std::optional<std::vector<Triangle>> split_facet(const std::vector<Vec3>& points, const Triangle& facet,
                                                 const std::vector<VertexIndex>& border,
                                                 const std::vector<VertexIndex>& inside,
                                                 const std::vector<EdgeKey>& wanted);

}  // namespace geomesh::geomodel::arrangement

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Snapping of everything closer than a distance: for `tolerance`, and, with a few ulps, for overlaps too thin for any
/// rounding.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "arrangement/model/complex.hpp"
#include "arrangement/snap/join_rule.hpp"

namespace geomesh::geomodel::arrangement {

/// Which vertices closer than the distance to a plane of the box move to it.
enum class MoveToBox : std::uint8_t { none, of_free_borders, all };

struct SnapOptions {
  double distance = 0;
  std::optional<Box3> box;  ///< vertices on the planes of this box remain on them
  MoveToBox move_to_box = MoveToBox::none;
  JoinRule rule{};
  /// For each vertex, for a volume that is not a box: the sides on which it lies up to rounding, as bits modulo 64.
  /// Vertices along a side remain there. Empty if there are none.
  std::vector<std::uint64_t> sides_of{};
};

struct SnapOutcome {
  std::size_t n_vertices_merged = 0, n_vertices_inserted = 0, n_facets_merged = 0;
  std::vector<VanishedFacet> vanished;
  Displacement moved;  ///< movement of merged vertices, and of edges and facets at inserted vertices
  bool changed() const { return n_vertices_merged + n_vertices_inserted + vanished.size() + n_facets_merged > 0; }
};

/// Works on the facets with active[f] and all wells' segments. Vertices closer than the distance are merged; of two,
/// the one on more box planes is kept, then the one from the input, then the earlier. Edges and facets closer to a
/// vertex are split at it. Edges closer to each other are split at a common new vertex. Facets without area are
/// removed, equal ones merged. Everything that changed is marked dirty. Points keep their rows; `vertex_now`, if given,
/// receives for each vertex the one that replaced it. This is a step towards separation and no proof of it: the exact
/// check that follows decides. Deterministic; near-linear where each neighbourhood of that distance holds a bounded
/// number of things.
SnapOutcome snap_near(Complex& complex, const std::vector<std::uint8_t>& active, const SnapOptions& options,
                      std::vector<VertexIndex>* vertex_now = nullptr);

/// The insertions by edge and facet; vertices on an edge are in order from its smaller end.
struct Insertions {
  std::map<EdgeKey, std::vector<VertexIndex>> on_edge;
  std::map<Index, std::vector<VertexIndex>> in_facet;
};

/// Returns the facet with vertices on its edges and inside, as triangles with the facet's orientation. Edges of
/// `wanted` between its vertices exist unless they cross something. Returns nothing if its border crosses itself in
/// projection along the normal, and along the axes from which the border is well visible; the facet is best left
/// unchanged. Empty if no area is left.
std::optional<std::vector<Triangle>> split_facet(const std::vector<Vec3>& points, const Triangle& facet,
                                                 const std::vector<VertexIndex>& border,
                                                 const std::vector<VertexIndex>& inside,
                                                 const std::vector<EdgeKey>& wanted);

}  // namespace geomesh::geomodel::arrangement

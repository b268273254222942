// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Snapping of everything nearer than a distance: for `tolerance`, and, at a few ulps, for overlaps too thin for any
/// rounding.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "arrangement/model/complex.hpp"
#include "arrangement/snap/join_rule.hpp"

namespace geomesh::geomodel::arrangement {

/// Which vertices nearer than the distance to a plane of the box go to it.
enum class MoveToBox : std::uint8_t { none, of_free_borders, all };

struct SnapOptions {
  double distance = 0;
  std::optional<Box3> box;  ///< vertices on its planes remain there
  MoveToBox move_to_box = MoveToBox::none;
  JoinRule rule{};
  /// By vertex: the sides of a volume that is no box on which it lies up to rounding, as bits, modulo 64. Vertices
  /// along a side remain there. Empty: there are none.
  std::vector<std::uint64_t> sides_of{};
};

struct SnapOutcome {
  std::size_t n_vertices_merged = 0, n_vertices_inserted = 0, n_facets_merged = 0;
  std::vector<Index> facets_left_alone;  ///< near vertices, but not to be split at them: their edges stay whole; rows
                                         ///< as they were
  std::vector<VanishedFacet> vanished;
  Displacement moved;  ///< of merged vertices, and of edges and facets at vertices inserted in them
  bool changed() const { return n_vertices_merged + n_vertices_inserted + vanished.size() + n_facets_merged > 0; }
};

/// Works among the facets with active[f] and all wells' segments. Vertices nearer than the distance become one. The one
/// on more box planes stands, then the one from the input, then the earlier. Edges and facets nearer to a vertex are
/// split at it. Edges nearer to each other are split at a common new vertex. Facets without area go, equal ones merge.
/// What changed is marked dirty. Rows of points stay; `vertex_now`, where given, has for each the vertex that stands
/// for it.
///
/// This is a step towards separation, no proof of it: the exact check that follows decides. Deterministic; near-linear
/// where each neighbourhood of that distance holds a bounded number of things.
SnapOutcome snap_near(Complex& complex, const std::vector<std::uint8_t>& active, const SnapOptions& options,
                      std::vector<VertexIndex>* vertex_now = nullptr);

/// The insertions by place; vertices on an edge are in order from its lesser end.
struct Insertions {
  std::map<EdgeKey, std::vector<VertexIndex>> on_edge;
  std::map<Index, std::vector<VertexIndex>> in_facet;
};

/// The facet with vertices on its edges and inside, as triangles that turn as the facet does. Edges of `wanted` between
/// its vertices are there where they cross nothing. nothing: its border crosses itself as seen along the normal, and
/// along the axes from which the border is well seen; the facet is best left alone. Empty: no area is left.
std::optional<std::vector<Triangle>> split_facet(const std::vector<Vec3>& points, const Triangle& facet,
                                                 const std::vector<VertexIndex>& border,
                                                 const std::vector<VertexIndex>& inside,
                                                 const std::vector<EdgeKey>& wanted);

}  // namespace geomesh::geomodel::arrangement

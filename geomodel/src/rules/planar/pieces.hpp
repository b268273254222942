// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Pieces into which one surface of a soup is cut by others, and on which side of these they lie.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "common/edge_uses.hpp"
#include "geomesh/geomodel/arrangement.hpp"
#include "naming/sheets.hpp"

namespace geomesh::geomodel {

/// A soup that is being trimmed: facets lose origins, and facets without origins are removed.
struct WorkingSoup {
  const PolygonSoup& soup;
  std::vector<EdgeUse> uses;                              ///< edge uses of all facets, sorted
  std::vector<std::vector<PolygonSoup::Origin>> origins;  ///< remaining origins of each facet

  explicit WorkingSoup(const PolygonSoup& s);
  const PolygonSoup::Origin* origin_of(Index facet, Index surface) const;
  bool has(Index facet, Index surface) const { return origin_of(facet, surface) != nullptr; }
  bool alive(Index facet) const { return !origins[facet].empty(); }
  double area(Index facet) const;
  Vec3 centre(Index facet) const;
  /// Removes `surface` from the origins of the facets; returns their area.
  double remove(const std::vector<Index>& facets, Index surface);
  /// Removes the origins that `goes` accepts from the facets; returns the area of the removed parts of triangles.
  double remove(const std::vector<Index>& facets, const std::function<bool(const PolygonSoup::Origin&)>& goes);
  /// Returns the remaining soup, without unused points.
  PolygonSoup result() const;
};

/// Whether an edge at which the cutting surface ends determines the side of what continues beyond it in the map. It
/// does for faults, which stand on that end. A horizon beyond it may be the displaced one across a fault.
enum class BeyondEnd : std::uint8_t { has_a_side, has_none };

struct Piece {
  std::vector<Index> facets;  ///< facets in ascending order, which may also belong to other surfaces
  double area = 0;
  Index largest = no_index;     ///< facet
  double above = 0, below = 0;  ///< length of contact with the cutting surface from above and from below
  double free_border = 0;       ///< length of edges with no other facet, of any surface
  double contact = 0;           ///< length of edges on other surfaces
};

/// Returns pieces made of facets of surface `x` joined across edges that no facet of a surface in `cutters` touches.
/// Facets that x shares with a cutter are left out. If `sides` is given (of the only cutter), contacts from above and
/// below are distinguished by exact orientation around the edge. Facets are not joined across edges of `dividers`
/// either, at which the cutter's blocks end; these have no other effect.
std::vector<Piece> pieces_of(const WorkingSoup& working, Index x, const std::vector<Index>& cutters,
                             const UpwardSides* sides, BeyondEnd beyond = BeyondEnd::has_a_side,
                             const std::vector<Index>& dividers = {});
/// Returns pieces made of the facets that `is_mine` accepts.
std::vector<Piece> pieces_of(const WorkingSoup& working, const std::function<bool(Index)>& is_mine,
                             const std::vector<Index>& cutters, const UpwardSides* sides,
                             BeyondEnd beyond = BeyondEnd::has_a_side, const std::vector<Index>& dividers = {});

/// Returns the side of a piece relative to surface y: 1 above, -1 below, 0 unknown. It is determined by its contacts,
/// else on the vertical through its largest facet.
int side_of(const WorkingSoup& working, const Piece& piece, Index y, const UpwardSides& sides);

}  // namespace geomesh::geomodel

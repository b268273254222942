// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Pieces into which other surfaces cut one surface of a soup, and the sides of these surfaces on which the pieces lie.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "common/edge_uses.hpp"
#include "geomesh/geomodel/arrangement.hpp"
#include "naming/sheets.hpp"

namespace geomesh::geomodel {

/// A soup that is being trimmed: facets lose origins (input triangles), and those without origins are removed.
struct WorkingSoup {
  const PolygonSoup& soup;
  std::vector<EdgeUse> uses;                              ///< edges of all facets, each with a facet at it, sorted
  std::vector<std::vector<PolygonSoup::Origin>> origins;  ///< remaining origins (input triangles) of each facet

  explicit WorkingSoup(const PolygonSoup& s);
  const PolygonSoup::Origin* origin_of(Index facet, Index surface) const;
  bool has(Index facet, Index surface) const { return origin_of(facet, surface) != nullptr; }
  bool alive(Index facet) const { return !origins[facet].empty(); }
  double area(Index facet) const;
  Vec3 centre(Index facet) const;
  /// Removes `surface` from the origins (input triangles) of the facets; returns the area of these facets.
  double remove(const std::vector<Index>& facets, Index surface);
  /// Removes the origins (input triangles) for which `goes` returns true from the facets; returns their total area.
  double remove(const std::vector<Index>& facets, const std::function<bool(const PolygonSoup::Origin&)>& goes);
  /// Returns the triangle soup that is left after trimming, without unused points.
  PolygonSoup result() const;
};

/// Whether an edge at which the cutting surface ends shows on which side of it a piece lies that continues beyond that
/// edge in the map. It does for pieces of faults, which stand on the edge. It does not for horizons cut by horizons,
/// which a fault may separate.
enum class BeyondEnd : std::uint8_t { has_a_side, has_none };

struct Piece {
  std::vector<Index> facets;  ///< facets of this piece of a surface, ascending; they may also belong to other surfaces
  double area = 0;
  Index largest = no_index;  ///< facet
  /// Lengths of the edges at which this piece of a surface meets the surface that cuts it: from above, and from below.
  double above = 0, below = 0;
  double free_border = 0;  ///< length of this surface piece's edges at which no other facet of any surface lies
  double contact = 0;      ///< length of this surface piece's edges that lie on cutting surfaces
};

/// Returns pieces of surface `x`: its facets joined across edges at which no facet of a surface in `cutters` lies.
/// Facets that x shares with a cutter are left out. If `sides` (those of the only cutter) is not null, contacts from
/// above and below are distinguished by exact orientation around the edge. Edges of the surfaces in `dividers`, at
/// which the cutter's blocks end, also separate pieces, but have no other effect.
std::vector<Piece> pieces_of(const WorkingSoup& working, Index x, const std::vector<Index>& cutters,
                             const UpwardSides* sides, BeyondEnd beyond = BeyondEnd::has_a_side,
                             const std::vector<Index>& dividers = {});
/// Returns pieces of the facets that `is_mine` accepts, joined across edges at which no surface in `cutters` lies.
std::vector<Piece> pieces_of(const WorkingSoup& working, const std::function<bool(Index)>& is_mine,
                             const std::vector<Index>& cutters, const UpwardSides* sides,
                             BeyondEnd beyond = BeyondEnd::has_a_side, const std::vector<Index>& dividers = {});

/// Returns the side of surface y on which a piece of another surface lies: 1 above, -1 below, 0 unknown. The edges at
/// which both meet decide, otherwise the vertical through the piece's largest facet.
int side_of(const WorkingSoup& working, const Piece& piece, Index y, const UpwardSides& sides);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Pieces into which one surface of a soup is cut by others, and their sides.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "common/edge_uses.hpp"
#include "geomesh/geomodel/arrangement.hpp"
#include "naming/sheets.hpp"

namespace geomesh::geomodel {

/// A soup being trimmed: facets lose origins; those without origins are gone.
struct WorkingSoup {
  const PolygonSoup& soup;
  std::vector<EdgeUse> uses;                              ///< of all facets, sorted
  std::vector<std::vector<PolygonSoup::Origin>> origins;  ///< what is left, per facet

  explicit WorkingSoup(const PolygonSoup& s);
  const PolygonSoup::Origin* origin_of(Index facet, Index surface) const;
  bool has(Index facet, Index surface) const { return origin_of(facet, surface) != nullptr; }
  bool alive(Index facet) const { return !origins[facet].empty(); }
  double area(Index facet) const;
  Vec3 centre(Index facet) const;
  /// Takes `surface` off the facets; gives their area.
  double remove(const std::vector<Index>& facets, Index surface);
  /// Takes the origins that `goes` accepts off the facets; gives the area of the triangles' parts that went.
  double remove(const std::vector<Index>& facets, const std::function<bool(const PolygonSoup::Origin&)>& goes);
  /// The soup that is left, points that nothing uses dropped.
  PolygonSoup result() const;
};

/// Whether an edge where the cutting surface ends tells the side of what goes on beyond it in the map. It does for
/// faults, which stand on that end. A horizon beyond it may be the one across a fault, thrown to that height.
enum class BeyondEnd : std::uint8_t { has_a_side, has_none };

struct Piece {
  std::vector<Index> facets;  ///< ascending, of the surface alone or with others
  double area = 0;
  Index largest = no_index;     ///< facet
  double above = 0, below = 0;  ///< length of contact from above and from below with the cutting surface
  double free_border = 0;       ///< length of edges where nothing else is
  double contact = 0;           ///< length of edges on other surfaces
};

/// Facets of surface `x` joined across edges that no facet of a surface in `cutters` touches. Facets that x shares with
/// a cutter are left out. Where `sides` is given (of the only cutter), contacts are told apart by exact orientation
/// about the edge. Facets are not joined across edges of `dividers` either, which count for nothing else: the cutter's
/// blocks end there.
std::vector<Piece> pieces_of(const WorkingSoup& working, Index x, const std::vector<Index>& cutters,
                             const UpwardSides* sides, BeyondEnd beyond = BeyondEnd::has_a_side,
                             const std::vector<Index>& dividers = {});
/// The same for the facets that `is_mine` accepts.
std::vector<Piece> pieces_of(const WorkingSoup& working, const std::function<bool(Index)>& is_mine,
                             const std::vector<Index>& cutters, const UpwardSides* sides,
                             BeyondEnd beyond = BeyondEnd::has_a_side, const std::vector<Index>& dividers = {});

/// Side of a piece against surface y: 1 above, -1 below, 0 unknown: by its contacts, else on the vertical through its
/// largest facet.
int side_of(const WorkingSoup& working, const Piece& piece, Index y, const UpwardSides& sides);

}  // namespace geomesh::geomodel

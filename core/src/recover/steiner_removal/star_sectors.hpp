// SPDX-License-Identifier: MIT
/// @file
/// Sectors of an added point's star: the parts between the fans of its facets, and the sheets that may divide one.
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "recover/steiner_removal/star_fans.hpp"

namespace geomesh::recover {

struct Sector {
  std::vector<CellIndex> cells;
  std::map<std::size_t, unsigned> fans;  ///< bits by number of the fan: bit 1: the sector is above it, bit 2: below
  Vec3 inward;                           ///< sum of the inner unit normals of the fans
  std::vector<Tetrahedron> filling;

  bool wraps_round() const {
    return std::any_of(fans.begin(), fans.end(), [](const auto& f) { return f.second == 3u; });
  }
};

/// Returns the sectors of x's star, whose cells are sorted.
std::vector<Sector> gather_sectors(const ConstrainedMesh& mesh, VertexIndex x, const StarFans& around,
                                   const std::vector<CellIndex>& star);

/// Returns the triangles that replace those at x, as seen from the sector.
std::vector<Triangle> sheets_of(const Sector& s, const StarFans& around);

/// Returns vertices connected with both ends inside the sector, those that divide it most evenly first.
std::vector<VertexIndex> sheet_apexes(const ConstrainedMesh& mesh, VertexIndex x, const StarFans& around,
                                      const Sector& s);

}  // namespace geomesh::recover

// SPDX-License-Identifier: MIT
/// @file
/// Sectors of an added point's star: the parts between the fans of its facets, and sheets that may divide them.
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "recover/steiner_removal/star_fans.hpp"

namespace geomesh::recover {

struct Sector {
  std::vector<CellIndex> cells;
  /// for each number of a fan: 1 if the sector is above the fan, 2 if it is below, 3 if it is both
  std::map<std::size_t, unsigned> fans;
  Vec3 inward;  ///< sum of the inner unit normals of the fans
  std::vector<Tetrahedron> filling;

  bool wraps_round() const {
    return std::any_of(fans.begin(), fans.end(), [](const auto& f) { return f.second == 3u; });
  }
};

/// Returns the sectors of the star of x. `star` contains the cells of the star, sorted.
std::vector<Sector> gather_sectors(const ConstrainedMesh& mesh, VertexIndex x, const StarFans& around,
                                   const std::vector<CellIndex>& star);

/// Returns the triangles that replace those at x, in the orientation as seen from the sector.
std::vector<Triangle> sheets_of(const Sector& s, const StarFans& around);

/// Returns vertices of the sector that are connected with both ends of the segment, the most even division first.
std::vector<VertexIndex> sheet_apexes(const ConstrainedMesh& mesh, VertexIndex x, const StarFans& around,
                                      const Sector& s);

}  // namespace geomesh::recover

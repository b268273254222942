// SPDX-License-Identifier: MIT
/// @file
/// Sectors of an added point's star: the parts into which facets at the point, and additional triangles, divide it.
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "recover/steiner_removal/star_fans.hpp"

namespace geomesh::recover {

struct Sector {
  std::vector<CellIndex> cells;
  /// by number of the facet in StarFans::fans: 1 if the sector lies above the facet, 2 if below, 3 if on both sides
  std::map<std::size_t, unsigned> fans;
  Vec3 inward;  ///< sum of the unit normals of the facets around the sector, pointing into it
  std::vector<Tetrahedron> filling;

  bool wraps_round() const {
    return std::any_of(fans.begin(), fans.end(), [](const auto& f) { return f.second == 3u; });
  }
};

/// Returns the sectors of the star of x: the parts into which facets divide it. `star` has its cells, sorted.
std::vector<Sector> gather_sectors(const ConstrainedMesh& mesh, VertexIndex x, const StarFans& around,
                                   const std::vector<CellIndex>& star);

/// Returns new triangles for the facets around a sector, without x, counter-clockwise as seen from the sector.
std::vector<Triangle> sheets_of(const Sector& s, const StarFans& around);

/// Returns vertices that form triangles with the segment's ends which divide a sector, the most even division first.
std::vector<VertexIndex> sheet_apexes(const ConstrainedMesh& mesh, VertexIndex x, const StarFans& around,
                                      const Sector& s);

}  // namespace geomesh::recover

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
  /// by row in StarFans::fans: 1 if the sector of a star lies above the facet, 2 if below, 3 if on both sides
  std::map<std::size_t, unsigned> fans;
  Vec3 inward;  ///< sum of the unit normals, pointing into the sector, of the facets that bound it
  std::vector<Tetrahedron> filling;

  bool wraps_round() const {
    return std::any_of(fans.begin(), fans.end(), [](const auto& f) { return f.second == 3u; });
  }
};

/// Returns the sectors of the star of x: the parts into which facets divide it. `star` has its cells, sorted.
std::vector<Sector> gather_sectors(const ConstrainedMesh& mesh, VertexIndex x, const StarFans& around,
                                   const std::vector<CellIndex>& star);

/// Returns the triangles without x of the facets that bound a sector of its star, counter-clockwise seen from there.
std::vector<Triangle> sheets_of(const Sector& s, const StarFans& around);

/// Returns vertices that divide a sector of the star of x by a triangle with the segment's two ends, most evenly first.
std::vector<VertexIndex> sheet_apexes(const ConstrainedMesh& mesh, VertexIndex x, const StarFans& around,
                                      const Sector& s);

}  // namespace geomesh::recover

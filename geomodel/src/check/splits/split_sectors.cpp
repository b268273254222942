// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/splits/split_sectors.hpp"

#include <algorithm>

#include "common/union_find.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// A face of a tetrahedron; `key` has its sorted vertices, and `corner` its corners in the same order.
struct CellFace {
  Triangle key;
  std::array<Index, 3> corner;  ///< corners of the face; corner i of tetrahedron t is stored as 4 t + i
};

std::vector<CellFace> faces_of(const std::vector<Tetrahedron>& cells) {
  std::vector<CellFace> faces;
  faces.reserve(4 * cells.size());
  for (std::size_t t = 0; t < cells.size(); ++t)
    for (const auto& face : outward_face) {
      std::array<std::pair<VertexIndex, Index>, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(face[k]);
        corners[k] = {cells[t][i], static_cast<Index>(4 * t + i)};
      }
      std::sort(corners.begin(), corners.end());
      faces.push_back({{corners[0].first, corners[1].first, corners[2].first},
                       {corners[0].second, corners[1].second, corners[2].second}});
    }
  std::sort(faces.begin(), faces.end(), [](const CellFace& a, const CellFace& b) { return a.key < b.key; });
  return faces;
}

}  // namespace

std::vector<VertexIndex> nodes_unlike_sectors(const JoinedCells& joined, const std::vector<Tetrahedron>& nodes,
                                              const std::set<Triangle>& split) {
  const std::vector<CellFace> faces = faces_of(joined.tetrahedra);
  UnionFind sectors(4 * joined.tetrahedra.size());
  for (std::size_t f = 0; f + 1 < faces.size(); ++f)
    if (faces[f].key == faces[f + 1].key && !split.contains(faces[f].key))
      for (std::size_t k = 0; k < 3; ++k) sectors.unite(faces[f].corner[k], faces[f + 1].corner[k]);
  struct Seen {
    VertexIndex place;
    Index sector;
    VertexIndex node;
    auto operator<=>(const Seen&) const = default;
  };
  std::vector<Seen> seen;
  for (std::size_t t = 0; t < nodes.size(); ++t)
    for (std::size_t i = 0; i < 4; ++i)
      seen.push_back({joined.tetrahedra[t][i], sectors.find(static_cast<Index>(4 * t + i)), nodes[t][i]});
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  std::vector<VertexIndex> unlike;
  for (std::size_t from = 0, to = 0; from < seen.size(); from = to) {
    std::set<Index> of_sectors;
    std::set<VertexIndex> of_nodes;
    for (to = from; to < seen.size() && seen[to].place == seen[from].place; ++to) {
      of_sectors.insert(seen[to].sector);
      of_nodes.insert(seen[to].node);
    }
    if (of_sectors.size() != to - from || of_nodes.size() != to - from) unlike.push_back(seen[from].place);
  }
  return unlike;
}

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
#include "build/throw_blocks.hpp"

#include <algorithm>
#include <map>

#include "sets/sheets.hpp"
#include "sets/soup_edges.hpp"
#include "sets/sums.hpp"

namespace geomesh::geomodel {
namespace {

Vec3 centre_of(const TriangulatedSurface& s, const Triangle& t) {
  return (1.0 / 3) * (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]);
}

/// Sheets joined across edges, as the least triangle of each.
std::vector<Index> sheet_of_triangles(const TriangulatedSurface& s) {
  const std::vector<VertexIndex> merged = merge_equal_points(s.points);
  std::map<std::pair<VertexIndex, VertexIndex>, Index> first;
  UnionFind joined(s.triangles.size());
  for (Index t = 0; t < s.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexIndex a = merged[s.triangles[t][i]], b = merged[s.triangles[t][(i + 1) % 3]];
      const auto [at, is_new] = first.emplace(std::pair(std::min(a, b), std::max(a, b)), t);
      if (!is_new) joined.unite(at->second, t);
    }
  std::vector<Index> sheet(s.triangles.size());
  for (Index t = 0; t < sheet.size(); ++t) sheet[t] = joined.find(t);
  return sheet;
}

/// A fault's triangles with normals to one side.
class Sides {
 public:
  explicit Sides(const TriangulatedSurface& fault) {
    const UpwardSides up = orient_upward(fault);
    for (Index t = 0; t < fault.triangles.size(); ++t) {
      const Triangle& v = fault.triangles[t];
      const Vec3 n = cross(fault.points[v[1]] - fault.points[v[0]], fault.points[v[2]] - fault.points[v[0]]);
      centres_.push_back(centre_of(fault, v));
      normals_.push_back(up.as_stored[t] ? n : -1.0 * n);
    }
  }
  bool is_above(const Vec3& p) const {
    std::size_t nearest = 0;
    for (std::size_t t = 1; t < centres_.size(); ++t)
      if (norm(p - centres_[t]) < norm(p - centres_[nearest])) nearest = t;
    return !centres_.empty() && dot(p - centres_[nearest], normals_[nearest]) > 0;
  }

 private:
  std::vector<Vec3> centres_, normals_;
};

}  // namespace

std::vector<Index> sort_into_blocks(const TriangulatedSurface& horizon, const std::vector<const TriangulatedSurface*>& faults) {
  const std::vector<Index> sheet = sheet_of_triangles(horizon);
  std::map<Index, std::vector<double>> balance;  // per sheet and fault: area above less area below
  std::vector<Sides> sides;
  for (const TriangulatedSurface* fault : faults) sides.emplace_back(*fault);
  for (Index t = 0; t < sheet.size(); ++t) {
    auto& sums = balance.try_emplace(sheet[t], faults.size(), 0.0).first->second;
    const Triangle& v = horizon.triangles[t];
    const double area = triangle_area(horizon.points[v[0]], horizon.points[v[1]], horizon.points[v[2]]);
    for (std::size_t f = 0; f < sides.size(); ++f) sums[f] += sides[f].is_above(centre_of(horizon, v)) ? area : -area;
  }
  std::map<std::vector<bool>, Index> block_of_sides;
  std::vector<Index> block;
  for (Index t = 0; t < sheet.size(); ++t) {
    std::vector<bool> key;
    for (const double sum : balance.at(sheet[t])) key.push_back(sum > 0);
    block.push_back(block_of_sides.emplace(key, static_cast<Index>(block_of_sides.size())).first->second);
  }
  return block;
}

void extend_blocks(TriangulatedSurface& horizon, std::vector<Index>& block, Extend how, const Box3& box, const BuildLog& log) {
  if (block.empty()) return;
  const TriangulatedSurface given = horizon;
  const Index n_blocks = *std::max_element(block.begin(), block.end()) + 1;
  for (Index b = 0; b < n_blocks; ++b) {
    TriangulatedSurface part = given;
    part.triangles.clear();
    for (std::size_t t = 0; t < given.triangles.size(); ++t)
      if (block[t] == b) part.triangles.push_back(given.triangles[t]);
    const std::size_t n_given = part.triangles.size();
    extend_to_box(part, how, box, log, b);
    const auto shift = static_cast<VertexIndex>(horizon.points.size() - given.points.size());
    horizon.points.insert(horizon.points.end(), part.points.begin() + static_cast<std::ptrdiff_t>(given.points.size()), part.points.end());
    for (std::size_t t = n_given; t < part.triangles.size(); ++t) {
      Triangle v = part.triangles[t];
      for (VertexIndex& row : v)
        if (row >= given.points.size()) row += shift;
      horizon.triangles.push_back(v);
      block.push_back(b);
    }
  }
}

}  // namespace geomesh::geomodel

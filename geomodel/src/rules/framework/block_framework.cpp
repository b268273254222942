// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/framework/block_framework.hpp"

#include <algorithm>
#include <vector>

#include "common/by_rounding.hpp"
#include "common/union_find.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/build_model.hpp"
#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "rules/framework/end_on_faults.hpp"
#include "rules/framework/fault_truncations.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns the part of a convex polygon on the inner side of the face of a tetrahedron that is opposite a corner.
std::vector<Vec3> cut_at_face(const std::vector<Vec3>& polygon, const std::array<Vec3, 4>& t, std::size_t corner) {
  const Vec3 &a = t[(corner + 1) % 4], &b = t[(corner + 2) % 4], &c = t[(corner + 3) % 4];
  Vec3 inward = cross(b - a, c - a);
  if (dot(inward, t[corner] - a) < 0) inward = -1.0 * inward;
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = dot(inward, p - a), at_q = dot(inward, q - a);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}

bool has_area(const std::vector<Vec3>& polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i)
    if (norm(cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0])) > 0) return true;
  return false;
}

}  // namespace

BlockFramework::BlockFramework(const BuiltSurfaces& built, const ModelRules& rules) {
  const ArrangedWalls walls = arrange_walls(built, rules, {SurfaceKind::fault, SurfaceKind::body});
  WorkingSoup working(walls.soup);
  std::vector<double> area(walls.surfaces.size(), 0);
  std::vector<std::string> notes;  // notes are given when the soup of the model itself is cut
  end_faults(working, walls.surfaces, built.rows, rules, {area, notes});
  const PolygonSoup soup = working.result();
  const ModelPlc plc = make_plc(soup, walls.surfaces, {});
  ConstrainedTetrahedralization mesh = tetrahedralize(plc.plc);
  has_tip_.assign(mesh.n_components, false);
  const auto walls_at = [&](Index facet) {
    std::vector<Index> at;
    const Index row = plc.facet_soup[plc.facet_soup_offsets[facet]];
    for (Index k = soup.origin_offsets[row]; k < soup.origin_offsets[row + 1]; ++k)
      if (at.empty() || at.back() != soup.origins[k].surface) at.push_back(soup.origins[k].surface);
    return at;
  };
  for (const auto& face : mesh.faces) {
    const Index below = component_of(mesh, face.tetrahedron_below), above = component_of(mesh, face.tetrahedron_above);
    if (below == above && below != no_index) has_tip_[below] = true;
    if (below == no_index || above == no_index) continue;
    const Vec3 &a = mesh.points[face.vertices[0]], &b = mesh.points[face.vertices[1]],
               &c = mesh.points[face.vertices[2]];
    const double up = cross(b - a, c - a).z;
    const std::vector<Index> at = walls_at(face.facet);
    for (const Index wall : at) {
      side_[{above, wall}] += up;
      side_[{below, wall}] -= up;
    }
    contacts_.emplace(std::min(below, above), std::max(below, above), at);
  }
  block_ = std::move(mesh.component);
  bounds_.resize(n_blocks());
  place_.resize(n_blocks());
  std::vector<double> largest(n_blocks(), 0);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const Tetrahedron& v = mesh.tetrahedra[t];
    for (const VertexIndex w : v) bounds_[block_[t]].add(mesh.points[w]);
    const Vec3 &a = mesh.points[v[0]], &b = mesh.points[v[1]], &c = mesh.points[v[2]], &d = mesh.points[v[3]];
    const double volume = std::abs(dot(b - a, cross(c - a, d - a)));
    if (!(volume > largest[block_[t]])) continue;
    largest[block_[t]] = volume;
    place_[block_[t]] = 0.25 * ((a + b) + (c + d));
  }
  search_ = std::make_unique<TetrahedronSearch>(std::move(mesh.points), std::move(mesh.tetrahedra));
}

int BlockFramework::side_of(Index block, Index wall) const {
  const auto at = side_.find({block, wall});
  return at == side_.end() || at->second == 0 ? 0 : at->second > 0 ? 1 : -1;
}

std::vector<int> BlockFramework::sides_of(Index wall) const {
  const auto is_of_wall = [wall](const std::vector<Index>& walls) { return std::ranges::count(walls, wall) > 0; };
  UnionFind joined(n_blocks());
  for (const auto& [a, b, walls] : contacts_)
    if (!is_of_wall(walls)) joined.unite(a, b);
  std::vector<double> above(n_blocks(), 0);  // by the first block of those that hang together
  for (const auto& [at, area] : side_)
    if (at.second == wall) above[joined.find(at.first)] += area;
  for (const auto& [a, b, walls] : contacts_)
    if (is_of_wall(walls) && joined.find(a) == joined.find(b)) above[joined.find(a)] = 0;
  std::vector<int> sides;
  for (Index b = 0; b < n_blocks(); ++b) {
    const double area = above[joined.find(b)];
    sides.push_back(area > 0 ? 1 : area < 0 ? -1 : 0);
  }
  return sides;
}

Index BlockFramework::block_at(const Vec3& p) const {
  Index last = no_index;
  return block_at(p, last);
}

Index BlockFramework::block_at(const Vec3& p, Index& last) const {
  const Index found = search_->find(p, last);
  if (found == no_index) return no_index;
  last = found;
  return block_[found];
}

Index BlockFramework::block_of(const std::array<Vec3, 3>& triangle, Index& last) const {
  const auto& [a, b, c] = triangle;
  const Vec3 centre = (1.0 / 3) * (a + b + c);
  for (const Vec3& p : {centre, 0.5 * (centre + a), 0.5 * (centre + b), 0.5 * (centre + c), a, b, c})
    if (const Index block = block_at(p, last); block != no_index) return block;
  return no_index;
}

template <class F>
void BlockFramework::for_each_piece(const std::array<Vec3, 3>& triangle, F&& visit) const {
  Box3 box;
  for (const Vec3& p : triangle) box.add(p);
  search_->boxes().boxes_meeting(box, [&](Index t) {
    std::vector<Vec3> polygon(triangle.begin(), triangle.end());
    for (std::size_t k = 0; k < 4; ++k) polygon = cut_at_face(polygon, search_->corners(t), k);
    visit(block_[t], polygon);
  });
}

bool BlockFramework::overlaps(Index block, const std::array<Vec3, 3>& triangle) const {
  bool found = false;
  for_each_piece(triangle, [&](Index at, const std::vector<Vec3>& polygon) {
    found = found || (at == block && has_area(polygon));
  });
  return found;
}

std::map<Index, double> BlockFramework::areas(const std::array<Vec3, 3>& triangle) const {
  std::map<Index, double> area;
  for_each_piece(triangle, [&](Index block, const std::vector<Vec3>& polygon) {
    Vec3 sum{0, 0, 0};
    for (std::size_t i = 2; i < polygon.size(); ++i)
      sum = sum + cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    if (norm(sum) > 0) area[block] += norm(sum) / 2;
  });
  return area;
}

std::set<Index> BlockFramework::blocks_on(const Vec3& a, const Vec3& b) const {
  std::set<Index> blocks;
  for_each_piece({a, b, b}, [&](Index block, const std::vector<Vec3>& polygon) {
    const bool has_length =
        std::ranges::any_of(polygon, [&](const Vec3& p) { return norm(p - polygon[0]) > by_rounding * norm(b - a); });
    if (has_length) blocks.insert(block);
  });
  return blocks;
}

}  // namespace geomesh::geomodel

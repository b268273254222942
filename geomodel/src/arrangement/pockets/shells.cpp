// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/pockets/shells.hpp"

#include <algorithm>
#include <span>
#include <tuple>

#include "common/union_find.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

VertexIndex third_corner(const Triangle& t, const EdgeFacets::Use& use) {
  for (const VertexIndex v : t)
    if (v != use.a && v != use.b) return v;
  return no_vertex;
}

/// Orders facets around an edge from a to b counter-clockwise, seen against its direction, from the first facet on.
class AngleOrder {
 public:
  AngleOrder(const Complex& complex, const EdgeFacets::Use& first)
      : complex_(complex), a_(complex.points[first.a]), b_(complex.points[first.b]), first_(corner(first)) {}

  bool operator()(const EdgeFacets::Use& one, const EdgeFacets::Use& other) const {
    const int x = part_of_turn(one), y = part_of_turn(other);
    if (x != y) return x < y;
    return (x == 1 || x == 3) && orient3d(a_, b_, corner(one), corner(other)) == Sign::positive;
  }

 private:
  const Vec3& corner(const EdgeFacets::Use& use) const {
    return complex_.points[third_corner(complex_.facets[use.facet], use)];
  }
  /// Returns the angle about an edge from its first facet to another: 0 none, 1 below, 2 equal to, 3 above 180 degrees.
  int part_of_turn(const EdgeFacets::Use& use) const {
    const Vec3& p = corner(use);
    if (p == first_) return 0;
    const Sign side = orient3d(a_, b_, first_, p);
    return side == Sign::positive ? 1 : side == Sign::zero ? 2 : 3;
  }

  const Complex& complex_;
  const Vec3 &a_, &b_, &first_;
};

/// Returns the sides of a facet that face forward and backward in the counter-clockwise order around an edge.
FacetSide side_ahead(const EdgeFacets::Use& use) { return 2 * std::size_t{use.facet} + (use.forward ? 0 : 1); }
FacetSide side_behind(const EdgeFacets::Use& use) { return 2 * std::size_t{use.facet} + (use.forward ? 1 : 0); }

}  // namespace

EdgeFacets edge_facets(const Complex& complex) {
  EdgeFacets edges;
  edges.uses.reserve(3 * complex.facets.size());
  for (Index f = 0; f < complex.facets.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexIndex from = complex.facets[f][k], to = complex.facets[f][(k + 1) % 3];
      edges.uses.push_back({std::min(from, to), std::max(from, to), f, from < to});
    }
  std::sort(edges.uses.begin(), edges.uses.end(),
            [](const auto& x, const auto& y) { return std::tie(x.a, x.b, x.facet) < std::tie(y.a, y.b, y.facet); });
  for (std::size_t i = 0; i < edges.uses.size(); ++i)
    if (i == 0 || edges.uses[i].a != edges.uses[i - 1].a || edges.uses[i].b != edges.uses[i - 1].b)
      edges.offsets.push_back(i);
  edges.offsets.push_back(edges.uses.size());
  return edges;
}

std::vector<std::vector<FacetSide>> shells_of(const Complex& complex, const EdgeFacets& edges) {
  UnionFind sides(2 * complex.facets.size());
  std::vector<EdgeFacets::Use> turn;
  for (std::size_t e = 0; e + 1 < edges.offsets.size(); ++e) {
    turn.assign(edges.uses.begin() + static_cast<std::ptrdiff_t>(edges.offsets[e]),
                edges.uses.begin() + static_cast<std::ptrdiff_t>(edges.offsets[e + 1]));
    if (turn.size() > 2) std::sort(turn.begin() + 1, turn.end(), AngleOrder(complex, turn[0]));
    for (std::size_t k = 0; k < turn.size(); ++k)
      sides.unite(static_cast<Index>(side_ahead(turn[k])),
                  static_cast<Index>(side_behind(turn[(k + 1) % turn.size()])));
  }
  std::vector<std::vector<FacetSide>> shells;
  std::vector<Index> shell_of(2 * complex.facets.size(), no_index);
  for (FacetSide s = 0; s < shell_of.size(); ++s) {
    Index& shell = shell_of[sides.find(static_cast<Index>(s))];
    if (shell == no_index) {
      shell = static_cast<Index>(shells.size());
      shells.emplace_back();
    }
    shells[shell].push_back(s);
  }
  return shells;
}

}  // namespace geomesh::geomodel::arrangement

// SPDX-License-Identifier: MIT
#include "quality/creases.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "common/geometry.hpp"
#include "quality/soup_star.hpp"

namespace geomesh {

namespace {

/// A facet of the input as seen from one of its edges.
struct Use {
  VertexIndex a, b;  ///< ascending
  Index patch, facet;
  Vec3 inward;  ///< direction in the facet's plane, from the edge into the facet
};

std::vector<Use> uses_of_edges(const PiecewiseLinearComplex& plc, std::span<const Index> facet_patch) {
  std::vector<Use> uses;
  for (Index f = 0; f < plc.n_facets(); ++f) {
    const auto loop = plc.outer_loop(f);
    const Vec3 n = loop_normal(plc.points, loop);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const VertexIndex a = loop[i], b = loop[(i + 1) % loop.size()];
      uses.push_back({std::min(a, b), std::max(a, b), facet_patch[f], f, cross(n, plc.points[b] - plc.points[a])});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const Use& s, const Use& t) {
    return std::tie(s.a, s.b, s.patch, s.facet) < std::tie(t.a, t.b, t.patch, t.facet);
  });
  return uses;
}

bool are_along_one_edge(const Use& s, const Use& t) { return s.a == t.a && s.b == t.b && s.patch == t.patch; }

}  // namespace

InputCreases::InputCreases(const PiecewiseLinearComplex& plc, std::span<const Index> facet_patch, double degrees,
                           double reach)
    : degrees_(degrees), reach_(reach) {
  const std::vector<Use> uses = uses_of_edges(plc, facet_patch);
  std::vector<search::ClosestPointTrees::Item> creases;
  for (std::size_t i = 0, j; i < uses.size(); i = j) {
    bool is_crease = false;
    for (j = i + 1; j < uses.size() && are_along_one_edge(uses[i], uses[j]); ++j)
      for (std::size_t k = i; k < j; ++k) is_crease |= angle_between(uses[k].inward, uses[j].inward) < degrees;
    const Vec3 &a = plc.points[uses[i].a], &b = plc.points[uses[i].b];
    if (is_crease) creases.push_back({{a, b, b}, uses[i].patch, static_cast<Index>(creases.size())});
  }
  const auto last = std::max_element(facet_patch.begin(), facet_patch.end());
  edges_ = search::ClosestPointTrees(std::move(creases), last == facet_patch.end() ? 0 : *last + std::size_t{1});
}

bool InputCreases::has_fold(Index patch, const Vec3& a, const Vec3& b, const Vec3& x, const Vec3& y) const {
  const Vec3 along = b - a;
  if (!(angle_between(cross(along, x - a), cross(along, y - a)) < degrees_)) return false;
  const std::array places{a, 0.5 * (a + b), b};
  return std::all_of(places.begin(), places.end(),
                     [&](const Vec3& p) { return edges_.closest(p, patch, reach_).distance <= reach_; });
}

}  // namespace geomesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/snap/join_rule.hpp"

#include <algorithm>
#include <compare>
#include <iterator>
#include <utility>

namespace geomesh::geomodel::arrangement {

namespace {

void add_pairs(std::span<const Index> a, std::span<const Index> b, std::set<SurfacePair>& pairs) {
  for (const Index x : a)
    for (const Index y : b)
      if (x != y) pairs.insert(surface_pair(x, y));
}

}  // namespace

std::set<SurfacePair> surfaces_in_contact(const Complex& complex, const Contacts& contacts) {
  std::set<SurfacePair> pairs;
  const auto add = [&](Index f, Index g) {
    add_pairs(surfaces_of(complex.origins.of(f)), surfaces_of(complex.origins.of(g)), pairs);
  };
  for (const FacetContact& c : contacts.facets)
    if (c.other != no_index) add(c.facet, c.other);
  for (const Overlap& o : contacts.overlaps) add(o.a, o.b);
  return pairs;
}

std::set<SurfacePair> surfaces_that_meet(const Complex& complex, const Contacts& contacts) {
  std::set<SurfacePair> pairs = surfaces_in_contact(complex, contacts);
  std::vector<Index> first(complex.points.size(), no_index);  // for each vertex: one of the surfaces that have it
  for (Index f = 0; f < complex.facets.size(); ++f)
    for (const Index surface : surfaces_of(complex.origins.of(f)))
      for (const VertexIndex v : complex.facets[f]) {
        if (first[v] == no_index) first[v] = surface;
        if (first[v] != surface) pairs.insert(surface_pair(first[v], surface));
      }
  return pairs;
}

JoinRule::Set JoinRule::number(std::vector<Index> surfaces) {
  const auto [at, is_new] = numbers_.try_emplace(std::move(surfaces), static_cast<Set>(sets_.size()));
  if (is_new) sets_.push_back(at->first);
  return at->second;
}

void JoinRule::index_edges(const Complex& complex, const std::function<bool(VertexIndex, VertexIndex)>& lies_on_box) {
  of_edge_.clear();
  if (!restricts_) return;
  struct EdgeOfSurface {
    VertexIndex a, b;
    Index surface;
    auto operator<=>(const EdgeOfSurface&) const = default;
  };
  const auto is_asked = [this](VertexIndex v) { return asked_.empty() || v >= asked_.size() || asked_[v] != 0; };
  std::vector<EdgeOfSurface> sides;
  if (asked_.empty()) sides.reserve(3 * complex.facets.size());
  for (Index f = 0; f < complex.facets.size(); ++f) {
    Index last = no_index;  // a facet's origins (input triangles) are grouped by surface
    for (const Origin& o : complex.origins.of(f)) {
      if (o.surface == std::exchange(last, o.surface)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexIndex a = complex.facets[f][k], b = complex.facets[f][(k + 1) % 3];
        if (a != b && is_asked(a) && is_asked(b)) sides.push_back({std::min(a, b), std::max(a, b), o.surface});
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<Index> surfaces;
  for (std::size_t i = 0, j; i < sides.size(); i = j) {
    surfaces.clear();
    for (j = i; j < sides.size() && sides[j].a == sides[i].a && sides[j].b == sides[i].b; ++j)
      if (surfaces.empty() || surfaces.back() != sides[j].surface) surfaces.push_back(sides[j].surface);
    const bool is_border = j - i == 1 && !lies_on_box(sides[i].a, sides[i].b);
    const Set last = of_edge_.empty() ? none : of_edge_.back().second.surfaces;
    const Set now = sets_[last] == surfaces ? last : number(surfaces);
    of_edge_.push_back({EdgeKey{sides[i].a, sides[i].b}, Thing{now, is_border}});
  }
}

void JoinRule::index(const Complex& complex, const std::function<bool(VertexIndex, VertexIndex)>& lies_on_box,
                     std::vector<std::uint8_t> asked) {
  asked_ = std::move(asked);
  of_vertex_.assign(complex.points.size(), {});
  index_edges(complex, lies_on_box);
  for (const auto& [edge, thing] : of_edge_)
    for (const VertexIndex v : {edge.first, edge.second}) of_vertex_[v] = united(of_vertex_[v], thing);
}

JoinRule::Thing JoinRule::of_edge(VertexIndex a, VertexIndex b) const {
  const EdgeKey edge = edge_key(a, b);
  const auto at = std::lower_bound(of_edge_.begin(), of_edge_.end(), edge,
                                   [](const auto& entry, const EdgeKey& e) { return entry.first < e; });
  return at == of_edge_.end() || at->first != edge ? Thing{} : at->second;
}

JoinRule::Thing JoinRule::of_facet(const Complex& complex, Index facet) {
  return restricts_ ? Thing{number(surfaces_of(complex.origins.of(facet))), false} : Thing{};
}

JoinRule::Thing JoinRule::united(const Thing& a, const Thing& b) {
  const bool is_border = a.is_border || b.is_border;
  if (a.surfaces == b.surfaces || b.surfaces == none) return {a.surfaces, is_border};
  if (a.surfaces == none) return {b.surfaces, is_border};
  std::vector<Index> all;
  std::set_union(sets_[a.surfaces].begin(), sets_[a.surfaces].end(), sets_[b.surfaces].begin(), sets_[b.surfaces].end(),
                 std::back_inserter(all));
  return {number(std::move(all)), is_border};
}

void JoinRule::set_vertex(VertexIndex v, const Thing& thing) {
  if (!restricts_) return;
  if (v >= of_vertex_.size()) of_vertex_.resize(v + std::size_t{1});
  of_vertex_[v] = thing;
}

bool JoinRule::allows(const Thing& a, const Thing& b) const {
  constexpr std::size_t most_sets = 512;
  if (!restricts_) return true;
  if (sets_.size() > most_sets) return find_whether_allowed(a, b);
  known_.resize(2 * most_sets * most_sets, 0);
  std::uint8_t& known = known_[2 * (most_sets * a.surfaces + b.surfaces) + (a.is_border || b.is_border ? 1 : 0)];
  if (known == 0) known = find_whether_allowed(a, b) ? 1 : 2;
  return known == 1;
}

bool JoinRule::find_whether_allowed(const Thing& a, const Thing& b) const {
  const std::vector<Index>&x = sets_[a.surfaces], &y = sets_[b.surfaces];
  const auto is_fixed = [&](const std::vector<Index>& of) { return !of.empty() && of.back() >= first_fixed_; };
  if (is_fixed(x) || is_fixed(y)) return false;
  if (joins_all_) return true;
  const auto any_of = [&](const std::set<SurfacePair>& pairs) {
    return std::any_of(x.begin(), x.end(), [&](Index s) {
      return std::any_of(y.begin(), y.end(), [&](Index t) { return pairs.contains(surface_pair(s, t)); });
    });
  };
  return ((!needs_border_ || a.is_border || b.is_border) && any_of(meeting_)) || any_of(following_);
}

}  // namespace geomesh::geomodel::arrangement

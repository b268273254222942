// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Rules for which surfaces may be merged: all surfaces, or only those that meet somewhere.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "arrangement/model/contacts.hpp"

namespace geomesh::geomodel::arrangement {

using SurfacePair = std::pair<Index, Index>;  ///< indices of two surfaces, the smaller first
inline SurfacePair surface_pair(Index a, Index b) { return a < b ? SurfacePair{a, b} : SurfacePair{b, a}; }

/// Returns pairs of surfaces whose facets touch, cross or overlap.
std::set<SurfacePair> surfaces_in_contact(const Complex& complex, const Contacts& contacts);
/// Returns the pairs of surfaces in contact (surfaces_in_contact) and the pairs that share a vertex.
std::set<SurfacePair> surfaces_that_meet(const Complex& complex, const Contacts& contacts);

/// Decides which vertices, edges and facets may be merged. Two of them may if one is a free border, and one of its
/// surfaces meets a different surface of the other anywhere. Merging thereby removes overshoots, and extends borders
/// that stop short. Where surfaces cross without ending, nothing is merged, since remeshing removes fine triangles
/// beside their curve. Surfaces from index `first_fixed` on are sides of a model volume and never merged, because they
/// would leave their planes. Not thread-safe.
class JoinRule {
 public:
  using Set = Index;  ///< index of a set of surfaces
  struct Thing {
    Set surfaces = none;
    bool is_border = false;
  };
  /// Everything may join.
  JoinRule() = default;
  explicit JoinRule(std::set<SurfacePair> meeting, Index first_fixed = no_index)
      : meeting_(std::move(meeting)), first_fixed_(first_fixed), restricts_(true) {}
  /// Returns a rule that allows all parts of these pairs of surfaces to be merged, whether they end there or not. A
  /// pair that names one surface twice allows parts of that surface to be merged with each other.
  static JoinRule all_of(std::set<SurfacePair> pairs, Index first_fixed) {
    JoinRule rule(std::move(pairs), first_fixed);
    rule.needs_border_ = false;
    return rule;
  }
  /// Returns a rule that allows everything to be merged except surfaces from index `first_fixed` on.
  static JoinRule all_but(Index first_fixed) {
    JoinRule rule({}, first_fixed);
    rule.joins_all_ = true;
    return rule;
  }

  /// Allows both surfaces of each pair to be merged wherever they are near each other, even where neither of them ends.
  void join_all_of(const std::set<SurfacePair>& pairs) {
    following_.insert(pairs.begin(), pairs.end());
    known_.clear();
  }

  /// Allows both surfaces of each pair to be merged where one of them ends, although they meet nowhere.
  void join_ends_of(const std::set<SurfacePair>& pairs) {
    meeting_.insert(pairs.begin(), pairs.end());
    known_.clear();
  }

  bool restricts() const { return restricts_; }
  /// Determines the surfaces at each vertex and edge of the complex, and whether one ends there: at edges with one
  /// facet, except those for which `lies_on_box` returns true. If `asked` is not empty, only the vertices that it marks
  /// may be queried.
  void index(const Complex& complex, const std::function<bool(VertexIndex, VertexIndex)>& lies_on_box,
             std::vector<std::uint8_t> asked = {});
  /// Determines the surfaces and borders at edges again after facets changed; the vertices must be the same.
  void index_edges(const Complex& complex, const std::function<bool(VertexIndex, VertexIndex)>& lies_on_box);

  Thing of_vertex(VertexIndex v) const { return v < of_vertex_.size() ? of_vertex_[v] : Thing{}; }
  Thing of_edge(VertexIndex a, VertexIndex b) const;
  Thing of_facet(const Complex& complex, Index facet);
  Thing united(const Thing& a, const Thing& b);
  void set_vertex(VertexIndex v, const Thing& thing);
  bool allows(const Thing& a, const Thing& b) const;

 private:
  static constexpr Set none = 0;
  Set number(std::vector<Index> surfaces);
  bool find_whether_allowed(const Thing& a, const Thing& b) const;

  std::set<SurfacePair> meeting_, following_;
  Index first_fixed_ = no_index;
  bool restricts_ = false, joins_all_ = false, needs_border_ = true;
  std::vector<std::uint8_t> asked_;  ///< for each vertex: whether its surfaces are determined; empty if all are
  std::vector<std::vector<Index>> sets_{{}};
  std::map<std::vector<Index>, Set> numbers_{{{}, none}};
  std::vector<Thing> of_vertex_;
  std::vector<std::pair<EdgeKey, Thing>> of_edge_;  // ascending by edge
  /// For each pair of surface sets, each without or with a border: whether they may be merged (1), may not (2), or it
  /// was not determined yet (0). Used only while there are few sets.
  mutable std::vector<std::uint8_t> known_;
};

}  // namespace geomesh::geomodel::arrangement

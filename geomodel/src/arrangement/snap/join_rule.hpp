// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Rules for which surfaces may be merged: all, or only those that meet somewhere.
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

using SurfacePair = std::pair<Index, Index>;  ///< rows of two surfaces, the smaller first
inline SurfacePair surface_pair(Index a, Index b) { return a < b ? SurfacePair{a, b} : SurfacePair{b, a}; }

/// Returns pairs of surfaces whose facets touch, cross or overlap.
std::set<SurfacePair> surfaces_in_contact(const Complex& complex, const Contacts& contacts);
/// Returns those pairs, and pairs of surfaces that share a vertex.
std::set<SurfacePair> surfaces_that_meet(const Complex& complex, const Contacts& contacts);

/// Two items may be merged if one of them is a free border, and a surface of the one meets another surface of the other
/// somewhere. Overshoots are thereby removed, and borders that stop short are extended. Where surfaces cross and
/// nothing ends, remeshing removes fine triangles beside their curve. Surfaces from the row `first_fixed` on are never
/// merged: they are sides of a model volume, which would leave their planes. Not thread-safe.
class JoinRule {
 public:
  using Set = Index;  ///< number of a set of surfaces
  struct Thing {
    Set surfaces = none;
    bool is_border = false;
  };
  /// Everything may join.
  JoinRule() = default;
  explicit JoinRule(std::set<SurfacePair> meeting, Index first_fixed = no_index)
      : meeting_(std::move(meeting)), first_fixed_(first_fixed), restricts_(true) {}
  /// Returns a rule by which all parts of these surfaces may be merged, whether they end there or not. A pair that
  /// names one surface twice merges its parts.
  static JoinRule all_of(std::set<SurfacePair> pairs, Index first_fixed) {
    JoinRule rule(std::move(pairs), first_fixed);
    rule.needs_border_ = false;
    return rule;
  }
  /// A rule that allows everything else to be merged.
  static JoinRule all_but(Index first_fixed) {
    JoinRule rule({}, first_fixed);
    rule.joins_all_ = true;
    return rule;
  }

  /// Surfaces of these pairs are merged wherever they are near, whether they end there or not.
  void join_all_of(const std::set<SurfacePair>& pairs) {
    following_.insert(pairs.begin(), pairs.end());
    known_.clear();
  }

  /// Surfaces of these pairs are merged where one of them ends, although they meet nowhere.
  void join_ends_of(const std::set<SurfacePair>& pairs) {
    meeting_.insert(pairs.begin(), pairs.end());
    known_.clear();
  }

  bool restricts() const { return restricts_; }
  /// Indexes the complex in its current state. Edges with one facet are borders, except those that `lies_on_box` places
  /// on a side of the box. `asked`, if not empty, marks the vertices that will be needed; others are left out.
  void index(const Complex& complex, const std::function<bool(VertexIndex, VertexIndex)>& lies_on_box,
             std::vector<std::uint8_t> asked = {});
  /// Indexes only the edges again; vertices are unchanged.
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
  std::vector<std::uint8_t> asked_;  ///< for each vertex, whether it may be needed; empty: all may be
  std::vector<std::vector<Index>> sets_{{}};
  std::map<std::vector<Index>, Set> numbers_{{{}, none}};
  std::vector<Thing> of_vertex_;
  std::vector<std::pair<EdgeKey, Thing>> of_edge_;  // ascending by edge
  /// For pairs of sets, without and with a border: 1 allowed, 2 not allowed, 0 not known yet. Used only while there are
  /// few sets.
  mutable std::vector<std::uint8_t> known_;
};

}  // namespace geomesh::geomodel::arrangement

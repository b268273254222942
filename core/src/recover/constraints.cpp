// SPDX-License-Identifier: MIT
#include "recover/constraints.hpp"

#include <algorithm>

namespace geomesh::recover {

void Constraints::reserve(std::size_t n_subsegments, std::size_t n_subfacets) {
  subsegments.reserve(n_subsegments);
  subfacets.reserve(n_subfacets);
  subsegment_map_.reserve(n_subsegments);
  subfacet_map_.reserve(n_subfacets);
}

Index Constraints::add_subsegment(VertexIndex a, VertexIndex b, Index segment, Index facet) {
  const Index s = static_cast<Index>(subsegments.size());
  subsegments.push_back({a, b, segment, facet, true, {}});
  subsegment_map_.insert({a, b}, s);
  return s;
}

Index Constraints::add_subfacet(const Triangle& t, Index facet) {
  const Index f = static_cast<Index>(subfacets.size());
  subfacets.push_back({t, facet, true});
  subfacet_map_.insert({t[0], t[1], t[2]}, f);
  for (unsigned i = 0; i < 3; ++i) {
    Index s = subsegment_of(t[i], t[(i + 1) % 3]);
    if (s == no_index) s = add_subsegment(t[i], t[(i + 1) % 3], no_index, facet);
    subsegments[s].subfacets.push_back(f);
  }
  return f;
}

void Constraints::remove_subfacet(Index f) {
  const Triangle t = subfacets[f].vertices;
  subfacets[f].live = false;
  subfacet_map_.erase({t[0], t[1], t[2]});
  for (unsigned i = 0; i < 3; ++i) {
    const Index s = subsegment_of(t[i], t[(i + 1) % 3]);
    if (s == no_index) continue;
    std::erase(subsegments[s].subfacets, f);
    if (subsegments[s].segment == no_index && subsegments[s].subfacets.empty()) remove_subsegment(s);
  }
}

void Constraints::remove_subsegment(Index s) {
  subsegments[s].live = false;
  subsegment_map_.erase({subsegments[s].a, subsegments[s].b});
}

Constraints::SegmentSplit Constraints::split_subsegment(Index s, VertexIndex x) {
  const Subsegment old = subsegments[s];
  SegmentSplit out;
  out.first = add_subsegment(old.a, x, old.segment, old.facet);
  out.second = add_subsegment(x, old.b, old.segment, old.facet);
  for (Index f : old.subfacets) {
    const Triangle t = subfacets[f].vertices;
    const Index facet = subfacets[f].facet;
    unsigned i = 0;
    while (t[i] == old.a || t[i] == old.b) ++i;
    const VertexIndex apex = t[i], p = t[(i + 1) % 3], q = t[(i + 2) % 3];
    // The new halves come before the old triangle goes, so that edges inside the facet that they share stay.
    out.subfacets.push_back(add_subfacet({p, x, apex}, facet));
    out.subfacets.push_back(add_subfacet({x, q, apex}, facet));
    out.inner.push_back(subsegment_of(x, apex));
    remove_subfacet(f);
  }
  if (subsegments[s].live) remove_subsegment(s);
  return out;
}

}  // namespace geomesh::recover

// SPDX-License-Identifier: MIT
#include "recover/model/constraints.hpp"

#include <algorithm>

#include "geomesh/core/error.hpp"

namespace geomesh::recover {

void Constraints::reserve(std::size_t n_subsegments, std::size_t n_subfacets) {
  subsegments.reserve(n_subsegments);
  subfacets.reserve(n_subfacets);
  subsegment_map_.reserve(n_subsegments);
  subfacet_map_.reserve(n_subfacets);
}

Index Constraints::add_subsegment(VertexIndex a, VertexIndex b, Index segment, Index facet) {
  const Index s = static_cast<Index>(subsegments.size());
  subsegments.push_back(
      {.a = a, .b = b, .segment = segment, .facet = facet, .live = true, .subfacets = {}, .seen_in = no_cell});
  subsegment_map_.insert({a, b}, s);
  split_map_.erase({a, b});
  return s;
}

Index Constraints::add_subfacet(const Triangle& t, Index facet) {
  GEOMESH_CHECK(subfacet_of(t[0], t[1], t[2]) == no_index);
  const Index f = static_cast<Index>(subfacets.size());
  subfacets.push_back({.vertices = t, .facet = facet, .live = true, .piece = no_index, .seen_in = no_cell});
  subfacet_map_.insert({t[0], t[1], t[2]}, f);
  for (unsigned i = 0; i < 3; ++i) {
    Index s = subsegment_of(t[i], t[(i + 1) % 3]);
    if (s == no_index) s = add_subsegment(t[i], t[(i + 1) % 3], no_index, facet);
    subsegments[s].subfacets.push_back(f);
  }
  return f;
}

Index Constraints::add_piece(const Triangle& plane, FacetPiece piece, Index facet) {
  const Index f = static_cast<Index>(subfacets.size());
  subfacets.push_back({.vertices = plane,
                       .facet = facet,
                       .live = true,
                       .piece = static_cast<Index>(pieces_.size()),
                       .seen_in = no_cell});
  for (const DirectedEdge& e : piece.border) subsegments[subsegment_of(e[0], e[1])].subfacets.push_back(f);
  pieces_.push_back(std::move(piece));
  return f;
}

void Constraints::remove_subfacet(Index f) {
  const Triangle t = subfacets[f].vertices;
  std::vector<DirectedEdge> border{{t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}};
  if (is_piece(f)) {
    border = piece_of(f).border;
  } else {
    subfacet_map_.erase({t[0], t[1], t[2]});
  }
  subfacets[f].live = false;
  for (const DirectedEdge& e : border) {
    const Index s = subsegment_of(e[0], e[1]);
    if (s == no_index) continue;
    std::erase(subsegments[s].subfacets, f);
    if (subsegments[s].segment == no_index && subsegments[s].subfacets.empty()) remove_subsegment(s);
  }
}

void Constraints::remove_subsegment(Index s) {
  subsegments[s].live = false;
  subsegment_map_.erase({subsegments[s].a, subsegments[s].b});
}

void Constraints::make_piece(Index f) {
  if (is_piece(f)) return;
  const Triangle t = subfacets[f].vertices;
  subfacet_map_.erase({t[0], t[1], t[2]});
  subfacets[f].piece = static_cast<Index>(pieces_.size());
  pieces_.push_back({.border = {{t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}}, .members = {t[0], t[1], t[2]}});
}

std::array<Index, 2> Constraints::split_subsegment(Index s, VertexIndex x) {
  const Subsegment old = subsegments[s];
  if (old.segment != no_index) split_map_.insert({segments[old.segment].a, segments[old.segment].b}, old.segment);
  const std::array<Index, 2> halves{add_subsegment(old.a, x, old.segment, old.facet),
                                    add_subsegment(x, old.b, old.segment, old.facet)};
  for (Index h : halves) subsegments[h].subfacets = old.subfacets;
  for (Index f : old.subfacets) {
    make_piece(f);
    FacetPiece& piece = pieces_[subfacets[f].piece];
    piece.members.push_back(x);
    piece.seen.clear();
    for (std::size_t i = 0; i < piece.border.size(); ++i) {
      const DirectedEdge e = piece.border[i];
      if (!(e == DirectedEdge{old.a, old.b} || e == DirectedEdge{old.b, old.a})) continue;
      piece.border[i] = {e[0], x};
      piece.border.insert(piece.border.begin() + static_cast<std::ptrdiff_t>(++i), {x, e[1]});
    }
  }
  remove_subsegment(s);
  return halves;
}

}  // namespace geomesh::recover

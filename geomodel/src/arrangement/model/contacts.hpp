// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Narrow phase: computes the intersections of closed triangles, wells' segments and points, pair by pair, as symbols.
/// The signs of exact predicates on doubles decide everything; no intersection point is constructed.
#pragma once

#include <compare>
#include <vector>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// A point given by its definition: a point of the complex, the intersection of the line through two of its points with
/// a facet's plane, or that of two coplanar lines. The same place may have several symbols; equal places are identified
/// exactly later.
struct Symbol {
  Index a = no_index, b = no_index, c = no_index, d = no_index;
  static Symbol point(VertexIndex v) { return {v, no_index, no_index, no_index}; }
  static Symbol line_plane(VertexIndex p, VertexIndex q, Index facet) {
    return p < q ? Symbol{p, q, facet, no_index} : Symbol{q, p, facet, no_index};
  }
  static Symbol line_line(VertexIndex p, VertexIndex q, VertexIndex r, VertexIndex s);
  bool is_point() const { return b == no_index; }
  bool is_line_plane() const { return b != no_index && d == no_index; }
  friend auto operator<=>(const Symbol&, const Symbol&) = default;
};

/// The line of a constraint inside a facet: that of an edge, or the intersection with another facet's plane (b ==
/// no_index).
struct Line {
  Index a = no_index, b = no_index;
  static Line edge(VertexIndex p, VertexIndex q) { return p < q ? Line{p, q} : Line{q, p}; }
  static Line plane(Index facet) { return {facet, no_index}; }
  bool is_edge() const { return b != no_index; }
  friend auto operator<=>(const Line&, const Line&) = default;
};

/// A point or a segment in which a facet and another item meet; `ends` defines the point or the ends symbolically.
struct FacetContact {
  Index facet = no_index;
  Index other = no_index;  ///< the facet that meets `facet`, or no_index if a well or point touches it
  Line line;
  std::array<Symbol, 4> ends;
  std::uint8_t n_ends = 0;
  friend auto operator<=>(const FacetContact&, const FacetContact&) = default;
};
struct SegmentContact {
  Index segment;
  Symbol point;
  friend auto operator<=>(const SegmentContact&, const SegmentContact&) = default;
};
/// Two coplanar facets whose interiors overlap.
struct Overlap {
  Index a, b;
  friend auto operator<=>(const Overlap&, const Overlap&) = default;
};

struct Contacts {
  std::vector<FacetContact> facets;
  std::vector<SegmentContact> segments;
  std::vector<Overlap> overlaps;
  std::size_t n_pairs = 0;
  bool empty() const { return facets.empty() && segments.empty() && overlaps.empty(); }
  std::size_t size() const { return facets.size() + segments.size() + overlaps.size(); }
  void append(const Contacts& more);
};

void facet_facet_contact(const Complex& complex, Index a, Index b, Contacts& out);
void segment_facet_contact(const Complex& complex, Index segment, Index facet, Contacts& out);
void segment_segment_contact(const Complex& complex, Index a, Index b, Contacts& out);
void point_facet_contact(const Complex& complex, VertexIndex point, Index facet, Contacts& out);
void point_segment_contact(const Complex& complex, VertexIndex point, Index segment, Contacts& out);

/// Returns all places where facets, wells' segments or points meet, sorted, except in shared vertices and edges. Pairs
/// of which neither item is marked dirty (changed since they were last compared) are left out. Nearly linear, parallel.
/// Throws Error{cannot_mesh} if the result would take more than `max_bytes`.
Contacts find_contacts(const Complex& complex, const RunContext& context, std::size_t max_bytes = no_memory_bound);

}  // namespace geomesh::geomodel::arrangement

// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/snap/rebuilding.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace geomesh::geomodel::arrangement {
namespace {

/// Returns the pieces of edges with both ends among the given vertices of a facet, to become edges of the facet.
std::vector<EdgeKey> pieces_among(std::vector<VertexIndex> vertices, const std::vector<EdgeKey>& pieces) {
  std::sort(vertices.begin(), vertices.end());
  std::vector<EdgeKey> found;
  for (const VertexIndex v : vertices)
    for (auto at = std::lower_bound(pieces.begin(), pieces.end(), EdgeKey{v, 0}); at != pieces.end() && at->first == v;
         ++at)
      if (v < at->second && std::binary_search(vertices.begin(), vertices.end(), at->second)) found.push_back(*at);
  return found;
}

/// The facets and segments of a complex with the vertices inserted in them.
class Rebuilding {
 public:
  /// `edges` are all edges of the facets to be snapped; `touched` are facets with a corner that was merged.
  Rebuilding(Complex& complex, Insertions& insertions, const std::vector<EdgeKey>& edges,
             const std::set<Index>& touched, SnapOutcome& outcome)
      : complex_(complex), insertions_(insertions), edges_(edges), touched_(touched), outcome_(outcome) {}

  /// Splits the facets. If one cannot be split, the insertions in it and on its edges are dropped, so that surfaces
  /// remain connected, and its neighbours are split again. Each round drops insertions, so there are no more rounds
  /// than insertions.
  void leave_out_what_splits_nothing() {
    for (std::vector<Index> open = split_all(); !open.empty();) {
      std::set<EdgeKey> whole;
      for (const Index f : open) {
        insertions_.in_facet.erase(f);
        for (const EdgeKey& e : edges_of(complex_.facets[f]))
          if (insertions_.on_edge.erase(e) > 0) whole.insert(e);
      }
      if (whole.empty()) break;
      open = split_again(whole);
    }
  }

  void rebuild_facets() {
    Complex out;
    for (Index f = 0; f < complex_.facets.size(); ++f) {
      const Triangle& t = complex_.facets[f];
      const auto at = splits_.find(f);
      if (at == splits_.end())
        push(out, t, f, complex_.dirty_facet[f]);
      else if (!at->second)
        push(out, t, f, 1);
      else if (at->second->empty())
        note_vanished(t, f);
      else
        for (const Triangle& piece : *at->second) push(out, piece, f, 1);
    }
    complex_.facets = std::move(out.facets);
    complex_.origins = std::move(out.origins);
    complex_.dirty_facet = std::move(out.dirty_facet);
    outcome_.n_facets_merged = merge_equal_facets(complex_);
  }

  void rebuild_segments() {
    std::vector<PolygonSoup::Segment> segments;
    std::vector<std::uint8_t> dirty;
    for (std::size_t s = 0; s < complex_.segments.size(); ++s) {
      const PolygonSoup::Segment& segment = complex_.segments[s];
      if (segment.a == segment.b) continue;
      std::vector<VertexIndex> walk;
      walk_edge(segment.a, segment.b, walk);
      walk.push_back(segment.b);
      for (std::size_t k = 0; k + 1 < walk.size(); ++k) {
        segments.push_back({walk[k], walk[k + 1], segment.polyline});
        dirty.push_back(1);
      }
    }
    complex_.segments = std::move(segments);
    complex_.dirty_segment = std::move(dirty);
    remove_repeated_segments(complex_);
  }

 private:
  const Vec3& point(VertexIndex v) const { return complex_.points[v]; }

  bool is_to_be_split(Index f) const {
    if (insertions_.in_facet.contains(f) || touched_.contains(f)) return true;
    const std::array<EdgeKey, 3> edges = edges_of(complex_.facets[f]);
    return std::any_of(edges.begin(), edges.end(), [&](const EdgeKey& e) { return insertions_.on_edge.contains(e); });
  }

  /// Splits all facets that have inserted vertices. Returns those that cannot be split as required.
  std::vector<Index> split_all() {
    std::vector<Index> facets;
    is_of_split_.assign(complex_.points.size(), 0);
    for (Index f = 0; f < complex_.facets.size(); ++f) {
      if (!is_to_be_split(f)) continue;
      facets.push_back(f);
      for (const VertexIndex v : vertices_of(f)) is_of_split_[v] = 1;
    }
    return split_these(facets);
  }
  /// Splits again the facets with an edge in `whole`, the edges from which all inserted vertices were dropped.
  std::vector<Index> split_again(const std::set<EdgeKey>& whole) {
    std::vector<Index> facets;
    for (const auto& [f, split] : splits_) {
      const std::array<EdgeKey, 3> edges = edges_of(complex_.facets[f]);
      if (std::any_of(edges.begin(), edges.end(), [&](const EdgeKey& e) { return whole.contains(e); }))
        facets.push_back(f);
    }
    std::sort(facets.begin(), facets.end());
    return split_these(facets);
  }
  std::vector<Index> split_these(const std::vector<Index>& facets) {
    const std::vector<EdgeKey> pieces = list_pieces();
    std::vector<Index> open;
    for (const Index f : facets) {
      splits_.erase(f);
      if (!is_to_be_split(f)) continue;
      const auto inside = insertions_.in_facet.find(f);
      const auto [at, is_new] = splits_.emplace(
          f, split_facet(complex_.points, complex_.facets[f], border_of(complex_.facets[f]),
                         inside == insertions_.in_facet.end() ? std::vector<VertexIndex>{} : inside->second,
                         pieces_among(vertices_of(f), pieces)));
      if (!at->second) open.push_back(f);
    }
    return open;
  }
  /// Returns the vertices on the border of facet f and inside it.
  std::vector<VertexIndex> vertices_of(Index f) const {
    std::vector<VertexIndex> all = border_of(complex_.facets[f]);
    if (const auto inside = insertions_.in_facet.find(f); inside != insertions_.in_facet.end())
      all.insert(all.end(), inside->second.begin(), inside->second.end());
    return all;
  }

  /// Appends the vertices from a to b along their edge, including the inserted ones and excluding b.
  void walk_edge(VertexIndex a, VertexIndex b, std::vector<VertexIndex>& walk) const {
    walk.push_back(a);
    const auto on = insertions_.on_edge.find(edge_key(a, b));
    if (on == insertions_.on_edge.end()) return;
    if (a < b)
      walk.insert(walk.end(), on->second.begin(), on->second.end());
    else
      walk.insert(walk.end(), on->second.rbegin(), on->second.rend());
  }
  std::vector<VertexIndex> border_of(const Triangle& t) const {
    std::vector<VertexIndex> walk;
    for (std::size_t k = 0; k < 3; ++k) walk_edge(t[k], t[(k + 1) % 3], walk);
    return walk;
  }

  /// Returns the pieces of divided edges between vertices of facets to be split, sorted, each in both directions.
  std::vector<EdgeKey> list_pieces() const {
    std::vector<EdgeKey> pieces;
    std::vector<VertexIndex> walk;
    for (const EdgeKey& e : edges_) {
      if (!is_of_split_[e.first] && !is_of_split_[e.second]) continue;
      walk.clear();
      walk_edge(e.first, e.second, walk);
      walk.push_back(e.second);
      for (std::size_t k = 0; k + 1 < walk.size(); ++k) {
        if (!is_of_split_[walk[k]] || !is_of_split_[walk[k + 1]]) continue;
        pieces.emplace_back(walk[k], walk[k + 1]);
        pieces.emplace_back(walk[k + 1], walk[k]);
      }
    }
    std::sort(pieces.begin(), pieces.end());
    pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
    return pieces;
  }

  void note_vanished(const Triangle& t, Index from) {
    outcome_.vanished.push_back({surfaces_of(complex_.origins.of(from)), {point(t[0]), point(t[1]), point(t[2])}});
  }

  void push(Complex& out, const Triangle& t, Index from, std::uint8_t dirty) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ||
        projection_of(point(t[0]), point(t[1]), point(t[2])).sign == Sign::zero) {
      note_vanished(t, from);
      return;
    }
    out.facets.push_back(t);
    out.origins.push(complex_.origins.of(from));
    out.dirty_facet.push_back(dirty);
  }

  Complex& complex_;
  Insertions& insertions_;
  const std::vector<EdgeKey>& edges_;
  const std::set<Index>& touched_;
  SnapOutcome& outcome_;
  /// Triangles of each split facet; nothing if the facet is left unchanged.
  std::unordered_map<Index, std::optional<std::vector<Triangle>>> splits_;
  std::vector<std::uint8_t> is_of_split_;  ///< for each vertex: whether it belongs to a facet that is to be split
};

void note_insertions(const Complex& complex, const Insertions& insertions, SnapOutcome& outcome, MovesOfStep& moves) {
  const auto point = [&](VertexIndex v) { return complex.points[v]; };
  for (const auto& [edge, on] : insertions.on_edge) {
    outcome.n_vertices_inserted += on.size();
    const Vec3 d = point(edge.second) - point(edge.first);
    for (const VertexIndex v : on) moves.note(length(cross(point(v) - point(edge.first), d)) / length(d), point(v));
  }
  for (const auto& [facet, in] : insertions.in_facet) outcome.n_vertices_inserted += in.size();
}

}  // namespace

void rebuild_with(Complex& complex, Insertions& insertions, const std::vector<EdgeKey>& edges,
                  const std::set<Index>& touched, SnapOutcome& outcome, MovesOfStep& moves) {
  Rebuilding rebuilding(complex, insertions, edges, touched, outcome);
  rebuilding.leave_out_what_splits_nothing();
  note_insertions(complex, insertions, outcome, moves);
  rebuilding.rebuild_facets();
  rebuilding.rebuild_segments();
}

}  // namespace geomesh::geomodel::arrangement

// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/snap/snap.hpp"

#include <algorithm>
#include <bit>
#include <set>

#include "arrangement/snap/rebuilding.hpp"
#include "arrangement/snap/snap_search.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

/// Performs snapping: merges vertices, then inserts vertices in the edges and facets that are near them.
class Snapper {
 public:
  Snapper(Complex& complex, const std::vector<std::uint8_t>& active, SnapOptions options)
      : complex_(complex),
        options_(std::move(options)),
        planes_(options_.box),
        grid_(complex.points, options_.distance) {
    for (Index f = 0; f < complex.facets.size(); ++f)
      if (active[f]) facets_.push_back(f);
    now_.resize(complex.points.size());
    for (VertexIndex v = 0; v < now_.size(); ++v) now_[v] = v;
  }

  SnapOutcome run() {
    list_vertices();
    if (options_.rule.restricts()) index_rule();
    if (options_.move_to_box != MoveToBox::none) move_to_box();
    merge_vertices();
    list_edges();
    std::vector<VertexIndex> standing;
    for (const VertexIndex v : vertices_)
      if (now_[v] == v) standing.push_back(v);
    Insertions insertions = find_insertions(complex_, active_facets_, edges_, std::move(standing), grid_, options_);
    rebuild_with(complex_, insertions, edges_, touched_, outcome_, moves_);
    for (auto& p : complex_.isolated_points) p.v = now_[p.v];
    outcome_.moved = moves_.displacement();
    return outcome_;
  }

  std::vector<VertexIndex> take_vertices() { return std::move(now_); }

 private:
  const Vec3& point(VertexIndex v) const { return complex_.points[v]; }

  void index_rule() {
    options_.rule.index(
        complex_, [this](VertexIndex a, VertexIndex b) { return (planes_.of(point(a)) & planes_.of(point(b))) != 0; },
        marks_of_vertices());
  }

  /// Marks the vertices of segments, points and facets to be snapped; empty if all facets are to be snapped.
  std::vector<std::uint8_t> marks_of_vertices() const {
    if (facets_.size() == complex_.facets.size()) return {};
    std::vector<std::uint8_t> marks(complex_.points.size(), 0);
    for (const VertexIndex v : vertices_) marks[v] = 1;
    return marks;
  }

  void list_vertices() {
    for (const Index f : facets_)
      vertices_.insert(vertices_.end(), complex_.facets[f].begin(), complex_.facets[f].end());
    for (const auto& s : complex_.segments) vertices_.insert(vertices_.end(), {s.a, s.b});
    for (const auto& p : complex_.isolated_points) vertices_.push_back(p.v);
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  }

  /// Moves vertices to near planes of the box. Places must stay distinct: a vertex that would move to another's place
  /// is not moved but merged with it afterwards, because it is closer than the distance.
  void move_to_box() {
    std::set<std::array<double, 3>> taken;
    for (const Vec3& p : complex_.points) taken.insert({p.x, p.y, p.z});
    for (const VertexIndex v : vertices_) {
      if (options_.move_to_box == MoveToBox::of_free_borders && !options_.rule.of_vertex(v).is_border) continue;
      const Vec3 p = planes_.onto_near(point(v), options_.distance);
      if (p == point(v) || !taken.insert({p.x, p.y, p.z}).second) continue;
      moves_.note(length(p - point(v)), p);
      complex_.points[v] = p;
    }
  }

  void merge_vertices() {
    std::vector<VertexIndex> order = vertices_;
    const auto rank = [this](VertexIndex v) {
      return std::pair{-std::popcount(planes_.of(point(v))), complex_.input_point[v] == no_index};
    };
    std::stable_sort(order.begin(), order.end(), [&](VertexIndex a, VertexIndex b) { return rank(a) < rank(b); });
    for (const VertexIndex v : order) {
      const VertexIndex stands = grid_.nearest(point(v), planes_.of(point(v)), planes_, [&](VertexIndex other) {
        return options_.rule.allows(options_.rule.of_vertex(v), options_.rule.of_vertex(other));
      });
      if (stands == no_vertex) {
        grid_.add(v);
        continue;
      }
      now_[v] = stands;
      options_.rule.set_vertex(stands,
                               options_.rule.united(options_.rule.of_vertex(stands), options_.rule.of_vertex(v)));
      ++outcome_.n_vertices_merged;
      moves_.note(length(point(v) - point(stands)), point(stands));
    }
    for (Index f = 0; f < complex_.facets.size(); ++f)
      for (VertexIndex& v : complex_.facets[f]) {
        if (now_[v] == v) continue;
        v = now_[v];
        touched_.insert(f);
      }
  }

  void list_edges() {
    for (const Index f : facets_) {
      const Triangle& t = complex_.facets[f];
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      active_facets_.push_back(f);
      for (std::size_t k = 0; k < 3; ++k) edges_.push_back(edge_key(t[k], t[(k + 1) % 3]));
    }
    for (auto& s : complex_.segments) {
      s.a = now_[s.a];
      s.b = now_[s.b];
      if (s.a != s.b) edges_.push_back(edge_key(s.a, s.b));
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  Complex& complex_;
  SnapOptions options_;
  BoxPlanes planes_;
  VertexGrid grid_;
  /// Facets to be snapped; and those of them whose three corners are still distinct after vertices were merged.
  std::vector<Index> facets_, active_facets_;
  std::vector<VertexIndex> vertices_, now_;
  std::vector<EdgeKey> edges_;
  std::set<Index> touched_;  ///< facets of which a corner was merged with another vertex
  SnapOutcome outcome_;
  MovesOfStep moves_;
};

}  // namespace

SnapOutcome snap_near(Complex& complex, const std::vector<std::uint8_t>& active, const SnapOptions& options,
                      std::vector<VertexIndex>* vertex_now) {
  Snapper snapper(complex, active, options);
  const SnapOutcome outcome = snapper.run();
  if (vertex_now) *vertex_now = snapper.take_vertices();
  return outcome;
}

}  // namespace geomesh::geomodel::arrangement

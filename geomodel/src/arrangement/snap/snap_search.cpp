// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/snap/snap_search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "arrangement/search/bvh.hpp"
#include "arrangement/snap/nearness.hpp"
#include "arrangement/snap/vertices_on_edges.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

Box3 box_about(const Complex& complex, std::span<const VertexIndex> vertices, double distance) {
  Box3 box;
  for (const VertexIndex v : vertices) box.add(complex.points[v]);
  const Vec3 margin{distance, distance, distance};
  return {box.min - margin, box.max + margin};
}

/// Returns whether the edge lies along a side of the volume. Vertices made during the search have no entry in
/// `sides_of`, but the edges are between older vertices.
bool lies_along_side(const std::vector<std::uint64_t>& sides_of, const EdgeKey& e) {
  return e.second < sides_of.size() && (sides_of[e.first] & sides_of[e.second]) != 0;
}

class Search {
 public:
  Search(Complex& complex, const std::vector<Index>& facets, const std::vector<EdgeKey>& edges,
         std::vector<VertexIndex> vertices, VertexGrid& grid, SnapOptions& options)
      : complex_(complex),
        facets_(facets),
        edges_(edges),
        vertices_(std::move(vertices)),
        grid_(grid),
        distance_(options.distance),
        planes_(options.box),
        rule_(options.rule),
        sides_of_(options.sides_of),
        on_edges_(complex, options.distance),
        places_(complex) {}

  Insertions run() {
    rule_.index_edges(complex_, [this](VertexIndex a, VertexIndex b) { return planes_of({a, b}) != 0; });
    std::vector<Box3> boxes;
    for (const EdgeKey& e : edges_) {
      boxes.push_back(box_about(complex_, std::array{e.first, e.second}, distance_));
      things_.push_back(rule_.of_edge(e.first, e.second));
    }
    const BoxTree tree(boxes);
    for (const VertexIndex v : vertices_) insert_in_edges(v, tree);
    const std::size_t n_before = vertices_.size();
    for (std::size_t leaf = 0; leaf < tree.n_leaves(); ++leaf)
      tree.pairs_of_leaf(leaf, [&](Index a, Index b) {
        const auto [e, f] = std::minmax(a, b);
        if (rule_.allows(things_[e], things_[f])) join_edges(e, f);
      });
    for (std::size_t k = n_before; k < vertices_.size(); ++k) insert_in_edges(vertices_[k], tree);
    insert_in_facets();
    result_.on_edge = on_edges_.take_sorted();
    return std::move(result_);
  }

 private:
  const Vec3& point(VertexIndex v) const { return complex_.points[v]; }
  unsigned planes_of(const EdgeKey& e) const { return planes_.of(point(e.first)) & planes_.of(point(e.second)); }
  bool lies_on(VertexIndex v, unsigned planes) const { return (planes_.of(point(v)) & planes) == planes; }

  void insert(const EdgeKey& e, VertexIndex v) {
    if (!on_edges_.is_on(e, v) && lies_on(v, planes_of(e))) on_edges_.insert(e, v);
  }

  void insert_in_edges(VertexIndex v, const BoxTree& tree) {
    Box3 place;
    place.add(point(v));
    std::vector<Index> near;
    tree.boxes_meeting(place, [&](Index e) { near.push_back(e); });
    for (const Index e : near) {
      const double t = on_edges_.parameter(edges_[e], point(v));
      if (t > 0 && t < 1 && length(point(v) - on_edges_.at(edges_[e], t)) < distance_ &&
          rule_.allows(rule_.of_vertex(v), things_[e]))
        insert(edges_[e], v);
    }
  }

  void join_edges(Index row_e, Index row_f) {
    const EdgeKey &e = edges_[row_e], &f = edges_[row_f];
    if (e.first == f.first || e.first == f.second || e.second == f.first || e.second == f.second) return;
    const auto nearest = nearest_of_edges(point(e.first), point(e.second), point(f.first), point(f.second));
    if (!nearest) return;  // parallel edges, or nearest at an end, which was tested against the other edge before
    const auto& [p, q] = *nearest;
    if (length(p - q) >= distance_) return;
    const VertexIndex on_e = on_edges_.nearer(e, p), on_f = on_edges_.nearer(f, q);
    if (on_e != no_vertex && on_f != no_vertex) return;
    if (on_e != no_vertex) return insert(f, on_e);
    if (on_f != no_vertex) return insert(e, on_f);
    const Vec3 between = lies_along_side(sides_of_, e) ? p : lies_along_side(sides_of_, f) ? q : 0.5 * (p + q);
    const VertexIndex x = vertex_at(between, planes_of(e) | planes_of(f), rule_.united(things_[row_e], things_[row_f]));
    if (x == no_vertex) return;
    insert(e, x);
    insert(f, x);
  }

  /// Returns the vertex to insert at a place: one of the grid within the snapping distance, else the complex' vertex at
  /// exactly this place, which is made if there is none, so that no two vertices share a place. Returns no_vertex if
  /// the join rule does not allow the vertex found there.
  VertexIndex vertex_at(const Vec3& place, unsigned planes, const JoinRule::Thing& thing) {
    const Vec3 p = planes_.onto(place, planes);
    const auto may_take = [&](VertexIndex v) { return rule_.allows(rule_.of_vertex(v), thing); };
    const VertexIndex there = grid_.nearest(p, planes, planes_, may_take);
    if (there != no_vertex) return there;
    const auto [v, is_new] = places_.at(p);
    if (!is_new && !may_take(v)) return no_vertex;
    rule_.set_vertex(v, is_new ? thing : rule_.united(rule_.of_vertex(v), thing));
    grid_.add(v);
    vertices_.push_back(v);
    return v;
  }

  void insert_in_facets() {
    std::vector<Box3> boxes;
    std::vector<PlaneWithin> near_plane;
    std::vector<JoinRule::Thing> things;
    for (const Index f : facets_) {
      boxes.push_back(box_about(complex_, complex_.facets[f], distance_));
      near_plane.push_back({{point(corner(f, 0)), point(corner(f, 1)), point(corner(f, 2))}, distance_});
      things.push_back(rule_.of_facet(complex_, f));
    }
    const BoxTree tree(boxes);
    for (const VertexIndex v : vertices_) {
      Box3 place;
      place.add(point(v));
      tree.boxes_meeting(place, [&](Index k) {
        if (near_plane[k].side(point(v)) == 0 && rule_.allows(rule_.of_vertex(v), things[k]) && is_in(v, facets_[k]))
          result_.in_facet[facets_[k]].push_back(v);
      });
    }
  }
  VertexIndex corner(Index f, std::size_t k) const { return complex_.facets[f][k]; }

  /// Returns whether vertex v is closer to the facet's interior than the distance, and not on the facet's border.
  bool is_in(VertexIndex v, Index f) const {
    unsigned planes = ~0u;
    for (std::size_t k = 0; k < 3; ++k) {
      if (on_edges_.is_on(edge_key(corner(f, k), corner(f, (k + 1) % 3)), v)) return false;
      planes &= planes_.of(point(corner(f, k)));
    }
    if (!lies_on(v, planes)) return false;
    return is_near_inside(point(v), {point(corner(f, 0)), point(corner(f, 1)), point(corner(f, 2))}, distance_) &&
           !is_by_edge_that_stays(v, f);
  }
  /// Returns whether v is near an edge of the facet that must not be split, so that inserting v would leave a needle.
  bool is_by_edge_that_stays(VertexIndex v, Index f) const {
    constexpr double needle = 0.05;  // of the distance
    for (const EdgeKey& e : edges_of(complex_.facets[f]))
      if (length(point(v) - on_edges_.at(e, on_edges_.parameter(e, point(v)))) < needle * distance_ &&
          !rule_.allows(rule_.of_vertex(v), rule_.of_edge(e.first, e.second)))
        return true;
    return false;
  }

  Complex& complex_;
  const std::vector<Index>& facets_;
  const std::vector<EdgeKey>& edges_;
  std::vector<VertexIndex> vertices_;
  VertexGrid& grid_;
  double distance_;
  BoxPlanes planes_;
  JoinRule& rule_;
  const std::vector<std::uint64_t>& sides_of_;
  VerticesOnEdges on_edges_;
  VerticesByPlace places_;
  std::vector<JoinRule::Thing> things_;  ///< of edges
  Insertions result_;
};

}  // namespace

unsigned BoxPlanes::of(const Vec3& p) const {
  unsigned planes = 0;
  for (std::size_t i = 0; box_ && i < 3; ++i)
    planes |= (p[i] == box_->min[i] ? 1u : 0u) << (2 * i) | (p[i] == box_->max[i] ? 2u : 0u) << (2 * i);
  return planes;
}

Vec3 BoxPlanes::onto(Vec3 p, unsigned planes) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (planes >> (2 * i) & 1) p[i] = box_->min[i];
    if (planes >> (2 * i) & 2) p[i] = box_->max[i];
  }
  return p;
}

Vec3 BoxPlanes::onto_near(const Vec3& p, double distance) const {
  if (!box_) return p;
  unsigned planes = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (p[i] < box_->min[i] - distance || p[i] > box_->max[i] + distance) return p;
    planes |= (std::fabs(p[i] - box_->min[i]) < distance ? 1u : 0u) << (2 * i) |
              (std::fabs(p[i] - box_->max[i]) < distance ? 2u : 0u) << (2 * i);
  }
  return onto(p, planes);
}

VertexGrid::Cell VertexGrid::cell_of(const Vec3& p) const {
  constexpr double distances_a_cell = 4;
  const double size = distances_a_cell * distance_;
  return {std::floor(p.x / size) + 0.0, std::floor(p.y / size) + 0.0, std::floor(p.z / size) + 0.0};
}

std::size_t VertexGrid::place_of(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const double c : cell) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15ull;
    hash ^= hash >> 32;
  }
  std::size_t i = hash & (slots_.size() - 1);
  while (slots_[i].first != no_vertex && slots_[i].cell != cell) i = (i + 1) & (slots_.size() - 1);
  return i;
}

void VertexGrid::grow() {
  std::vector<Slot> old(std::max<std::size_t>(64, 2 * slots_.size()));
  old.swap(slots_);
  for (const Slot& s : old)
    if (s.first != no_vertex) slots_[place_of(s.cell)] = s;
}

void VertexGrid::add(VertexIndex v) {
  if (2 * (n_cells_ + 1) > slots_.size()) grow();
  if (next_.size() <= v) next_.resize(std::max<std::size_t>(v + std::size_t{1}, points_.size()), no_vertex);
  const Cell cell = cell_of(points_[v]);
  Slot& slot = slots_[place_of(cell)];
  n_cells_ += slot.first == no_vertex;
  next_[v] = slot.first;
  slot = {cell, v};
}

VertexIndex VertexGrid::nearest(const Vec3& p, unsigned planes, const BoxPlanes& box,
                                const std::function<bool(VertexIndex)>& may_take) const {
  VertexIndex best = no_vertex;
  if (slots_.empty()) return best;
  const Vec3 margin{distance_, distance_, distance_};
  const Cell low = cell_of(p - margin), high = cell_of(p + margin);
  double best_distance = distance_;
  // The ball in which vertices are sought has half a cell as diameter, so it meets at most two cells along an axis.
  for (unsigned k = 0; k < 8; ++k) {
    Cell cell = low;
    bool is_same = false;  // as one before
    for (std::size_t i = 0; i < 3; ++i)
      if ((k >> i & 1u) != 0) is_same |= low[i] == high[i], cell[i] = high[i];
    if (is_same) continue;
    for (VertexIndex v = slots_[place_of(cell)].first; v != no_vertex; v = next_[v]) {
      const double d = length(p - points_[v]);
      const bool is_nearer = d < best_distance || (d == best_distance && best != no_vertex && v < best);
      if (!is_nearer || (box.of(points_[v]) & planes) != planes || !may_take(v)) continue;
      best = v;
      best_distance = d;
    }
  }
  return best;
}

Insertions find_insertions(Complex& complex, const std::vector<Index>& facets, const std::vector<EdgeKey>& edges,
                           std::vector<VertexIndex> vertices, VertexGrid& grid, SnapOptions& options) {
  return Search(complex, facets, edges, std::move(vertices), grid, options).run();
}

}  // namespace geomesh::geomodel::arrangement

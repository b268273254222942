// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/apron.hpp"

#include <algorithm>
#include <map>

#include "common/union_find.hpp"
#include "rules/continuation/apron_grid.hpp"

namespace geomesh::geomodel {
namespace {

using Corners = ApronGrid::Corners;

/// Finds paths along the edges of a surface that cross no wall (a surface that bounds it).
class UnpartedEdges {
 public:
  UnpartedEdges(const TriangulatedSurface& surface, Index row, const Walls& walls)
      : surface_(surface), row_(row), walls_(walls) {}

  /// Returns whether two vertices are connected by edges near them, around the bounding surface between them: a
  /// bounding surface that reaches into the surface and ends there does not separate them.
  bool join(VertexIndex a, VertexIndex b) {
    if (ring_.empty())
      for (const Triangle& t : surface_.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
          ring_[t[i]].insert(t[(i + 1) % 3]);
          ring_[t[i]].insert(t[(i + 2) % 3]);
        }
    std::set<VertexIndex> near = ring_[a];
    near.insert(ring_[b].begin(), ring_[b].end());
    std::set<VertexIndex> reached{a};
    std::vector<VertexIndex> next{a};
    while (!next.empty()) {
      const VertexIndex v = next.back();
      next.pop_back();
      for (const VertexIndex w : ring_[v]) {
        if (!near.contains(w) || reached.contains(w)) continue;
        const Vec3 &p = surface_.points[v], &q = surface_.points[w];
        if (walls_.first_surface(p, q, row_) || walls_.first_surface(q, p, row_)) continue;
        reached.insert(w);
        next.push_back(w);
      }
    }
    return reached.contains(b);
  }

 private:
  const TriangulatedSurface& surface_;
  Index row_;
  const Walls& walls_;
  std::map<VertexIndex, std::set<VertexIndex>> ring_;  ///< neighbours of surface vertices, computed when needed
};

/// Returns whether the surface's triangles along the border are mostly counter-clockwise in the frame.
bool faces_up(const TriangulatedSurface& surface, const BorderChain& chain, const Frame& frame) {
  double up = 0;
  for (const Index t : chain.triangles) {
    const Triangle& v = surface.triangles[t];
    const Vec3 a = frame.to_frame(surface.points[v[0]]), b = frame.to_frame(surface.points[v[1]]),
               c = frame.to_frame(surface.points[v[2]]);
    up += cross(b - a, c - a).z;
  }
  return up >= 0;
}

/// Groups the visible nodes of a grid into sides: sets connected without crossing a bounding surface.
class ApronSides {
 public:
  ApronSides(const TriangulatedSurface& surface, Index row, const BorderChain& chain, const Walls& walls,
             const ApronGrid& grid)
      : row_(row), border_(chain), walls_(walls), grid_(grid) {
    UnpartedEdges edges(surface, row, walls);
    UnionFind joined(grid.nodes().size());
    for (std::size_t e = 0; e < grid.chain().n_edges(); ++e) {
      const auto a = static_cast<Index>(e), b = static_cast<Index>(grid.chain().end_of(e));
      if (!is_parted(a, b) || edges.join(chain.vertices[a], chain.vertices[b]))
        joined.unite(a, b);
      else
        parted_border_.insert(std::minmax(a, b));
    }
    for (const Corners& t : grid.triangles())
      for (std::size_t i = 0; i < 3; ++i) join(t[i], t[(i + 1) % 3], joined);
    side_.assign(grid.nodes().size(), no_index);
    for (Index v = 0; v < grid.nodes().size(); ++v)
      if (grid.nodes()[v].is_seen) side_[v] = joined.find(v);
  }

  /// Returns the set of connected visible nodes to which a node belongs; no_index if the border does not see the node.
  Index operator[](Index v) const { return side_[v]; }
  std::set<Index> of(const Corners& t) const {
    std::set<Index> sides;
    for (const Index v : t)
      if (side_[v] != no_index) sides.insert(side_[v]);
    return sides;
  }
  /// Returns whether an edge of the triangle is part of the border and crosses a bounding surface. The original surface
  /// continues across it there, and so does its continuation.
  bool runs_on(const Corners& t) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (parted_border_.contains(std::minmax(t[i], t[(i + 1) % 3]))) return true;
    return false;
  }
  /// Returns the side (node set) of the border edge leading to v, if a bounding surface is between them; else no_index.
  Index before(Index v) const {
    if (v >= grid_.n_border()) return no_index;
    const std::size_t n = grid_.chain().n_edges();
    if (v < n && border_.cut_off[v] == 1) return side_[grid_.chain().end_of(v)];
    const std::size_t edge = v > 0 ? v - 1 : n - 1;
    return grid_.chain().end_of(edge) == v && border_.cut_off[edge] == 2 ? side_[edge] : no_index;
  }

 private:
  bool is_parted(Index a, Index b) const {
    return walls_.first_surface(grid_.nodes()[a].point, grid_.nodes()[b].point, row_) ||
           walls_.first_surface(grid_.nodes()[b].point, grid_.nodes()[a].point, row_);
  }
  void join(Index a, Index b, UnionFind& joined) const {
    if (grid_.nodes()[a].is_seen && grid_.nodes()[b].is_seen && joined.find(a) != joined.find(b) && !is_parted(a, b))
      joined.unite(a, b);
  }

  Index row_;
  const BorderChain& border_;
  const Walls& walls_;
  const ApronGrid& grid_;
  std::vector<Index> side_;  ///< per node
  std::set<std::pair<Index, Index>> parted_border_;
};

/// Makes the triangles of a continuation from a grid; those that bounding surfaces divide get a copy for each side.
class SidedApron {
 public:
  SidedApron(const TriangulatedSurface& surface, Index row, const BorderChain& chain, const Walls& walls,
             const ApronSetting& setting)
      : surface_(surface),
        border_(chain),
        within_(setting.within),
        grid_(surface, row, chain, walls, setting),
        sides_(surface, row, chain, walls, grid_),
        faces_up_(faces_up(surface, chain, setting.frame)) {}

  Apron make() {
    apron_.crosses_itself = grid_.crosses_itself();
    if (!grid_.triangles().empty()) copy_triangles();
    return std::move(apron_);
  }

 private:
  void copy_triangles() {
    // For each edge of triangles copied so far: the sides of bounding surfaces from which the copies have their
    // heights.
    std::map<std::pair<Index, Index>, std::set<Index>> sides_at;
    std::vector<const Corners*> unseen;
    for (const Corners& t : grid_.triangles()) {
      const std::set<Index> sides = sides_.of(t);
      if (sides.empty()) unseen.push_back(&t);
      if (sides.size() > 1 && sides_.runs_on(t)) {
        const auto beyond = std::ranges::find_if(t, [&](Index v) { return sides.contains(sides_.before(v)); });
        if (beyond != t.end())
          copy(t, sides_.before(*beyond));
        else
          add({row_of(t[0]), row_of(t[1]), row_of(t[2])}, *sides.begin());
        continue;
      }
      for (const Index side : sides) {
        copy(t, side);
        for (std::size_t i = 0; i < 3; ++i) sides_at[std::minmax(t[i], t[(i + 1) % 3])].insert(side);
      }
    }
    // A triangle with no corner visible from the border may be partly visible, as where two bounding surfaces meet.
    for (const Corners* t : unseen) {
      std::set<Index> sides;
      for (std::size_t i = 0; i < 3; ++i)
        if (const auto at = sides_at.find(std::minmax((*t)[i], (*t)[(i + 1) % 3])); at != sides_at.end())
          sides.insert(at->second.begin(), at->second.end());
      for (const Index side : sides) copy(*t, side);
    }
    apron_.walls.assign(grid_.hidden_by().begin(), grid_.hidden_by().end());
  }

  /// Adds a copy of a triangle that bounding surfaces divide, with heights extrapolated from one of their sides.
  void copy(const Corners& t, Index side) {
    Triangle own;
    for (std::size_t i = 0; i < 3; ++i) {
      own[i] = sides_[t[i]] == side ? row_of(t[i]) : twin_of(t[i], side);
      if (own[i] == no_vertex) return;
    }
    add(own, side);
  }

  void add(Triangle t, Index side) {
    if (!faces_up_) std::swap(t[1], t[2]);
    apron_.triangles.push_back(t);
    apron_.side.push_back(number_of_side_.emplace(side, static_cast<Index>(number_of_side_.size())).first->second);
  }

  VertexIndex add_point(const Vec3& p) {
    apron_.added.push_back(p);
    return static_cast<VertexIndex>(surface_.points.size() + apron_.added.size() - 1);
  }
  VertexIndex row_of(Index v) {
    if (v < grid_.n_border()) return border_.vertices[v];
    const auto [at, is_new] = rows_.emplace(std::pair(v, no_index), no_vertex);
    if (is_new) at->second = add_point(grid_.nodes()[v].point);
    return at->second;
  }
  /// Returns a copy of the border or grid node v with a height from `side`, another side of the bounding surfaces;
  /// no_vertex if that side has no border nearby.
  VertexIndex twin_of(Index v, Index side) {
    if (sides_.before(v) == side) return row_of(v);  // the surface itself connects border vertex v with nodes of `side`
    const auto [at, is_new] = rows_.emplace(std::pair(v, side), no_vertex);
    if (!is_new) return at->second;
    const Vec2& p = grid_.nodes()[v].place;
    for (const ChainInPlane::Nearest& near : grid_.chain().all_near(p, 2 * within_)) {
      const std::size_t vertex = near.along < 0.5 ? near.edge : grid_.chain().end_of(near.edge);
      if (sides_[vertex] != side) continue;
      at->second = add_point(grid_.node_at(p, near).point);
      break;
    }
    return at->second;
  }

  const TriangulatedSurface& surface_;
  const BorderChain& border_;
  double within_;
  ApronGrid grid_;
  ApronSides sides_;
  /// Indices of the new points, by grid node and by the side of the bounding surfaces that gives the height.
  std::map<std::pair<Index, Index>, VertexIndex> rows_;
  std::map<Index, Index> number_of_side_;
  bool faces_up_;
  Apron apron_;
};

}  // namespace

Apron make_apron(const TriangulatedSurface& surface, Index row, const BorderChain& chain, const Walls& walls,
                 const ApronSetting& setting) {
  return SidedApron(surface, row, chain, walls, setting).make();
}

}  // namespace geomesh::geomodel

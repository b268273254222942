// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/apron.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "common/union_find.hpp"
#include "rules/continuation/chain_in_plane.hpp"
#include "rules/planar/planar_fill.hpp"

namespace geomesh::geomodel {
namespace {

/// Least share of the distance by which points of the grid are apart: an apron has at most some ten rows.
constexpr double least_step = 1.0 / 8;
/// Grid points come no nearer to the border than this share of their distance from each other.
constexpr double room_at_border = 0.5;

using Corners = std::array<Index, 3>;

/// A vertex of the apron: of the border (the first ones, in the order of the chain) or of the grid.
struct Node {
  Vec2 place;
  Vec3 point;           ///< in the model
  double distance = 0;  ///< from the border's place that gives its height
  Index edge = 0;       ///< of the chain, there
  bool is_seen = true;  ///< no wall is between
};

class ApronMaker {
 public:
  ApronMaker(const TriangulatedSurface& surface, Index row, const BorderChain& chain, const Walls& walls,
             const ApronSetting& setting)
      : surface_(surface),
        row_(row),
        border_(chain),
        walls_(walls),
        frame_(setting.frame),
        within_(setting.within),
        bounds_(setting.bounds),
        chain_(surface, chain, setting.frame, setting.within),
        step_(std::clamp(chain_.mean_edge(), least_step * within_, within_)) {}

  Apron make() {
    for (Index k = 0; k < chain_.points().size(); ++k) {
      const Vec3& p = chain_.points()[k];
      nodes_.push_back(
          {{p.x, p.y}, surface_.points[border_.vertices[k]], 0, std::min(k, static_cast<Index>(chain_.n_edges() - 1))});
    }
    n_border_ = static_cast<Index>(nodes_.size());
    add_grid();
    if (nodes_.size() == n_border_ || !find_triangles()) return {};
    leave_out_open();
    find_sides();
    copy_triangles();
    return std::move(apron_);
  }

 private:
  /// The node at a place with the height that an edge of the chain gives it.
  Node node_at(const Vec2& p, const ChainInPlane::Nearest& at) const {
    return {p, frame_.to_model({p.x, p.y, chain_.height(p, at)}), at.distance, at.edge};
  }
  bool is_hidden(const Node& node, const ChainInPlane::Nearest& at) {
    const auto hit = walls_.first_surface(frame_.to_model(chain_.foot(at)), node.point, row_);
    if (hit) crossed_.insert(hit->surface);
    return hit.has_value();
  }

  /// Points beside the chain on a grid whose origin depends on the place in space alone.
  void add_grid() {
    Vec2 low = nodes_.front().place, high = low;
    for (const Node& n : nodes_) {
      low = {std::min(low.x, n.place.x), std::min(low.y, n.place.y)};
      high = {std::max(high.x, n.place.x), std::max(high.y, n.place.y)};
    }
    const double reach = within_ + step_;
    const auto first = [&](double v) { return static_cast<std::int64_t>(std::floor((v - reach) / step_)); };
    const auto last = [&](double v) { return static_cast<std::int64_t>(std::ceil((v + reach) / step_)); };
    for (std::int64_t j = first(low.y); j <= last(high.y); ++j)
      for (std::int64_t i = first(low.x); i <= last(high.x); ++i)
        add_node({static_cast<double>(i) * step_, static_cast<double>(j) * step_}, reach);
  }

  void add_node(const Vec2& p, double reach) {
    const auto nearest = chain_.nearest(p);
    if (!nearest || nearest->distance < room_at_border * step_ || nearest->distance > reach ||
        !chain_.is_outside(p, *nearest))
      return;
    // Beyond the distance it is the nearest place alone that may see it: the border is open there then.
    for (const ChainInPlane::Nearest& at : chain_.all_near(p, reach)) {
      if (at.distance > within_ && at.distance > nearest->distance) break;
      const Node node = node_at(p, at);
      if (is_hidden(node, at)) continue;
      nodes_.push_back(node);
      return;
    }
    nodes_.push_back(node_at(p, *nearest));
    nodes_.back().is_seen = false;
  }

  /// False where the chain crosses itself in the plane.
  bool find_triangles() {
    std::vector<std::pair<Index, Index>> constraints;
    for (std::size_t e = 0; e < chain_.n_edges(); ++e)
      constraints.emplace_back(static_cast<Index>(e), static_cast<Index>(chain_.end_of(e)));
    std::vector<Vec2> places;
    for (const Node& n : nodes_) places.push_back(n.place);
    const auto all = triangulate_plane(places, constraints);
    if (!all) return false;
    for (const PlanarTriangle& t : *all) {
      const auto& v = t.vertices;
      const Vec2 centre{(places[v[0]].x + places[v[1]].x + places[v[2]].x) / 3,
                        (places[v[0]].y + places[v[1]].y + places[v[2]].y) / 3};
      const auto at = chain_.nearest(centre);
      if (at && at->distance <= within_ + step_ && chain_.is_outside(centre, *at)) triangles_.push_back(v);
    }
    return true;
  }

  bool is_in_model(const Vec3& p) const {
    return p.x > bounds_.min.x && p.y > bounds_.min.y && p.z > bounds_.min.z && p.x < bounds_.max.x &&
           p.y < bounds_.max.y && p.z < bounds_.max.z;
  }

  /// Where a point of the model beyond the distance is seen no wall stops the surface: the border stays open there.
  void leave_out_open() {
    std::vector<std::uint8_t> is_open(chain_.n_edges(), 0);
    for (Index v = n_border_; v < nodes_.size(); ++v)
      if (nodes_[v].is_seen && nodes_[v].distance > within_ && is_in_model(nodes_[v].point))
        is_open[nodes_[v].edge] = 1;
    std::erase_if(triangles_, [&](const Corners& t) {
      return std::any_of(t.begin(), t.end(), [&](Index v) { return v >= n_border_ && is_open[nodes_[v].edge]; });
    });
  }

  bool is_parted(Index a, Index b) const {
    return walls_.first_surface(nodes_[a].point, nodes_[b].point, row_) ||
           walls_.first_surface(nodes_[b].point, nodes_[a].point, row_);
  }

  /// Whether triangles at the two vertices lead from one to the other past the wall between them: a wall that reaches
  /// into the surface and ends there parts nothing.
  bool is_joined_round_wall(VertexIndex a, VertexIndex b) {
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

  /// Nodes that hang together without a wall between are of one side.
  void find_sides() {
    UnionFind joined(nodes_.size());
    const auto join = [&](Index a, Index b) {
      if (nodes_[a].is_seen && nodes_[b].is_seen && joined.find(a) != joined.find(b) && !is_parted(a, b))
        joined.unite(a, b);
    };
    for (std::size_t e = 0; e < chain_.n_edges(); ++e) {
      const auto a = static_cast<Index>(e), b = static_cast<Index>(chain_.end_of(e));
      if (!is_parted(a, b) || is_joined_round_wall(border_.vertices[a], border_.vertices[b]))
        joined.unite(a, b);
      else
        parted_border_.insert(std::minmax(a, b));
    }
    for (const Corners& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i) join(t[i], t[(i + 1) % 3]);
    side_.assign(nodes_.size(), no_index);
    for (Index v = 0; v < nodes_.size(); ++v)
      if (nodes_[v].is_seen) side_[v] = joined.find(v);
  }

  std::set<Index> sides_of(const Corners& t) const {
    std::set<Index> sides;
    for (const Index v : t)
      if (side_[v] != no_index) sides.insert(side_[v]);
    return sides;
  }

  /// The surface as given runs on across a wall in a side of the triangle: so does what lies beside.
  bool runs_on(const Corners& t) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (parted_border_.contains(std::minmax(t[i], t[(i + 1) % 3]))) return true;
    return false;
  }

  void copy_triangles() {
    std::map<std::pair<Index, Index>, std::set<Index>> sides_at;  // sides of walls by sides of triangles
    std::vector<const Corners*> unseen;
    for (const Corners& t : triangles_) {
      const std::set<Index> sides = sides_of(t);
      if (sides.empty()) unseen.push_back(&t);
      if (sides.size() > 1 && runs_on(t)) {
        add({row_of(t[0]), row_of(t[1]), row_of(t[2])}, *sides.begin());
        continue;
      }
      for (const Index side : sides) {
        copy(t, side);
        for (std::size_t i = 0; i < 3; ++i) sides_at[std::minmax(t[i], t[(i + 1) % 3])].insert(side);
      }
    }
    // Of a triangle beside these an inner part may be seen though no corner is: where two walls meet, say.
    for (const Corners* t : unseen) {
      std::set<Index> sides;
      for (std::size_t i = 0; i < 3; ++i)
        if (const auto at = sides_at.find(std::minmax((*t)[i], (*t)[(i + 1) % 3])); at != sides_at.end())
          sides.insert(at->second.begin(), at->second.end());
      for (const Index side : sides) copy(*t, side);
    }
    apron_.walls.assign(crossed_.begin(), crossed_.end());
  }

  /// The triangle with the heights of one side.
  void copy(const Corners& t, Index side) {
    Triangle own;
    for (std::size_t i = 0; i < 3; ++i) {
      own[i] = side_[t[i]] == side ? row_of(t[i]) : twin_of(t[i], side);
      if (own[i] == no_vertex) return;
    }
    add(own, side);
  }

  void add(Triangle t, Index side) {
    if (!faces_up()) std::swap(t[1], t[2]);
    apron_.triangles.push_back(t);
    apron_.side.push_back(number_of_side_.emplace(side, static_cast<Index>(number_of_side_.size())).first->second);
  }

  VertexIndex add_point(const Vec3& p) {
    apron_.added.push_back(p);
    return static_cast<VertexIndex>(surface_.points.size() + apron_.added.size() - 1);
  }
  VertexIndex row_of(Index v) {
    if (v < n_border_) return border_.vertices[v];
    const auto [at, is_new] = rows_.emplace(std::pair(v, no_index), no_vertex);
    if (is_new) at->second = add_point(nodes_[v].point);
    return at->second;
  }
  /// A node at the place of another one with the height of a side; no_vertex where that side has no border near.
  VertexIndex twin_of(Index v, Index side) {
    const auto [at, is_new] = rows_.emplace(std::pair(v, side), no_vertex);
    if (!is_new) return at->second;
    const Vec2& p = nodes_[v].place;
    for (const ChainInPlane::Nearest& near : chain_.all_near(p, 2 * within_)) {
      const std::size_t vertex = near.along < 0.5 ? near.edge : chain_.end_of(near.edge);
      if (side_[vertex] != side) continue;
      at->second = add_point(node_at(p, near).point);
      break;
    }
    return at->second;
  }

  /// Whether the surface's triangles at the chain are counter-clockwise in the frame, for most of the chain.
  bool faces_up() {
    if (faces_up_) return *faces_up_;
    double up = 0;
    for (const Index t : border_.triangles) {
      const Triangle& v = surface_.triangles[t];
      const Vec3 a = frame_.to_frame(surface_.points[v[0]]), b = frame_.to_frame(surface_.points[v[1]]),
                 c = frame_.to_frame(surface_.points[v[2]]);
      up += cross(b - a, c - a).z;
    }
    faces_up_ = up >= 0;
    return *faces_up_;
  }

  const TriangulatedSurface& surface_;
  Index row_;
  const BorderChain& border_;
  const Walls& walls_;
  const Frame& frame_;
  double within_;
  const Box3& bounds_;
  ChainInPlane chain_;
  double step_;
  Index n_border_ = 0;
  std::vector<Node> nodes_;
  std::vector<Corners> triangles_;
  std::vector<Index> side_;  ///< per node: the first node of its side; no_index where nothing sees it
  std::set<std::pair<Index, Index>> parted_border_;
  std::map<VertexIndex, std::set<VertexIndex>> ring_;    ///< neighbours of the surface's vertices, once asked for
  std::map<std::pair<Index, Index>, VertexIndex> rows_;  ///< by node and side (no_index: its own)
  std::map<Index, Index> number_of_side_;
  std::set<Index> crossed_;
  std::optional<bool> faces_up_;
  Apron apron_;
};

}  // namespace

Apron make_apron(const TriangulatedSurface& surface, Index row, const BorderChain& chain, const Walls& walls,
                 const ApronSetting& setting) {
  return ApronMaker(surface, row, chain, walls, setting).make();
}

}  // namespace geomesh::geomodel

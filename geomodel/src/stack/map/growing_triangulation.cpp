// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/map/growing_triangulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel {
namespace {

/// Sets the neighbours of cells (triangles) across the sides that they share.
class SidePairing {
 public:
  explicit SidePairing(std::vector<GrowingTriangulation::Cell>& cells) : cells_(cells) {}
  void add(Index cell, std::size_t side) {
    const Triangle& v = cells_[cell].vertices;
    const VertexIndex a = v[(side + 1) % 3], b = v[(side + 2) % 3];
    const auto [at, is_new] = open_.emplace(std::pair(std::min(a, b), std::max(a, b)), std::pair(cell, side));
    if (is_new) return;
    const auto [other, other_side] = at->second;
    cells_[cell].neighbours[side] = other;
    cells_[other].neighbours[other_side] = cell;
    open_.erase(at);
  }

 private:
  std::vector<GrowingTriangulation::Cell>& cells_;
  std::map<std::pair<VertexIndex, VertexIndex>, std::pair<Index, std::size_t>> open_;
};

/// Returns whether the angle at p between the ends of the segment ab is a right or an obtuse one.
bool encroaches(const Vec2& p, const Vec2& a, const Vec2& b) {
  return (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y) <= 0;
}

}  // namespace

GrowingTriangulation::GrowingTriangulation(const LinedTriangulation& start) : points_(start.points) {
  cells_.reserve(start.triangles.size());
  for (std::size_t t = 0; t < start.triangles.size(); ++t) {
    Cell cell{start.triangles[t], {no_index, no_index, no_index}, {}, no_index};
    for (std::size_t i = 0; i < 3; ++i) cell.lined[i] = start.lined_sides[t] >> i & 1;
    cells_.push_back(cell);
  }
  SidePairing pairing(cells_);
  for (Index c = 0; c < cells_.size(); ++c)
    for (std::size_t i = 0; i < 3; ++i) pairing.add(c, i);
  cell_of_vertex_.assign(points_.size(), no_index);
  for (Index c = 0; c < cells_.size(); ++c)
    for (std::size_t i = 0; i < 3; ++i) {
      cell_of_vertex_[cells_[c].vertices[i]] = c;
      if (cells_[c].neighbours[i] == no_index) cells_[c].lined[i] = true;
    }
  epoch_of_.assign(cells_.size(), 0);
  number_zones();
}

void GrowingTriangulation::number_zones() {
  std::vector<Index> stack;
  for (Index first = 0; first < cells_.size(); ++first) {
    if (cells_[first].zone != no_index) continue;
    const auto zone = static_cast<Index>(n_zones_++);
    cells_[first].zone = zone;
    stack.push_back(first);
    while (!stack.empty()) {
      const Cell& cell = cells_[stack.back()];
      stack.pop_back();
      for (std::size_t i = 0; i < 3; ++i)
        if (!cell.lined[i] && cells_[cell.neighbours[i]].zone == no_index) {
          cells_[cell.neighbours[i]].zone = zone;
          stack.push_back(cell.neighbours[i]);
        }
    }
  }
}

Index GrowingTriangulation::locate(const Vec2& p, Index hint) const {
  Index at = hint;
  std::size_t first = 0;  // the side of a cell that is tested first alternates, so that the walk does not loop
  for (std::size_t step = 0; step <= cells_.size(); ++step) {
    const Cell& cell = cells_[at];
    bool moved = false;
    for (std::size_t k = 0; k < 3 && !moved; ++k) {
      const std::size_t i = (first + k) % 3;
      const Vec2 &a = points_[cell.vertices[(i + 1) % 3]], &b = points_[cell.vertices[(i + 2) % 3]];
      if (orient2d(a, b, p) != Sign::negative) continue;
      if (cell.neighbours[i] == no_index) return no_index;
      at = cell.neighbours[i];
      moved = true;
    }
    if (!moved) return at;
    first = (first + 1) % 3;
  }
  for (at = 0; at < cells_.size(); ++at) {
    const Triangle& v = cells_[at].vertices;
    const auto sees = [&](std::size_t i) {
      return orient2d(points_[v[i]], points_[v[(i + 1) % 3]], p) != Sign::negative;
    };
    if (sees(0) && sees(1) && sees(2)) return at;
  }
  return no_index;
}

void GrowingTriangulation::star(VertexIndex v, std::vector<Index>& cells) const {
  cells.clear();
  const Index start = cell_of_vertex_[v];
  // Cells are visited in one direction around the vertex; if that ends at the triangulation's rim, in the other, too.
  for (const std::size_t turn : {1U, 2U}) {
    Index at = start;
    while (at != no_index) {
      if (turn == 1 || at != start) cells.push_back(at);
      const Cell& cell = cells_[at];
      const auto i =
          static_cast<std::size_t>(std::find(cell.vertices.begin(), cell.vertices.end(), v) - cell.vertices.begin());
      at = cell.neighbours[(i + turn) % 3];
      if (at == start) return;
    }
  }
}

void GrowingTriangulation::grow_cavity(const Vec2& p, Index at, Change& change) {
  ++epoch_;
  change.emptied.assign(1, at);
  epoch_of_[at] = epoch_;
  for (std::size_t k = 0; k < change.emptied.size(); ++k) {
    const Cell& cell = cells_[change.emptied[k]];
    for (std::size_t i = 0; i < 3; ++i) {
      const Index next = cell.neighbours[i];
      if (cell.lined[i] || is_in(next)) continue;
      const Triangle& v = cells_[next].vertices;
      if (in_circle(points_[v[0]], points_[v[1]], points_[v[2]], p) != Sign::positive) continue;
      epoch_of_[next] = epoch_;
      change.emptied.push_back(next);
    }
  }
}

void GrowingTriangulation::add(const Vec2& p, Index at, double shortest, Change& change) {
  change.vertex = no_vertex;
  change.made.clear();
  for (const VertexIndex v : cells_[at].vertices)
    if (points_[v] == p) return;
  grow_cavity(p, at, change);
  Index worst = no_index;
  std::size_t worst_side = 0;
  double longest = shortest;
  for (const Index c : change.emptied)
    for (std::size_t i = 0; i < 3; ++i) {
      if (!cells_[c].lined[i]) continue;
      const Vec2 &a = points_[cells_[c].vertices[(i + 1) % 3]], &b = points_[cells_[c].vertices[(i + 2) % 3]];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      const bool is_on = orient2d(a, b, p) == Sign::zero;
      if (is_on || (length > longest && encroaches(p, a, b))) {
        worst = c, worst_side = i, longest = length;
        if (is_on) longest = std::numeric_limits<double>::infinity();
      }
    }
  if (worst != no_index) return halve(worst, worst_side, change);
  if (is_crowded(p, 0.25 * shortest, change)) return;
  fill(p, {}, change);
}

bool GrowingTriangulation::is_crowded(const Vec2& p, double distance, const Change& change) const {
  for (const Index c : change.emptied)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2& v = points_[cells_[c].vertices[i]];
      if (std::hypot(v.x - p.x, v.y - p.y) < distance) return true;
      if (!cells_[c].lined[i]) continue;
      const Vec2 &a = points_[cells_[c].vertices[(i + 1) % 3]], &b = points_[cells_[c].vertices[(i + 2) % 3]];
      const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
      const double along = ((p.x - a.x) * dx + (p.y - a.y) * dy) / length;
      if (along < 0 || along > length) continue;
      if (std::abs((p.y - a.y) * dx - (p.x - a.x) * dy) < distance * length) return true;
    }
  return false;
}

void GrowingTriangulation::halve(Index cell, std::size_t side, Change& change) {
  const VertexIndex va = cells_[cell].vertices[(side + 1) % 3], vb = cells_[cell].vertices[(side + 2) % 3];
  const Vec2 a = points_[va], b = points_[vb];
  const Vec2 m{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
  if (m == a || m == b) return;
  // Splitting a segment removes both cells beside it. Rounding may put its midpoint beside the segment, but the
  // midpoint must still see all sides of the hole that the cells leave.
  const Index other = cells_[cell].neighbours[side];
  grow_cavity(m, cell, change);
  if (other != no_index && !is_in(other)) {
    epoch_of_[other] = epoch_;
    std::size_t next = change.emptied.size();
    change.emptied.push_back(other);
    for (; next < change.emptied.size(); ++next) {
      const Cell& c = cells_[change.emptied[next]];
      for (std::size_t i = 0; i < 3; ++i) {
        if (c.lined[i] || is_in(c.neighbours[i])) continue;
        const Triangle& v = cells_[c.neighbours[i]].vertices;
        if (in_circle(points_[v[0]], points_[v[1]], points_[v[2]], m) != Sign::positive) continue;
        epoch_of_[c.neighbours[i]] = epoch_;
        change.emptied.push_back(c.neighbours[i]);
      }
    }
  }
  for (const Index c : change.emptied)
    for (std::size_t i = 0; i < 3; ++i) {
      const Cell& in = cells_[c];
      const VertexIndex p = in.vertices[(i + 1) % 3], q = in.vertices[(i + 2) % 3];
      const bool is_piece = (p == va && q == vb) || (p == vb && q == va);
      if (is_piece || (in.neighbours[i] != no_index && is_in(in.neighbours[i]) && !in.lined[i])) continue;
      // The hole left by the removed cells is too narrow for doubles, so the constraint segment is not split.
      if (orient2d(points_[p], points_[q], m) != Sign::positive) return;
    }
  fill(m, std::array{va, vb}, change);
}

void GrowingTriangulation::fill(const Vec2& p, std::span<const VertexIndex> halved, Change& change) {
  struct CavityEdge {
    VertexIndex a, b;
    Index beyond, zone;
    bool lined;
  };
  const auto v = static_cast<VertexIndex>(points_.size());
  std::vector<CavityEdge> sides;
  for (const Index c : change.emptied)
    for (std::size_t i = 0; i < 3; ++i) {
      const Cell& cell = cells_[c];
      const VertexIndex a = cell.vertices[(i + 1) % 3], b = cell.vertices[(i + 2) % 3];
      const Index beyond = cell.neighbours[i];
      const bool inner = beyond != no_index && is_in(beyond);
      const bool is_halved = std::ranges::count(halved, a) + std::ranges::count(halved, b) == 2;
      if (!is_halved && !inner) sides.push_back({a, b, beyond, cell.zone, cell.lined[i]});
    }
  points_.push_back(p);
  change.vertex = v;
  // New cells by the first and by the last vertex of the side that they share with the cavity's border.
  std::map<VertexIndex, Index> starts, ends;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    Index row = static_cast<Index>(cells_.size());
    if (k < change.emptied.size()) {
      row = change.emptied[k];
    } else {
      cells_.emplace_back();
      epoch_of_.push_back(0);
    }
    const CavityEdge& s = sides[k];
    change.made.push_back(row);
    starts[s.a] = row;
    ends[s.b] = row;
  }
  cell_of_vertex_.push_back(change.made.front());
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const CavityEdge& s = sides[k];
    const Index row = change.made[k];
    if (s.beyond != no_index) {
      // The cell beyond the cavity's border still refers to a removed cell, so its side is found by the vertices.
      Cell& beyond = cells_[s.beyond];
      for (std::size_t i = 0; i < 3; ++i)
        if (beyond.vertices[(i + 1) % 3] == s.b && beyond.vertices[(i + 2) % 3] == s.a) beyond.neighbours[i] = row;
    }
    const auto after = starts.find(s.b), before = ends.find(s.a);
    Cell cell{{s.a, s.b, v}, {no_index, no_index, s.beyond}, {false, false, s.lined}, s.zone};
    cell.neighbours[0] = after == starts.end() ? no_index : after->second;  // side b v
    cell.neighbours[1] = before == ends.end() ? no_index : before->second;  // side v a
    for (const VertexIndex end : halved) {
      if (s.b == end) cell.lined[0] = true;
      if (s.a == end) cell.lined[1] = true;
    }
    cells_[row] = cell;
    cell_of_vertex_[s.a] = row;
    cell_of_vertex_[s.b] = row;
  }
}

}  // namespace geomesh::geomodel

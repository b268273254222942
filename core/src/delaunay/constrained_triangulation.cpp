// SPDX-License-Identifier: MIT
#include "delaunay/constrained_triangulation.hpp"

#include <algorithm>
#include <deque>
#include <numeric>

#include "mesh/spatial_order.hpp"

namespace geomesh {

namespace {

PlaneStore store_of(std::span<const Vec3> points) {
  PlaneStore store;
  store.records.resize(points.size() + 1);
  for (VertexIndex v = 0; v < points.size(); ++v) store.records[v] = PointRecord{points[v], v};
  store.records.back() = PointRecord{points[0], infinite_vertex};
  store.mesh.grow_to(SlotSource::block);
  return store;
}

}  // namespace

ConstrainedTriangulation::ConstrainedTriangulation(std::span<const Vec3> points, PlaneProjection projection)
    : PlaneStore(store_of(points)),
      Insertion(PlaneStore::mesh, PlaneSpace(records.data(), static_cast<VertexIndex>(points.size()), projection),
                SlotSource(0, SlotSource::block, 0, 1)) {}

bool ConstrainedTriangulation::start_with_a_triangle(std::vector<VertexIndex>& order) {
  if (order.size() < 3 || static_cast<const Vec3&>(records[order[0]]) == records[order[1]]) return false;
  const auto third = std::find_if(order.begin() + 2, order.end(),
                                  [&](VertexIndex v) { return orient(order[0], order[1], v) != Sign::zero; });
  if (third == order.end()) return false;
  std::rotate(order.begin() + 2, third, third + 1);
  if (orient(order[0], order[1], order[2]) == Sign::negative) std::swap(order[0], order[1]);
  start({order[0], order[1], order[2]});
  return true;
}

bool ConstrainedTriangulation::triangulate() {
  constexpr std::size_t few = 64;  // number of points up to which insertion is fast in any order of the points
  std::vector<VertexIndex> order(records.size() - 1);
  std::iota(order.begin(), order.end(), VertexIndex{0});
  if (order.size() > few) order = hilbert_order(std::vector<Vec3>(records.begin(), records.end() - 1));
  if (!start_with_a_triangle(order)) return false;
  for (std::size_t i = 3; i < order.size(); ++i)
    if (insert(order[i]) != InsertionOutcome::inserted) return false;
  slots().finish(mesh);
  refresh();
  cell_of_.assign(records.size(), no_cell);
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    for (const VertexIndex v : mesh.vertices(c)) cell_of_[v] = c;
  return true;
}

/// Returns the face opposite the apex of the cell on the left of edge a-b; invalid if there is no such edge.
FaceRef ConstrainedTriangulation::edge(VertexIndex a, VertexIndex b) const {
  CellIndex c = cell_of_[a];
  do {
    const unsigned i = mesh.index_of(c, a);
    if (mesh.vertex(c, (i + 1) % 3) == b) return FaceRef(c, (i + 2) % 3);
    c = mesh.neighbor_cell(c, (i + 1) % 3);
  } while (c != cell_of_[a]);
  return {};
}

std::optional<VertexIndex> ConstrainedTriangulation::apex(VertexIndex a, VertexIndex b) const {
  const FaceRef f = edge(a, b);
  if (!f.valid()) return std::nullopt;
  const VertexIndex v = mesh.vertex(f.cell(), f.face());
  return v == space().infinite() ? std::nullopt : std::optional(v);
}

bool ConstrainedTriangulation::is_flippable(VertexIndex a, VertexIndex b) const {
  const auto c = apex(a, b), d = apex(b, a);
  return c && d && orient(*d, b, *c) == Sign::positive && orient(*c, a, *d) == Sign::positive;
}

/// Replaces edge a-b by the edge from the apex p on its left to the apex q on its right.
void ConstrainedTriangulation::flip(VertexIndex a, VertexIndex b) {
  const FaceRef f = edge(a, b), g = mesh.mirror(f);
  const CellIndex c = f.cell(), d = g.cell();
  const VertexIndex p = mesh.vertex(c, f.face()), q = mesh.vertex(d, g.face());
  const FaceRef bp = mesh.neighbor(c, mesh.index_of(c, a)), pa = mesh.neighbor(c, mesh.index_of(c, b));
  const FaceRef aq = mesh.neighbor(d, mesh.index_of(d, b)), qb = mesh.neighbor(d, mesh.index_of(d, a));
  mesh.set_vertices(c, {p, a, q});
  mesh.set_vertices(d, {q, b, p});
  mesh.link({c, 0}, aq);
  mesh.link({c, 1}, {d, 1});
  mesh.link({c, 2}, pa);
  mesh.link({d, 0}, bp);
  mesh.link({d, 2}, qb);
  cell_of_[a] = cell_of_[p] = c;
  cell_of_[b] = cell_of_[q] = d;
}

void ConstrainedTriangulation::restore_delaunay() {
  std::vector<Edge> queue;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    for (unsigned i = 0; i < 3; ++i) {
      const Edge e{mesh.vertex(c, (i + 1) % 3), mesh.vertex(c, (i + 2) % 3)};
      if (e[0] < e[1] && e[1] != space().infinite()) queue.push_back(e);
    }
  while (!queue.empty()) {
    const auto [a, b] = queue.back();
    queue.pop_back();
    const auto c = apex(a, b), d = apex(b, a);
    if (!c || !d || is_constraint(a, b) || !is_flippable(a, b) || !space().finite_conflict({a, b, *c}, records[*d]))
      continue;
    flip(a, b);
    for (const Edge e : {Edge{a, *c}, Edge{*c, b}, Edge{b, *d}, Edge{*d, a}}) queue.push_back(e);
  }
}

/// Returns the face through which the segment a-b leaves the star of a, or the vertex of the star on the segment.
std::variant<FaceRef, ConstrainedTriangulation::Obstacle> ConstrainedTriangulation::exit_from_star(
    VertexIndex a, VertexIndex b) const {
  const auto side_of = [&](VertexIndex v) {
    return v == space().infinite() ? std::nullopt : std::optional(v == b ? Sign::zero : orient(a, b, v));
  };
  const auto is_ahead = [&](VertexIndex v) { return dot(records[v] - records[a], records[b] - records[a]) > 0; };
  const CellIndex first = cell_of_[a];
  std::optional<Sign> right = side_of(mesh.vertex(first, (mesh.index_of(first, a) + 1) % 3));
  CellIndex c = first;
  do {
    const unsigned i = mesh.index_of(c, a);
    const VertexIndex l = mesh.vertex(c, (i + 2) % 3);
    const std::optional<Sign> left = side_of(l);
    if (left == Sign::zero && is_ahead(l)) return Obstacle{l};
    if (right == Sign::negative && left == Sign::positive) return FaceRef(c, i);
    right = left;
    c = mesh.neighbor_cell(c, (i + 1) % 3);
  } while (c != first);
  return Obstacle{a, b};
}

template <class Visit>
std::optional<ConstrainedTriangulation::Obstacle> ConstrainedTriangulation::cross_edges(VertexIndex a, VertexIndex b,
                                                                                        const Visit& visit) const {
  const auto exit = exit_from_star(a, b);
  if (const auto* obstacle = std::get_if<Obstacle>(&exit)) return *obstacle;
  FaceRef f = std::get<FaceRef>(exit);
  while (true) {
    const FaceRef g = mesh.mirror(f);
    const CellIndex c = g.cell();
    const unsigned i = g.face(), of_left = (i + 1) % 3, of_right = (i + 2) % 3;
    const Edge crossed{mesh.vertex(c, of_right), mesh.vertex(c, of_left)};
    if (is_constraint(crossed[0], crossed[1])) return Obstacle{crossed[0], crossed[1]};
    if (!visit(crossed)) return std::nullopt;
    const VertexIndex v = mesh.vertex(c, i);
    if (v == space().infinite()) return Obstacle{a, b};
    if (v == b) return std::nullopt;
    const Sign side = orient(a, b, v);
    if (side == Sign::zero) return Obstacle{v};
    f = FaceRef(c, side == Sign::positive ? of_left : of_right);
  }
}

std::size_t ConstrainedTriangulation::n_crossed(VertexIndex a, VertexIndex b, std::size_t most) const {
  std::size_t n = 0;
  return cross_edges(a, b, [&](const Edge&) { return ++n < most; }) ? 0 : n;
}

std::optional<ConstrainedTriangulation::Obstacle> ConstrainedTriangulation::insert_constraint(VertexIndex a,
                                                                                              VertexIndex b) {
  if (!edge(a, b).valid()) {
    std::vector<Edge> crossed;
    const auto list = [&](const Edge& e) {
      crossed.push_back(e);
      return true;
    };
    if (auto obstacle = cross_edges(a, b, list)) return obstacle;
    // Flips crossed edges whose quadrilateral is convex until the segment a-b crosses no edge.
    std::deque<Edge> queue(crossed.begin(), crossed.end());
    while (!queue.empty()) {
      const auto [p, q] = queue.front();
      queue.pop_front();
      if (!is_flippable(p, q)) {
        queue.push_back({p, q});
        continue;
      }
      const VertexIndex c = *apex(p, q), d = *apex(q, p);
      flip(p, q);
      const bool touches = c == a || c == b || d == a || d == b;
      if (!touches && orient(a, b, c) * orient(a, b, d) == Sign::negative) queue.push_back({c, d});
    }
  }
  constraints_.insert({a, b}, 0);
  return std::nullopt;
}

std::vector<Triangle> ConstrainedTriangulation::triangles_left_of(std::vector<Edge> from,
                                                                  std::span<const Edge> barriers) const {
  EdgeMap closed;
  for (const Edge& e : barriers) closed.insert(e, 0);
  DirectedEdgeSet seen;
  std::vector<Triangle> out;
  while (!from.empty()) {
    const auto [a, b] = from.back();
    from.pop_back();
    const auto c = apex(a, b);
    if (!c || seen.contains({a, b})) continue;
    out.push_back({a, b, *c});
    for (const Edge e : {Edge{a, b}, Edge{b, *c}, Edge{*c, a}}) {
      seen.insert(e);
      if (closed.find(e) == no_index) from.push_back({e[1], e[0]});
    }
  }
  return out;
}

}  // namespace geomesh

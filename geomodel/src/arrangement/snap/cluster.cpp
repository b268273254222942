// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulates overlapping facets together, declared in arrangement/model/arranged.hpp.
#include <algorithm>
#include <cmath>

#include "arrangement/model/arranged.hpp"
#include "arrangement/model/planar_triangulation.hpp"
#include "geomesh/core/error.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

/// Sorts points by rows of a coarse lattice, in alternating direction, so that consecutive points are near each other.
void sort_in_rows(std::vector<int>& order, const std::vector<PlanarPoint>& points, const Projection& frame) {
  Box3 box;
  for (const int p : order) box.add(points[p].rounded);
  const double rows = std::sqrt(static_cast<double>(order.size()) / 2), height = box.max[frame.j] - box.min[frame.j];
  struct Key {
    long row;
    double x;
    int p;
    bool operator<(const Key& o) const { return row != o.row ? row < o.row : x != o.x ? x < o.x : p < o.p; }
  };
  std::vector<Key> keys;
  for (const int p : order) {
    const Vec3& q = points[p].rounded;
    const long row = height > 0 ? static_cast<long>((q[frame.j] - box.min[frame.j]) / height * rows) : 0;
    keys.push_back({row, row % 2 == 0 ? q[frame.i] : -q[frame.i], p});
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t k = 0; k < keys.size(); ++k) order[k] = keys[k].p;
}

/// The constraint lines in a cluster of coplanar facets, and the points made where two of these lines cross.
class Crossings {
 public:
  Crossings(const Complex& complex, const ExactFrame& frame, Index plane)
      : complex_(complex), frame_(frame), plane_(plane) {}

  int add(const Line& line) {
    lines_.push_back(line);
    return static_cast<int>(lines_.size()) - 1;
  }
  /// Makes the point where two constraint lines cross. Its index in the triangulation is `row`.
  PlanarPoint make(int row_a, int row_b, std::size_t row) {
    const Line a = lines_[row_a], b = lines_[row_b];
    ExactPoint p;
    if (a.is_edge() && b.is_edge())
      p = line_line_point(frame_, point(a.a), point(a.b), point(b.a), point(b.b));
    else if (a.is_edge())
      p = line_plane_point(frame_, point(a.a), point(a.b), plane_of(b.a));
    else if (b.is_edge())
      p = line_plane_point(frame_, point(b.a), point(b.b), plane_of(a.a));
    else
      p = three_planes_point(frame_, plane_of(plane_), plane_of(a.a), plane_of(b.a));
    made_.push_back(std::move(p));
    rows_.push_back(static_cast<int>(row));
    return {frame_.to_nearest(made_.back()), &made_.back()};
  }
  /// Converts the triangulation's index of a point made where constraints cross to its index among these points.
  Index number(int row) const {
    return static_cast<Index>(std::lower_bound(rows_.begin(), rows_.end(), row) - rows_.begin());
  }
  /// Moves the points where constraint lines cross to `pieces`, with the triangulation's roundings of their places.
  void move_to(ClusterPieces& pieces, const std::vector<PlanarPoint>& points) {
    for (std::size_t k = 0; k < made_.size(); ++k) {
      pieces.made_rounded.push_back(points[rows_[k]].rounded);
      pieces.made.push_back(std::move(made_[k]));
    }
  }

 private:
  const Vec3& point(VertexIndex v) const { return complex_.points[v]; }
  PlanePoints plane_of(Index facet) const {
    const Triangle& t = complex_.facets[facet];
    return {point(t[0]), point(t[1]), point(t[2])};
  }

  const Complex& complex_;
  const ExactFrame& frame_;
  Index plane_;  ///< one of the cluster's coplanar facets, which gives their plane
  std::vector<Line> lines_;
  std::deque<ExactPoint> made_;
  std::vector<int> rows_;  ///< of made_, ascending
};

/// Marks the faces inside one facet of the cluster by a flood fill that does not cross the facet's border. `corners`
/// are those of the facet in counter-clockwise order.
void cover(const PlanarTriangulation& mesh, const std::array<int, 3>& corners, Index member,
           std::vector<std::vector<Index>>& members_of) {
  std::vector<std::pair<int, int>> border;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<int> chain = mesh.chain(corners[k], corners[(k + 1) % 3]);
    for (std::size_t s = 0; s + 1 < chain.size(); ++s) border.push_back(mesh.left_face(chain[s], chain[s + 1]));
  }
  std::sort(border.begin(), border.end());
  const auto is_in = [&](int f) { return !members_of[f].empty() && members_of[f].back() == member; };
  std::vector<int> stack{border.front().first};
  members_of[stack.back()].push_back(member);
  while (!stack.empty()) {
    const int f = stack.back();
    stack.pop_back();
    for (int e = 0; e < 3; ++e) {
      const int g = mesh.faces()[f].neighbour[e];
      if (std::binary_search(border.begin(), border.end(), std::pair{f, e}) || is_in(g)) continue;
      members_of[g].push_back(member);
      stack.push_back(g);
    }
  }
}

/// The triangulation of a cluster (overlapping coplanar facets) in its plane, and the pieces of facets made from it.
class Cluster {
 public:
  Cluster(const Complex& complex, const ExactVertices& vertices, ClusterInput input)
      : complex_(complex),
        vertices_(vertices),
        input_(std::move(input)),
        frame_(projection_of(point(base()[0]), point(base()[1]), point(base()[2]))),
        crossings_(complex, vertices.frame(), input_.members.front()),
        mesh_(vertices.frame(), frame_.i, frame_.j,
              [this](int a, int b) { return crossings_.make(a, b, mesh_.points().size()); }) {}

  ClusterPieces run() {
    add_points();
    if (input_.members.size() == 1)
      start_with_the_facet();
    else
      start_with_a_frame();
    insert_points();
    for (const auto& c : input_.constraints) mesh_.insert_constraint(local(c.a), local(c.b), crossings_.add(c.line));
    if (input_.members.size() == 1)
      take_all();
    else
      take_covered();
    return std::move(pieces_);
  }

 private:
  const Vec3& point(VertexIndex v) const { return complex_.points[v]; }
  const Triangle& base() const { return complex_.facets[input_.members.front()]; }
  int local(Index v) const { return static_cast<int>(std::lower_bound(ids_.begin(), ids_.end(), v) - ids_.begin()); }
  Sign sign_of(Index member) const {
    const Triangle& t = complex_.facets[member];
    return mesh_.orient(local(t[0]), local(t[1]), local(t[2]));
  }
  std::array<int, 3> local_corners(const Triangle& t) const { return {local(t[0]), local(t[1]), local(t[2])}; }
  Triangle turning_left(Index member) const {
    Triangle t = complex_.facets[member];
    if (sign_of(member) == Sign::negative) std::swap(t[1], t[2]);
    return t;
  }

  void add_points() {
    ids_ = input_.points;
    for (const Index m : input_.members) ids_.insert(ids_.end(), complex_.facets[m].begin(), complex_.facets[m].end());
    for (const auto& c : input_.constraints) ids_.insert(ids_.end(), {c.a, c.b});
    std::sort(ids_.begin(), ids_.end());
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
    for (const Index v : ids_) mesh_.add_point({vertices_.rounded(v), vertices_.made(v)});
  }

  void start_with_the_facet() {
    const Triangle t = turning_left(input_.members.front());
    mesh_.start(local(t[0]), local(t[1]), local(t[2]));
    mesh_.constrain_border({crossings_.add(Line::edge(t[1], t[2])), crossings_.add(Line::edge(t[2], t[0])),
                            crossings_.add(Line::edge(t[0], t[1]))});
  }

  /// Starts the triangulation with a triangle around all facets of the cluster; no face that touches it is kept. Its
  /// coordinates are integers in the exact frame.
  void start_with_a_frame() {
    const std::size_t i = frame_.i, j = frame_.j;
    Vec3 centre = point(base()[0]);
    double extent = 0;
    for (const Index v : ids_)
      extent = std::max(
          {extent, std::fabs(vertices_.rounded(v)[i] - centre[i]), std::fabs(vertices_.rounded(v)[j] - centre[j])});
    const double h = std::ldexp(1.0, std::ilogb(extent) + 2);
    n_points_ = static_cast<int>(ids_.size());
    for (const auto& [x, y] : {std::pair{-8.0, -4.0}, std::pair{8.0, -4.0}, std::pair{0.0, 8.0}}) {
      Vec3 p = centre;
      p[i] += x * h;
      p[j] += y * h;
      mesh_.add_point({p, nullptr});
    }
    mesh_.start(n_points_, n_points_ + 1, n_points_ + 2);
    for (const Index m : input_.members) {
      const Triangle& t = complex_.facets[m];
      for (std::size_t k = 0; k < 3; ++k) {
        const Line line = Line::edge(t[k], t[(k + 1) % 3]);
        input_.constraints.push_back({line.a, line.b, line});
      }
    }
    std::sort(input_.constraints.begin(), input_.constraints.end());
    input_.constraints.erase(std::unique(input_.constraints.begin(), input_.constraints.end()),
                             input_.constraints.end());
  }

  /// Inserts the points in an order in which each point is located by a short walk.
  void insert_points() {
    const int n = static_cast<int>(ids_.size());
    std::vector<int> order(n);
    for (int k = 0; k < n; ++k) order[k] = k;
    if (n > 16) sort_in_rows(order, mesh_.points(), frame_);
    for (const int p : order) mesh_.insert_point(p);
  }

  VertexIndex id_of(int p) const {
    if (p < static_cast<int>(ids_.size())) return ids_[p];
    return ClusterPieces::made_here | crossings_.number(p);
  }

  void push(const PlanarTriangulation::Face& face, std::vector<Origin> origins, Sign orientation) {
    Triangle t{id_of(face.v[0]), id_of(face.v[1]), id_of(face.v[2])};
    if (orientation == Sign::negative) std::swap(t[1], t[2]);
    pieces_.facets.push_back(t);
    pieces_.origins.push(origins);
  }

  void take_all() {
    const Index m = input_.members.front();
    const auto list = complex_.origins.of(m);
    const std::vector<Origin> origins(list.begin(), list.end());
    for (const auto& face : mesh_.faces()) push(face, origins, sign_of(m));
    crossings_.move_to(pieces_, mesh_.points());
  }

  void take_covered() {
    std::vector<std::vector<Index>> members_of(mesh_.faces().size());
    for (const Index m : input_.members) cover(mesh_, local_corners(turning_left(m)), m, members_of);
    for (std::size_t f = 0; f < mesh_.faces().size(); ++f) {
      std::vector<Origin> origins;
      for (const Index m : members_of[f])
        for (Origin o : complex_.origins.of(m)) {
          o.reversed = (sign_of(m) == Sign::negative) != o.reversed;
          origins.push_back(o);
        }
      if (origins.empty()) continue;
      const bool right = normalise_origins(origins);
      push(mesh_.faces()[f], std::move(origins), right ? Sign::negative : Sign::positive);
    }
    crossings_.move_to(pieces_, mesh_.points());
  }

  const Complex& complex_;
  const ExactVertices& vertices_;
  ClusterInput input_;
  Projection frame_;
  Crossings crossings_;
  PlanarTriangulation mesh_;
  std::vector<Index> ids_;
  int n_points_ = 0;
  ClusterPieces pieces_;
};

}  // namespace

ClusterPieces triangulate_cluster(const Complex& complex, const ExactVertices& vertices, ClusterInput input) {
  return Cluster(complex, vertices, std::move(input)).run();
}

}  // namespace geomesh::geomodel::arrangement

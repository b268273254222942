// SPDX-License-Identifier: GPL-3.0-or-later
// Splits a facet at the vertices near it, declared in arrangement/snap/snap.hpp.
#include <algorithm>
#include <cmath>
#include <map>

#include "arrangement/model/planar_triangulation.hpp"
#include "arrangement/snap/snap.hpp"
#include "geomesh/core/error.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

/// Thrown by the triangulation of a facet if two constraints cross.
struct ConstraintsCross {};

class FacetSplitter {
 public:
  FacetSplitter(const std::vector<Vec3>& points, const Projection& frame)
      : points_(points),
        frame_(frame),
        mesh_(no_exact_points_, frame.i, frame.j, [](int, int) -> PlanarPoint { throw ConstraintsCross{}; }) {}

  /// Inserts a facet's vertices in the triangulation. Returns false if two border vertices coincide in the projection.
  bool add_vertices(const std::vector<VertexIndex>& border, const std::vector<VertexIndex>& inside) {
    for (const VertexIndex v : border)
      if (!rows_.contains(v) && !add(v)) return false;
    for (const VertexIndex v : inside)
      if (!rows_.contains(v)) add(v);  // an inner vertex whose projection coincides with another's is left out
    start_with_a_frame();
    for (int p = 0; p < n_vertices(); ++p) mesh_.insert_point(p);
    return true;
  }

  /// Throws ConstraintsCross.
  void constrain(const std::vector<EdgeKey>& edges) {
    for (const auto& [a, b] : edges)
      if (rows_.contains(a) && rows_.contains(b)) mesh_.insert_constraint(rows_.at(a), rows_.at(b), 0);
  }

  /// Returns whether no edge of the closed walk has another vertex of the walk on it. In projection along an axis,
  /// vertices can be collinear in another order than on their edge in space. The walk then runs back and forth, and the
  /// space between its edges would be lost.
  bool has_edges_of(const std::vector<VertexIndex>& walk) const {
    for (std::size_t k = 0; k < walk.size(); ++k) {
      const std::vector<int> chain = mesh_.chain(rows_.at(walk[k]), rows_.at(walk[(k + 1) % walk.size()]));
      for (std::size_t s = 1; s + 1 < chain.size(); ++s)
        if (std::find(walk.begin(), walk.end(), ids_[static_cast<std::size_t>(chain[s])]) != walk.end()) return false;
    }
    return true;
  }

  /// Returns the triangles on the left of the closed walk along `border`.
  std::vector<Triangle> inside_of(const std::vector<VertexIndex>& border) const {
    std::map<std::pair<int, int>, int> walls;  // number of times that the closed walk traverses each directed edge
    for (std::size_t k = 0; k < border.size(); ++k) {
      const std::vector<int> chain = mesh_.chain(rows_.at(border[k]), rows_.at(border[(k + 1) % border.size()]));
      for (std::size_t s = 0; s + 1 < chain.size(); ++s) ++walls[{chain[s], chain[s + 1]}];
    }
    const auto times = [&walls](int a, int b) {
      const auto at = walls.find({a, b});
      return at == walls.end() ? 0 : at->second;
    };
    std::vector<std::uint8_t> in(mesh_.faces().size(), 0);
    std::vector<int> stack;
    const auto visit = [&](int f) {
      if (!std::exchange(in[static_cast<std::size_t>(f)], 1)) stack.push_back(f);
    };
    for (const auto& [edge, n] : walls)
      if (n > times(edge.second, edge.first)) visit(mesh_.left_face(edge.first, edge.second).first);
    while (!stack.empty()) {
      const PlanarTriangulation::Face& face = mesh_.faces()[static_cast<std::size_t>(stack.back())];
      stack.pop_back();
      for (std::size_t e = 0; e < 3; ++e) {
        const int a = face.v[(e + 1) % 3], b = face.v[(e + 2) % 3];
        if (face.neighbour[e] >= 0 && times(a, b) == times(b, a)) visit(face.neighbour[e]);
      }
    }
    return collect(in);
  }

 private:
  int n_vertices() const { return static_cast<int>(ids_.size()); }

  bool add(VertexIndex v) {
    if (!seen_.try_emplace({points_[v][frame_.i], points_[v][frame_.j]}, v).second) return false;
    rows_[v] = mesh_.add_point({points_[v], nullptr});
    ids_.push_back(v);
    return true;
  }

  void start_with_a_frame() {
    const Vec3 centre = points_[ids_.front()];
    double extent = 0;
    for (const VertexIndex v : ids_)
      for (const std::size_t k : {frame_.i, frame_.j}) extent = std::max(extent, std::fabs(points_[v][k] - centre[k]));
    const double h = std::ldexp(1.0, std::ilogb(extent) + 2);
    for (const auto& [x, y] : {std::pair{-8.0, -4.0}, std::pair{8.0, -4.0}, std::pair{0.0, 8.0}}) {
      Vec3 p = centre;
      p[frame_.i] += x * h;
      p[frame_.j] += y * h;
      mesh_.add_point({p, nullptr});
    }
    mesh_.start(n_vertices(), n_vertices() + 1, n_vertices() + 2);
  }

  /// Returns the triangles marked in `in`. Throws ConstraintsCross if one has a corner of the triangle around all
  /// points, because then the walk along the facet's border is clockwise.
  std::vector<Triangle> collect(const std::vector<std::uint8_t>& in) const {
    std::vector<Triangle> triangles;
    for (std::size_t f = 0; f < in.size(); ++f) {
      if (!in[f]) continue;
      Triangle t{};
      for (std::size_t k = 0; k < 3; ++k) {
        const int row = mesh_.faces()[f].v[k];
        if (row >= n_vertices()) throw ConstraintsCross{};
        t[k] = ids_[static_cast<std::size_t>(row)];
      }
      triangles.push_back(t);
    }
    return triangles;
  }

  const std::vector<Vec3>& points_;
  Projection frame_;
  ExactFrame no_exact_points_;
  PlanarTriangulation mesh_;
  std::vector<VertexIndex> ids_;
  std::map<VertexIndex, int> rows_;
  std::map<std::pair<double, double>, VertexIndex> seen_;
};

std::vector<EdgeKey> edges_of_walk(const std::vector<VertexIndex>& walk) {
  std::vector<EdgeKey> edges;
  for (std::size_t k = 0; k < walk.size(); ++k) edges.push_back(edge_key(walk[k], walk[(k + 1) % walk.size()]));
  return edges;
}

/// Removes parts of the walk that run back and forth along one edge.
void remove_spikes(std::vector<VertexIndex>& walk) {
  for (bool changed = true; changed && walk.size() > 2;) {
    changed = false;
    for (std::size_t k = 0; k < walk.size() && walk.size() > 2 && !changed; ++k) {
      const std::size_t a = k, b = (k + 1) % walk.size(), c = (k + 2) % walk.size();
      if (walk[a] != walk[b] && walk[a] != walk[c]) continue;
      walk.erase(walk.begin() + static_cast<std::ptrdiff_t>(b));
      changed = true;
    }
  }
}

/// Splits a facet in one projection; nothing if its border crosses itself in the projection, or winds the wrong way.
std::optional<std::vector<Triangle>> try_split(const std::vector<Vec3>& points, const Projection& frame,
                                               std::vector<VertexIndex> walk, const std::vector<VertexIndex>& inside,
                                               const std::vector<EdgeKey>& wanted) {
  if (frame.sign == Sign::zero) return std::nullopt;
  if (frame.sign == Sign::negative) std::reverse(walk.begin(), walk.end());
  FacetSplitter splitter(points, frame);
  if (!splitter.add_vertices(walk, inside)) return std::nullopt;
  try {
    splitter.constrain(edges_of_walk(walk));
    splitter.constrain(wanted);
    if (!splitter.has_edges_of(walk)) return std::nullopt;
    std::vector<Triangle> triangles = splitter.inside_of(walk);
    if (frame.sign == Sign::negative)
      for (Triangle& t : triangles) std::swap(t[1], t[2]);
    return triangles;
  } catch (const ConstraintsCross&) {
    return std::nullopt;
  }
}

/// Returns projections along the coordinate axes in which the closed polygon `walk` has at least half of its largest
/// projected area, in descending order of area.
std::vector<Projection> frames_of_walk(const std::vector<Vec3>& points, const std::vector<VertexIndex>& walk) {
  constexpr double least_share = 0.5;
  Vec3 area;
  for (std::size_t k = 1; k + 1 < walk.size(); ++k)
    area = area + cross(points[walk[k]] - points[walk[0]], points[walk[k + 1]] - points[walk[0]]);
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(),
                   [&](std::size_t a, std::size_t b) { return std::fabs(area[a]) > std::fabs(area[b]); });
  std::vector<Projection> frames;
  for (const std::size_t k : axes)
    if (std::fabs(area[k]) > 0 && std::fabs(area[k]) >= least_share * std::fabs(area[axes[0]]))
      frames.push_back({(k + 1) % 3, (k + 2) % 3, area[k] > 0 ? Sign::positive : Sign::negative});
  return frames;
}

}  // namespace

std::optional<std::vector<Triangle>> split_facet(const std::vector<Vec3>& points, const Triangle& facet,
                                                 const std::vector<VertexIndex>& border,
                                                 const std::vector<VertexIndex>& inside,
                                                 const std::vector<EdgeKey>& wanted) {
  std::vector<VertexIndex> walk = border;
  remove_spikes(walk);
  if (walk.size() < 3) return std::vector<Triangle>{};
  const auto split_as_seen = [&](const Projection& frame) {
    auto triangles = try_split(points, frame, walk, inside, wanted);
    return triangles || wanted.empty() ? triangles : try_split(points, frame, walk, inside, {});
  };
  if (auto triangles = split_as_seen(projection_of(points[facet[0]], points[facet[1]], points[facet[2]])))
    return triangles;
  // A needle's inserted vertices lie beside its plane, so its border is better seen in projection along an axis.
  for (const Projection& frame : frames_of_walk(points, walk))
    if (auto triangles = split_as_seen(frame)) return triangles;
  return std::nullopt;
}

}  // namespace geomesh::geomodel::arrangement

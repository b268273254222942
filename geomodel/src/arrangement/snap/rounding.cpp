// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/snap/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "arrangement/model/displacement.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

int sides_at(const Vec3& p, const Box3& box) {
  int n = 0;
  for (std::size_t i = 0; i < 3; ++i) n += p[i] == box.min[i] || p[i] == box.max[i] ? 1 : 0;
  return n;
}

/// Places to which constructed points may snap, in cells twice the snapping distance wide.
class Anchors {
 public:
  explicit Anchors(const RoundingOptions& options) : options_(options), snap_(options.snap) {}

  void add(const Vec3& p) {
    if (!options_.onto_sides_alone || (options_.box && sides_at(p, *options_.box) > 0)) cells_[cell_of(p)].push_back(p);
  }

  /// Returns the rounded place of a constructed point p: a stored place near it, or p itself, which is then stored.
  Vec3 place(const Vec3& p) {
    if (snap_ == 0) return p;
    const Vec3* const anchor = !options_.onto_sides_alone || is_beside_side(p) ? nearest(p) : nullptr;
    if (anchor) return *anchor;
    add(p);
    return p;
  }

 private:
  /// Returns the nearest stored place within the snapping distance of p that lies on all box planes of p, or null.
  const Vec3* nearest(const Vec3& p) const {
    const Vec3 reach{snap_, snap_, snap_}, low = cell_of(p - reach), high = cell_of(p + reach);
    const Vec3* best = nullptr;
    double best_distance = snap_;
    for (double x = low.x; x <= high.x; ++x)
      for (double y = low.y; y <= high.y; ++y)
        for (double z = low.z; z <= high.z; ++z) {
          const auto cell = cells_.find({x, y, z});
          if (cell == cells_.end()) continue;
          for (const Vec3& q : cell->second)
            if (length(p - q) < best_distance && keeps_sides(p, q)) {
              best = &q;
              best_distance = length(p - q);
            }
        }
    return best;
  }

  Vec3 cell_of(const Vec3& p) const {
    const double width = 2 * snap_;
    return {std::floor(p.x / width) + 0.0, std::floor(p.y / width) + 0.0, std::floor(p.z / width) + 0.0};
  }
  bool keeps_sides(const Vec3& p, const Vec3& q) const {
    for (std::size_t i = 0; options_.box && i < 3; ++i)
      if ((p[i] == options_.box->min[i] || p[i] == options_.box->max[i]) && p[i] != q[i]) return false;
    return true;
  }
  /// Returns whether the point p is closer to a side of the box than the snapping distance, but not on it.
  bool is_beside_side(const Vec3& p) const {
    for (std::size_t i = 0; options_.box && i < 3; ++i)
      for (const double side : {options_.box->min[i], options_.box->max[i]})
        if (p[i] != side && std::fabs(p[i] - side) < snap_) return true;
    return false;
  }

  const RoundingOptions& options_;
  double snap_;
  std::unordered_map<Vec3, std::vector<Vec3>, PointHash> cells_;
};

class Rounding {
 public:
  Rounding(const Arranged& arranged, const Complex& before, const RoundingOptions& options)
      : arranged_(arranged),
        before_(before),
        options_(options),
        anchors_(options),
        row_(arranged.vertices.size(), no_vertex) {}

  Rounded run() {
    for (const Triangle& t : arranged_.facets)
      for (const VertexIndex v : t) row_[v] = used;
    for (const auto& s : arranged_.segments) row_[s.a] = row_[s.b] = used;
    for (const auto& p : arranged_.isolated_points) row_[p.v] = used;
    number_vertices();
    take_facets();
    take_segments();
    for (const auto& p : arranged_.isolated_points) result_.complex.isolated_points.push_back({row_[p.v], p.point});
    result_.displacement = moves_.displacement();
    return std::move(result_);
  }

 private:
  static constexpr VertexIndex used = no_vertex - 1;

  void number_vertices() {
    const ExactVertices& vertices = arranged_.vertices;
    Complex& out = result_.complex;
    std::unordered_map<Vec3, VertexIndex, PointHash> made_at;
    if (options_.snap > 0) add_anchors();
    std::vector<Vec3> placed(vertices.size() - vertices.n_given());
    for (const Index v : order_of_placing()) made_at.emplace(placed[v - vertices.n_given()] = place(v), no_vertex);
    for (Index v = 0; v < vertices.n_given(); ++v) {
      if (row_[v] != used) continue;
      row_[v] = push_point(vertices.rounded(v), before_.input_point[v]);
      if (made_at.empty()) continue;
      const auto at = made_at.find(vertices.rounded(v));
      if (at != made_at.end()) at->second = row_[v];
    }
    for (Index v = static_cast<Index>(vertices.n_given()); v < vertices.size(); ++v) {
      if (row_[v] != used) continue;
      const Vec3& p = placed[v - vertices.n_given()];
      VertexIndex& row = made_at.at(p);
      const bool merged = row != no_vertex;
      if (!merged) row = push_point(p, no_index);
      row_[v] = row;
      const bool moved = note_displacement(v, p);
      if (merged || moved) moved_[row] = 1;
    }
    out.input_point.resize(out.points.size(), no_index);
  }

  /// Returns the used constructed vertices in the order in which they are rounded. If points may snap, those on the
  /// box's sides come first: they cannot leave a side, and others can snap to them.
  std::vector<Index> order_of_placing() const {
    const ExactVertices& vertices = arranged_.vertices;
    std::vector<Index> order;
    for (Index v = static_cast<Index>(vertices.n_given()); v < vertices.size(); ++v)
      if (row_[v] == used) order.push_back(v);
    if (options_.snap == 0 || !options_.box) return order;
    const auto n_sides = [&](Index v) { return sides_at(vertices.rounded(v), *options_.box); };
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return n_sides(a) > n_sides(b); });
    return order;
  }

  VertexIndex push_point(const Vec3& p, Index input_point) {
    result_.complex.points.push_back(p);
    result_.complex.input_point.push_back(input_point);
    moved_.push_back(0);
    return static_cast<VertexIndex>(result_.complex.points.size() - 1);
  }

  Vec3 place(Index v) {
    const Vec3& nearest = arranged_.vertices.rounded(v);
    return anchors_.place({nearest.x + 0.0, nearest.y + 0.0, nearest.z + 0.0});
  }

  void add_anchors() {
    std::vector<std::uint8_t> seen(arranged_.vertices.n_given(), 0);
    for (std::size_t f = 0; f < arranged_.facets.size(); ++f) {
      if (!arranged_.changed[f]) continue;
      for (const VertexIndex v : arranged_.facets[f])
        if (!arranged_.vertices.is_made(v) && !std::exchange(seen[v], 1)) anchors_.add(arranged_.vertices.rounded(v));
    }
  }

  /// Records the displacement of a constructed vertex. Returns true if its doubles differ from its exact place.
  bool note_displacement(Index v, const Vec3& p) {
    const ExactPoint& q = *arranged_.vertices.made(v);
    const ExactPoint r = arranged_.vertices.frame().to_exact_beyond(p);
    double squared = 0;
    bool moved = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const mpz_class difference = r[i] * q.w - q[i] * r.w;
      if (sgn(difference) == 0) continue;
      moved = true;
      const double d = arranged_.vertices.frame().ratio(difference, q.w * r.w);
      squared += d * d;
    }
    if (!moved) return false;
    moves_.note(std::sqrt(squared), p);
    return true;
  }

  void take_facets() {
    Complex& out = result_.complex;
    for (std::size_t f = 0; f < arranged_.facets.size(); ++f) {
      const Triangle& old = arranged_.facets[f];
      const Triangle t{row_[old[0]], row_[old[1]], row_[old[2]]};
      const bool dirty = moved_[t[0]] || moved_[t[1]] || moved_[t[2]];
      if (dirty && (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ||
                    projection_of(out.points[t[0]], out.points[t[1]], out.points[t[2]]).sign == Sign::zero)) {
        result_.vanished.push_back(
            {surfaces_of(arranged_.origins.of(f)), {out.points[t[0]], out.points[t[1]], out.points[t[2]]}});
        continue;
      }
      out.facets.push_back(t);
      out.origins.push(arranged_.origins.of(f));
      out.dirty_facet.push_back(dirty);
    }
  }

  void take_segments() {
    Complex& out = result_.complex;
    std::vector<std::array<Index, 3>> seen;
    for (const auto& s : arranged_.segments) {
      const VertexIndex a = row_[s.a], b = row_[s.b];
      if (a == b) continue;
      out.segments.push_back({a, b, s.polyline});
      out.dirty_segment.push_back(moved_[a] || moved_[b]);
    }
    remove_repeated_segments(out);
  }

  const Arranged& arranged_;
  const Complex& before_;
  const RoundingOptions& options_;
  Anchors anchors_;
  std::vector<VertexIndex> row_;
  std::vector<std::uint8_t> moved_;
  Rounded result_;
  MovesOfStep moves_;
};

}  // namespace

Rounded round_to_doubles(const Arranged& arranged, const Complex& before, const RoundingOptions& options) {
  return Rounding(arranged, before, options).run();
}

}  // namespace geomesh::geomodel::arrangement

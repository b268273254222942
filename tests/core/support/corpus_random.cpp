// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus_random.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "corpus_judge_parts.hpp"
#include "geomesh/core/delaunay.hpp"

namespace geomesh::test {

namespace {

class RandomModel {
 public:
  RandomModel(std::uint64_t seed, unsigned max_points, bool generic) : random_(seed * 0x9E3779B97F4A7C15u + 1) {
    place_points(20 + below(max_points - 19), generic);
    triangulate();
    distort();
    label();
  }

  PiecewiseLinearComplex choose() {
    PiecewiseLinearComplex plc;
    plc.points = points_;
    const double extra_faces = below(3) == 0 ? 0 : 0.3 * fraction() * fraction();
    const bool hull = below(4) != 0;
    std::set<std::array<VertexIndex, 2>> edges_of_facets;
    std::vector<std::uint8_t> used(points_.size(), 0);
    for (const auto& [face, sides] : faces_) {
      const Index a = label_[sides[0]], b = sides[1] == no_index ? no_index : label_[sides[1]];
      const bool wanted = b == no_index ? hull || a == 0 : a != b && (hull || a == 0 || b == 0);
      if (!wanted && fraction() >= extra_faces) continue;
      Triangle t = face;
      if (below(2)) std::swap(t[0], t[1]);
      plc.add_triangle(t);
      for (int k = 0; k < 3; ++k) {
        used[t[k]] = 1;
        edges_of_facets.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
      }
    }
    add_segments(plc, edges_of_facets, used);
    for (VertexIndex v = 0; v < points_.size(); ++v)
      if (!used[v] && below(4) == 0) {
        plc.isolated_points.push_back(v);
        used[v] = 1;
      }
    return without_unused(plc, used);
  }

 private:
  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  double fraction() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double around() { return 2 * fraction() - 1; }

  void place_points(std::size_t n, bool generic) {
    std::set<std::array<double, 3>> distinct;
    const bool on_grid = below(2) == 0 && !generic;
    const double grid = 2 + static_cast<double>(below(5));
    for (std::size_t attempt = 0; attempt < 4 * n && distinct.size() < n; ++attempt) {
      std::array<double, 3> p{fraction(), fraction(), fraction()};
      if (on_grid)
        for (double& x : p) x = std::floor(x * (grid + 1));
      distinct.insert(p);
    }
    for (int corner = 0; corner < 8 && !generic; ++corner) {
      const double far = on_grid ? grid : 1;
      distinct.insert({corner & 1 ? far : 0, corner & 2 ? far : 0, corner & 4 ? far : 0});
    }
    for (const auto& p : distinct) points_.push_back({p[0], p[1], p[2]});
  }

  void triangulate() {
    const TetMesh mesh = delaunay_tetrahedralization(points_).mesh;
    for (CellIndex c = 0; c < mesh.n_slots(); ++c)
      if (mesh.is_live(c) && !mesh.is_ghost(c)) cells_.push_back(mesh.vertices(c));
    star_.resize(points_.size());
    for (Index c = 0; c < cells_.size(); ++c) {
      for (VertexIndex v : cells_[c]) star_[v].push_back(c);
      for (const auto& f : faces_from_inside) {
        const Triangle key = oriented_key({cells_[c][f[0]], cells_[c][f[1]], cells_[c][f[2]]}).sorted;
        const auto [it, is_new] = faces_.try_emplace(key, std::array<Index, 2>{c, no_index});
        if (!is_new) it->second[1] = c;
      }
    }
    on_hull_.assign(points_.size(), 0);
    for (const auto& [face, sides] : faces_)
      if (sides[1] == no_index)
        for (VertexIndex v : face) on_hull_[v] = 1;
  }

  bool star_is_positive(VertexIndex v) const {
    for (Index c : star_[v]) {
      const Tetrahedron& t = cells_[c];
      if (exact_orientation(points_[t[0]], points_[t[1]], points_[t[2]], points_[t[3]]) <= 0) return false;
    }
    return true;
  }

  /// Moves inner vertices as far as their stars let them; then flattens by a power of two, which is exact.
  void distort() {
    const double extent = points_.back().x, reach = extent * (below(3) == 0 ? 0 : fraction());
    const std::uint64_t rounds = below(6);
    for (std::uint64_t round = 0; round < rounds; ++round)
      for (VertexIndex v = 0; v < points_.size(); ++v) {
        if (on_hull_[v]) continue;
        const Vec3 old = points_[v];
        double step = reach;
        for (int attempt = 0; attempt < 6; ++attempt, step /= 2) {
          points_[v] = old + Vec3{step * around(), step * around(), step * around()};
          if (star_is_positive(v)) break;
          points_[v] = old;
        }
      }
    const double flat = std::ldexp(1.0, -static_cast<int>(below(3) == 0 ? below(11) : 0));
    for (Vec3& p : points_) p.z *= flat;
  }

  /// Regions grown from random cells; region 0 is never empty.
  void label() {
    label_.assign(cells_.size(), no_index);
    const std::size_t n_regions = 1 + below(5);
    std::vector<Index> queue;
    for (Index r = 0; r < n_regions; ++r) {
      const Index c = r == 0 ? 0 : static_cast<Index>(below(cells_.size()));
      if (label_[c] != no_index) continue;
      label_[c] = r;
      queue.push_back(c);
    }
    while (!queue.empty()) {
      std::swap(queue[below(queue.size())], queue.back());
      const Index c = queue.back();
      queue.pop_back();
      for (const auto& f : faces_from_inside) {
        const auto sides = faces_.at(oriented_key({cells_[c][f[0]], cells_[c][f[1]], cells_[c][f[2]]}).sorted);
        const Index other = sides[0] == c ? sides[1] : sides[0];
        if (other == no_index || label_[other] != no_index) continue;
        label_[other] = label_[c];
        queue.push_back(other);
      }
    }
  }

  void add_segments(PiecewiseLinearComplex& plc, const std::set<std::array<VertexIndex, 2>>& taken,
                    std::vector<std::uint8_t>& used) {
    const double wanted = below(3) == 0 ? 0.1 * fraction() : 0;
    std::set<std::array<VertexIndex, 2>> edges;
    for (const Tetrahedron& t : cells_)
      for (int i = 0; i < 4; ++i)
        for (int k = 0; k < i; ++k) edges.insert({std::min(t[i], t[k]), std::max(t[i], t[k])});
    for (const auto& e : edges) {
      if (taken.count(e) || fraction() >= wanted) continue;
      plc.segments.push_back({e[0], e[1], static_cast<Index>(plc.segments.size())});
      used[e[0]] = used[e[1]] = 1;
    }
  }

  static PiecewiseLinearComplex without_unused(PiecewiseLinearComplex plc, const std::vector<std::uint8_t>& used) {
    std::vector<VertexIndex> row(used.size(), no_vertex);
    std::vector<Vec3> kept;
    for (VertexIndex v = 0; v < used.size(); ++v) {
      if (!used[v]) continue;
      row[v] = static_cast<VertexIndex>(kept.size());
      kept.push_back(plc.points[v]);
    }
    plc.points = kept;
    for (VertexIndex& v : plc.loop_vertices) v = row[v];
    for (VertexIndex& v : plc.isolated_points) v = row[v];
    for (auto& s : plc.segments) s = {row[s.a], row[s.b], s.curve};
    return plc;
  }

  std::mt19937_64 random_;
  std::vector<Vec3> points_;
  std::vector<Tetrahedron> cells_;
  std::vector<std::vector<Index>> star_;
  std::map<Triangle, std::array<Index, 2>> faces_;
  std::vector<std::uint8_t> on_hull_;
  std::vector<Index> label_;
};

}  // namespace

PiecewiseLinearComplex random_plc(std::uint64_t seed, unsigned max_points) {
  return RandomModel(seed, max_points, false).choose();
}
PiecewiseLinearComplex random_generic_plc(std::uint64_t seed, unsigned max_points) {
  return RandomModel(seed, max_points, true).choose();
}

}  // namespace geomesh::test

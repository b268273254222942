// SPDX-License-Identifier: GPL-3.0-or-later
#include "rounding.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace geomesh::geomodel::arrangement {
namespace {

struct PointHash {
  std::size_t operator()(const Vec3& p) const {
    const std::hash<double> h;
    return (h(p.x) * 0x9E3779B97F4A7C15ull ^ h(p.y)) * 0xC2B2AE3D27D4EB4Full ^ h(p.z);
  }
};

class Rounding {
 public:
  Rounding(const Arranged& arranged, const Complex& before, const RoundingOptions& options)
      : arranged_(arranged), before_(before), options_(options), row_(arranged.vertices.size(), no_vertex) {}

  Rounded run() {
    for (const Triangle& t : arranged_.facets)
      for (const VertexIndex v : t) row_[v] = used;
    for (const auto& s : arranged_.segments) row_[s.a] = row_[s.b] = used;
    for (const auto& p : arranged_.isolated_points) row_[p.v] = used;
    number_vertices();
    take_facets();
    take_segments();
    for (const auto& p : arranged_.isolated_points) result_.complex.isolated_points.push_back({row_[p.v], p.point});
    if (n_made_ > 0) result_.displacement.mean /= static_cast<double>(n_made_);
    return std::move(result_);
  }

 private:
  static constexpr VertexIndex used = no_vertex - 1;

  void number_vertices() {
    const ExactVertices& vertices = arranged_.vertices;
    Complex& out = result_.complex;
    std::unordered_map<Vec3, VertexIndex, PointHash> made_at;
    std::vector<Vec3> placed(vertices.size() - vertices.n_given());
    for (Index v = static_cast<Index>(vertices.n_given()); v < vertices.size(); ++v)
      if (row_[v] == used) made_at.emplace(placed[v - vertices.n_given()] = place(v), no_vertex);
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

  VertexIndex push_point(const Vec3& p, Index input_point) {
    result_.complex.points.push_back(p);
    result_.complex.input_point.push_back(input_point);
    moved_.push_back(0);
    return static_cast<VertexIndex>(result_.complex.points.size() - 1);
  }

  Vec3 place(Index v) const {
    Vec3 p = arranged_.vertices.rounded(v);
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] += 0.0;
      if (options_.grid == 0) continue;
      if (options_.box && (p[i] == options_.box->min[i] || p[i] == options_.box->max[i])) continue;
      p[i] = std::nearbyint(p[i] / options_.grid) * options_.grid + 0.0;
      if (options_.box) p[i] = std::clamp(p[i], options_.box->min[i], options_.box->max[i]);
    }
    return p;
  }

  /// True where the doubles are not the exact place.
  bool note_displacement(Index v, const Vec3& p) {
    ++n_made_;
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
    const double d = std::sqrt(squared);
    result_.displacement.mean += d;
    ++result_.displacement.points_moved;
    if (d > result_.displacement.largest) {
      result_.displacement.largest = d;
      result_.displacement.where = p;
    }
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
        ++result_.n_facets_collapsed;
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

  /// A well that runs to and fro along the same line gives each piece once.
  static void remove_repeated_segments(Complex& out) {
    std::vector<std::array<Index, 4>> keys;
    for (Index s = 0; s < out.segments.size(); ++s)
      keys.push_back({out.segments[s].polyline, std::min(out.segments[s].a, out.segments[s].b),
                      std::max(out.segments[s].a, out.segments[s].b), s});
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint8_t> repeated(out.segments.size(), 0);
    for (std::size_t k = 1; k < keys.size(); ++k)
      if (std::equal(keys[k].begin(), keys[k].begin() + 3, keys[k - 1].begin())) repeated[keys[k][3]] = 1;
    std::size_t kept = 0;
    for (std::size_t s = 0; s < out.segments.size(); ++s) {
      if (repeated[s]) continue;
      out.segments[kept] = out.segments[s];
      out.dirty_segment[kept++] = out.dirty_segment[s];
    }
    out.segments.resize(kept);
    out.dirty_segment.resize(kept);
  }

  const Arranged& arranged_;
  const Complex& before_;
  const RoundingOptions& options_;
  std::vector<VertexIndex> row_;
  std::vector<std::uint8_t> moved_;
  std::size_t n_made_ = 0;
  Rounded result_;
};

}  // namespace

Rounded round_to_doubles(const Arranged& arranged, const Complex& before, const RoundingOptions& options) {
  return Rounding(arranged, before, options).run();
}

}  // namespace geomesh::geomodel::arrangement

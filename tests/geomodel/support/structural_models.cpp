// SPDX-License-Identifier: GPL-3.0-or-later
#include "structural_models.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "dice.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "soup_models.hpp"

namespace geomesh::geomodel::testing {

namespace {

const Box3 model_box{{0, 0, -5000}, {16000, 9000, 0}};

/// Sum of a few waves.
struct Relief {
  struct Wave {
    double height, kx, ky, phase;
  };
  std::vector<Wave> waves;
  double operator()(double x, double y) const {
    double z = 0;
    for (const Wave& w : waves) z += w.height * std::sin(w.kx * x + w.ky * y + w.phase);
    return z;
  }
};

Relief relief(Dice& dice, double height, double shortest, double longest) {
  Relief out;
  for (int i = 0; i < 4; ++i) {
    const double k = 2 * std::numbers::pi / dice.log_between(shortest, longest),
                 a = dice.between(0, 2 * std::numbers::pi);
    out.waves.push_back({height * dice.between(0.3, 1), k * std::cos(a), k * std::sin(a), dice.between(0, 6.28)});
  }
  return out;
}

/// A horizon's grid reaches past the box on all sides.
TriangulatedSurface horizon(Dice& dice, const std::string& name, unsigned cells, double depth, double dip_x,
                            double dip_y) {
  const Relief shape = relief(dice, 60, 2500, 12000);
  const double noise = dice.between(0, 4);
  return grid_surface(name, SurfaceKind::horizon, cells, -311.7, 16287.3, -207.1, 9193.9, [&](double x, double y) {
    return depth + dip_x * (x - 8000) + dip_y * (y - 4500) + shape(x, y) + noise * (dice.unit() - 0.5);
  });
}

/// A fault surface through the whole box, over its trace's direction and down its dip: flatter with depth.
TriangulatedSurface fault(Dice& dice, const std::string& name, unsigned cells) {
  TriangulatedSurface s;
  s.name = name;
  s.kind = SurfaceKind::fault;
  const double strike = dice.between(0, std::numbers::pi), steep = dice.between(0.5, 1.1),
               flat = dice.between(0.1, 0.35);
  const double cx = dice.between(4000, 12000), cy = dice.between(2500, 6500), half = 19000;
  const Relief shape = relief(dice, 25, 1500, 6000);
  const Vec3 along{std::cos(strike), std::sin(strike), 0}, across{-std::sin(strike), std::cos(strike), 0};
  for (unsigned j = 0; j <= cells; ++j)
    for (unsigned i = 0; i <= cells; ++i) {
      const double u = -half + 2 * half * i / cells, depth = 300 - 6100.0 * j / cells;
      const double t = static_cast<double>(j) / cells;  // of the way down
      const double dip = steep + (flat - steep) * t;
      const double out = (300 - depth) / std::tan(std::max(0.25, dip)) + shape(u, depth);
      s.points.push_back(Vec3{cx, cy, depth} + u * along + out * across);
    }
  for (unsigned j = 0; j < cells; ++j)
    for (unsigned i = 0; i < cells; ++i) {
      const VertexIndex q = j * (cells + 1) + i;
      s.triangles.push_back({q, q + 1, q + cells + 2});
      s.triangles.push_back({q, q + cells + 2, q + cells + 1});
    }
  return s;
}

/// Beside a horizon, on the same grid: a little above it here, a little below it there, so that the two cross at very
/// low angles and leave wedges of a few metres or less.
TriangulatedSurface pinching_out(Dice& dice, const TriangulatedSurface& from, const std::string& name) {
  TriangulatedSurface out = from;
  out.name = name;
  const Relief thickness = relief(dice, dice.log_between(0.02, 10), 3000, 15000);
  for (Vec3& p : out.points) p.z += thickness(p.x, p.y);
  return out;
}

std::vector<TriangulatedSurface> surfaces_of(Dice& dice, unsigned cells) {
  std::vector<TriangulatedSurface> out;
  const unsigned n_horizons = 2 + static_cast<unsigned>(dice.below(3)),
                 n_faults = 1 + static_cast<unsigned>(dice.below(3));
  double depth = dice.between(-900, -500);
  for (unsigned h = 0; h < n_horizons; ++h) {
    const std::string name = "horizon_" + std::to_string(h);
    out.push_back(horizon(dice, name, cells, depth, dice.between(-0.02, 0.02), dice.between(-0.02, 0.02)));
    if (dice.below(2) == 0) out.push_back(pinching_out(dice, out.back(), name + "_wedge"));
    depth -= dice.between(150, 900);
  }
  for (unsigned f = 0; f < n_faults; ++f)
    out.push_back(fault(dice, "fault_" + std::to_string(f), 2 + static_cast<unsigned>(dice.below(cells / 2))));
  return out;
}

double angle_degrees(const Vec3& at, const Vec3& p, const Vec3& q) {
  const Vec3 u = p - at, v = q - at, n = cross(u, v);
  return std::atan2(std::sqrt(dot(n, n)), dot(u, v)) * 180 / std::numbers::pi;
}

double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::min({angle_degrees(a, b, c), angle_degrees(b, c, a), angle_degrees(c, a, b)});
}

double least_height(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
  return std::sqrt(dot(n, n) / longest);
}

/// The triangles of a soup, with their edges, while needles are made of them.
class NeedleMaker {
 public:
  NeedleMaker(PolygonSoup& soup, Dice& dice, double least_height)
      : points_(soup.points), triangles_(soup.facets), dice_(dice), least_height_(least_height) {
    for (Index t = 0; t < triangles_.size(); ++t) link(t);
  }

  /// Puts close points on edges where surfaces meet, a fan of needles on each side: until `share` of all triangles are
  /// needles.
  void fans_on_lines(double share) {
    std::vector<std::array<VertexIndex, 2>> lines;
    for (const auto& [edge, of] : triangles_of_)
      if (of.size() > 2) lines.push_back(edge);
    const std::size_t n_start = triangles_.size();
    for (std::size_t tries = 0; tries < 4 * n_start && !lines.empty(); ++tries) {
      if (static_cast<double>(n_made_) >= share * static_cast<double>(triangles_.size())) return;
      fan_on(lines[dice_.below(lines.size())]);
    }
  }

  /// Flips edges inside exactly plane parts (the box's sides) towards single corners, so that long needles lie side by
  /// side about these.
  void fans_in_planes(double share) {
    std::size_t n_flipped = 0;
    const std::size_t most = static_cast<std::size_t>(share * static_cast<double>(triangles_.size()));
    for (std::size_t tries = 0; tries < 20 * most + 100 && n_flipped < most; ++tries) {
      const Triangle t = triangles_[dice_.below(triangles_.size())];
      n_flipped += fan_about(t[dice_.below(3)], 40);
    }
  }

 private:
  using Edge = std::array<VertexIndex, 2>;
  static Edge key(VertexIndex a, VertexIndex b) { return {std::min(a, b), std::max(a, b)}; }
  void link(Index t) {
    for (unsigned i = 0; i < 3; ++i) triangles_of_[key(triangles_[t][i], triangles_[t][(i + 1) % 3])].push_back(t);
  }
  void unlink(Index t) {
    for (unsigned i = 0; i < 3; ++i) {
      auto& of = triangles_of_[key(triangles_[t][i], triangles_[t][(i + 1) % 3])];
      of.erase(std::find(of.begin(), of.end(), t));
    }
  }
  Index add(const Triangle& t) {
    triangles_.push_back(t);
    link(static_cast<Index>(triangles_.size() - 1));
    return static_cast<Index>(triangles_.size() - 1);
  }

  /// 2 to 8 points on the edge, close to each other.
  void fan_on(Edge edge) {
    const std::vector<Index> about = triangles_of_[edge];
    const Vec3 a = points_[edge[0]], b = points_[edge[1]];
    const double length = std::sqrt(dot(b - a, b - a));
    if (about.size() < 2 || length < 5) return;
    std::vector<double> places;
    double place = dice_.between(0.1, 0.8) * length;
    const std::size_t n = 2 + dice_.below(7);
    for (std::size_t i = 0; i < n && place < 0.95 * length; ++i) {
      places.push_back(place);
      place += dice_.log_between(least_height_, 1);
    }
    for (const Index t : about)
      if (least_height_beside(t, edge) < 100 * least_height_) return;
    std::vector<VertexIndex> chain{edge[0]};
    for (const double p : places) {
      points_.push_back(a + p / length * (b - a));
      chain.push_back(static_cast<VertexIndex>(points_.size() - 1));
    }
    chain.push_back(edge[1]);
    for (const Index t : about) {
      const Triangle old = triangles_[t];
      unsigned i = 0;
      while (key(old[i], old[(i + 1) % 3]) != edge) ++i;
      const bool forward = old[i] == edge[0];
      const VertexIndex apex = old[(i + 2) % 3];
      unlink(t);
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        const VertexIndex p = forward ? chain[k] : chain[k + 1], q = forward ? chain[k + 1] : chain[k];
        if (k == 0) {
          triangles_[t] = {p, q, apex};
          link(t);
        } else {
          add({p, q, apex});
        }
        n_made_ += smallest_angle(points_[p], points_[q], points_[apex]) < needle_degrees;
      }
    }
  }

  /// Of the triangle's corner over the edge, in relation to the edge's length.
  double least_height_beside(Index t, Edge edge) const {
    const Triangle& v = triangles_[t];
    const Vec3 &a = points_[edge[0]], &b = points_[edge[1]];
    const Vec3 n = cross(points_[v[1]] - points_[v[0]], points_[v[2]] - points_[v[0]]);
    return std::sqrt(dot(n, n) / dot(b - a, b - a));
  }

  /// Flips edges opposite v in plane triangles about it, so that v gets more neighbours.
  std::size_t fan_about(VertexIndex v, std::size_t most) {
    std::size_t n = 0;
    std::vector<Index> queue;
    for (const auto& [edge, of] : triangles_of_)
      if (edge[0] == v || edge[1] == v) queue.insert(queue.end(), of.begin(), of.end());
    for (std::size_t i = 0; i < queue.size() && n < most; ++i) {
      const Triangle t = triangles_[queue[i]];
      const auto at = std::find(t.begin(), t.end(), v);
      if (at == t.end()) continue;
      const unsigned k = static_cast<unsigned>(at - t.begin());
      if (!flip(v, t[(k + 1) % 3], t[(k + 2) % 3], queue)) continue;
      ++n;
    }
    return n;
  }
  bool flip(VertexIndex v, VertexIndex p, VertexIndex q, std::vector<Index>& made) {
    const std::vector<Index> of = triangles_of_[key(p, q)];
    if (of.size() != 2) return false;
    const Index mine = has(of[0], v) ? of[0] : of[1], other = mine == of[0] ? of[1] : of[0];
    VertexIndex w = no_vertex;
    for (const VertexIndex u : triangles_[other])
      if (u != p && u != q) w = u;
    if (w == v || !triangles_of_[key(v, w)].empty() || !directed_alike(mine, other, p, q)) return false;
    if (orient3d(points_[v], points_[p], points_[q], points_[w]) != Sign::zero) return false;
    if (!is_convex(v, p, w, q)) return false;
    const double before = std::min(smallest(mine), smallest(other));
    const double after = std::min(smallest_angle(points_[v], points_[p], points_[w]),
                                  smallest_angle(points_[v], points_[w], points_[q]));
    if (after > before || least_height(points_[v], points_[p], points_[w]) < least_height_ ||
        least_height(points_[v], points_[w], points_[q]) < least_height_)
      return false;
    unlink(mine);
    unlink(other);
    triangles_[mine] = {v, p, w};
    triangles_[other] = {v, w, q};
    link(mine);
    link(other);
    made.push_back(mine);
    made.push_back(other);
    return true;
  }
  bool has(Index t, VertexIndex v) const {
    return std::find(triangles_[t].begin(), triangles_[t].end(), v) != triangles_[t].end();
  }
  double smallest(Index t) const {
    return smallest_angle(points_[triangles_[t][0]], points_[triangles_[t][1]], points_[triangles_[t][2]]);
  }
  bool directed_alike(Index s, Index t, VertexIndex p, VertexIndex q) const {
    const auto forward = [&](Index f) {
      for (unsigned i = 0; i < 3; ++i)
        if (triangles_[f][i] == p && triangles_[f][(i + 1) % 3] == q) return true;
      return false;
    };
    return forward(s) != forward(t);
  }
  /// The diagonals v-w and p-q cross strictly, in the projection along the plane's largest normal.
  bool is_convex(VertexIndex v, VertexIndex p, VertexIndex w, VertexIndex q) const {
    const Vec3 n = cross(points_[p] - points_[v], points_[q] - points_[v]);
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (std::fabs(n[i]) > std::fabs(n[axis])) axis = i;
    const auto flat = [&](VertexIndex u) { return Vec2{points_[u][(axis + 1) % 3], points_[u][(axis + 2) % 3]}; };
    const auto side = [&](VertexIndex a, VertexIndex b, VertexIndex c) {
      return static_cast<int>(orient2d(flat(a), flat(b), flat(c)));
    };
    return side(v, w, p) * side(v, w, q) < 0 && side(p, q, v) * side(p, q, w) < 0;
  }

  std::vector<Vec3>& points_;
  std::vector<Triangle>& triangles_;
  Dice& dice_;
  std::map<Edge, std::vector<Index>> triangles_of_;
  double least_height_;  ///< m, of triangles made here
  std::size_t n_made_ = 0;
};

/// One origin a facet is all that a validator asks for.
void renew_origins(PolygonSoup& soup) {
  soup.kind.resize(soup.points.size(), SoupVertexKind::intersection);
  soup.input_point.resize(soup.points.size(), no_index);
  soup.origins.clear();
  soup.origin_offsets.assign(1, 0);
  for (Index f = 0; f < soup.facets.size(); ++f) {
    soup.origins.push_back({0, f, false});
    soup.origin_offsets.push_back(f + 1);
  }
}

}  // namespace

StructuralModel structural_model(unsigned seed, const StructuralModelOptions& options) {
  Dice dice(seed);
  ArrangementOptions arranged;
  arranged.box = model_box;
  PolygonSoup soup = arrange(surfaces_of(dice, options.cells_along), {}, {}, arranged).soup;
  const PolygonSoup plain = soup;
  for (unsigned attempt = 0;; ++attempt) {
    NeedleMaker maker(soup, dice, options.least_spacing);
    maker.fans_in_planes(0.3 * options.needle_share);
    maker.fans_on_lines(0.7 * options.needle_share);
    renew_origins(soup);
    if (validate_soup(soup, 1).empty()) break;
    if (attempt == 4) throw Error(ErrorKind::cannot_mesh, "no valid needles");
    soup = plain;  // rounding has bent triangles into each other
  }
  StructuralModel out;
  out.plc = complex_of(soup);
  out.smallest_angle = 180;
  out.least_height = 1e9;
  for (const Triangle& t : soup.facets) {
    const Vec3 &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    const double angle = smallest_angle(a, b, c);
    out.n_needles += angle < needle_degrees;
    out.smallest_angle = std::min(out.smallest_angle, angle);
    out.least_height = std::min(out.least_height, least_height(a, b, c));
  }
  return out;
}

StructuralModelOptions structural_options(unsigned seed, unsigned family) {
  Dice dice(seed + 7919 * family);
  constexpr unsigned least[] = {8, 18, 34}, most[] = {14, 30, 52};
  StructuralModelOptions out;
  out.cells_along = least[family] + static_cast<unsigned>(dice.below(most[family] - least[family] + 1));
  out.needle_share = dice.between(0.04, 0.10);
  out.least_spacing = dice.log_between(1e-5, 2e-2);
  return out;
}

}  // namespace geomesh::geomodel::testing

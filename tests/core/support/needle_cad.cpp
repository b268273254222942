// SPDX-License-Identifier: GPL-3.0-or-later
#include "needle_cad.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "corpus_builder.hpp"

namespace geomesh::test {

namespace {

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double unit() { return (static_cast<double>(random_()) + 0.5) / 4294967296.0; }
  double log_between(double a, double b) { return a * std::pow(b / a, unit()); }
  unsigned from_to(unsigned a, unsigned b) { return a + static_cast<unsigned>(random_() % (b - a + 1)); }

 private:
  std::mt19937 random_;
};

double angle_degrees(const Vec3& at, const Vec3& p, const Vec3& q) {
  const Vec3 u = p - at, v = q - at, n = cross(u, v);
  return std::atan2(std::sqrt(dot(n, n)), dot(u, v)) * 180 / std::numbers::pi;
}

/// By odd angles about all axes.
Vec3 turned(const Vec3& p) {
  const auto turn = [](double& u, double& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle), old = u;
    u = c * old - s * v;
    v = s * old + c * v;
  };
  Vec3 q = p;
  turn(q.x, q.y, 0.37);
  turn(q.y, q.z, 0.61);
  turn(q.z, q.x, 1.13);
  return q;
}

class PlateMaker {
 public:
  PlateMaker(unsigned seed, const NeedleCadOptions& options) : dice_(seed), options_(options) {}

  NeedleCadModel make() {
    for (unsigned j = 0; j < options_.cells_y; ++j)
      for (unsigned i = 0; i < options_.cells_x; ++i) add_square(i, j);
    add_rim();
    model_.plc = std::move(builder_.plc);
    for (Vec3& p : model_.plc.points) p = turned(p);
    return std::move(model_);
  }

 private:
  /// Angles of the points on a circle: four at the axes, the others at clusters between them.
  std::vector<double> angles(double radius) {
    std::vector<double> all;
    const double quarter = std::numbers::pi / 2;
    const double least = options_.least_spacing / radius;
    const unsigned n = options_.sides / 4;
    for (unsigned q = 0; q < 4; ++q) {
      all.push_back(q * quarter);
      std::vector<double> step;
      double sum = 0;
      for (unsigned k = 0; k < n; ++k) {
        step.push_back(dice_.log_between(least, quarter / n));
        sum += step.back();
      }
      double at = q * quarter;
      for (unsigned k = 0; k + 1 < n; ++k) {  // what is left of the quarter is the longest side
        at += step[k] * std::min(1.0, 0.9 * quarter / sum);
        all.push_back(at);
      }
    }
    return all;
  }

  void triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    builder_.triangle(a, b, c);
    model_.smallest_angle =
        std::min({model_.smallest_angle, angle_degrees(a, b, c), angle_degrees(b, c, a), angle_degrees(c, a, b)});
    model_.volume += dot(a, cross(b, c)) / 6;
  }

  /// The square without its circle, seen from above: each corner is the centre of a fan.
  void add_cap(const Vec3& middle, const std::vector<Vec3>& circle, double z, bool up) {
    const auto put = [&](Vec3 a, Vec3 b, Vec3 c) {
      a.z = b.z = c.z = z;
      up ? triangle(a, b, c) : triangle(a, c, b);
    };
    const std::size_t n = circle.size() / 4;
    const Vec3 corner[4] = {{0.5, 0.5, 0}, {-0.5, 0.5, 0}, {-0.5, -0.5, 0}, {0.5, -0.5, 0}};
    for (std::size_t q = 0; q < 4; ++q) {
      for (std::size_t k = 0; k < n; ++k)
        put(middle + corner[q], circle[(q * n + k + 1) % circle.size()], circle[q * n + k]);
      put(middle + corner[(q + 3) % 4], middle + corner[q], circle[q * n]);
    }
  }

  /// Between the circle at two heights; the normals point away from the middle where `outwards`.
  void add_wall(const std::vector<Vec3>& circle, double low, double high, bool outwards) {
    for (std::size_t k = 0; k < circle.size(); ++k) {
      Vec3 a = circle[k], b = circle[(k + 1) % circle.size()];
      a.z = b.z = low;
      Vec3 c = b, d = a;
      c.z = d.z = high;
      if (!outwards) std::swap(a, b), std::swap(c, d);
      triangle(a, b, c);
      triangle(a, c, d);
    }
  }

  void add_square(unsigned i, unsigned j) {
    const Vec3 middle{i + 0.5, j + 0.5, 0};
    const double radius = 0.5 - options_.web, top = options_.thickness;
    std::vector<Vec3> circle;
    for (const double a : angles(radius)) circle.push_back(middle + radius * Vec3{std::cos(a), std::sin(a), 0});
    add_cap(middle, circle, top, true);
    if (dice_.unit() >= options_.post_share) {
      add_cap(middle, circle, 0, false);
      add_wall(circle, 0, top, false);
      return;
    }
    const double end = top + dice_.log_between(0.01, 2);  // a post stands on the plate, its end is one fan
    add_wall(circle, top, end, true);
    const auto fan = [&](double z, bool up) {
      std::vector<Vec3> level = circle;
      for (Vec3& p : level) p.z = z;
      for (std::size_t k = 1; k + 1 < level.size(); ++k)
        up ? triangle(level[0], level[k], level[k + 1]) : triangle(level[0], level[k + 1], level[k]);
    };
    fan(end, true);
    add_cap(middle, circle, 0, false);
    fan(0, false);
  }

  /// The sides of the plate.
  void add_rim() {
    const unsigned nx = options_.cells_x, ny = options_.cells_y;
    const auto side = [&](double x, double y, double u, double v) {
      const Vec3 up{0, 0, options_.thickness}, a{x, y, 0}, b{x + u, y + v, 0};
      triangle(a, b, b + up);
      triangle(a, b + up, a + up);
    };
    for (unsigned i = 0; i < nx; ++i) side(i, 0, 1, 0), side(i + 1.0, ny, -1, 0);
    for (unsigned j = 0; j < ny; ++j) side(nx, j, 0, 1), side(0, j + 1.0, 0, -1);
  }

  Dice dice_;
  const NeedleCadOptions& options_;
  PlcBuilder builder_;
  NeedleCadModel model_;
};

}  // namespace

NeedleCadModel needle_cad(unsigned seed, const NeedleCadOptions& options) { return PlateMaker(seed, options).make(); }

NeedleCadOptions needle_cad_options(unsigned seed) {
  Dice dice(seed + 1000003);
  NeedleCadOptions options;
  options.cells_x = dice.from_to(1, 6);
  options.cells_y = dice.from_to(1, 5);
  options.thickness = dice.log_between(1e-3, 1);
  options.web = dice.log_between(1e-4, 0.4);
  options.sides = 4 * dice.from_to(4, 24);
  options.least_spacing = dice.log_between(1e-6, 1e-2);
  options.post_share = dice.unit();
  return options;
}

}  // namespace geomesh::test

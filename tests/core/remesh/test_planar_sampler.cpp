// SPDX-License-Identifier: MIT
// Points in polygons: far enough from each other, from the border and from inner segments, and everywhere.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "remesh/start/planar_sampler.hpp"

using namespace geomesh;
using remesh::PlanarSampler;

namespace {

using Ring = std::vector<Vec2>;

/// The points taken where one size is asked everywhere, kept from the segments of `inner`.
std::vector<Vec2> sampled(const Ring& ring, double size, const std::vector<std::array<Vec2, 2>>& inner = {}) {
  std::vector<PlanarSampler::Place> loop;
  for (const Vec2& p : ring) loop.push_back({p, size});
  PlanarSampler sampler({loop}, [=](const Vec2&, const PlanarSampler::Place&) { return size; });
  for (const auto& [a, b] : inner) sampler.block({a, size}, {b, size});
  return sampler.run();
}

double distance(const Vec2& p, const Vec2& q) { return std::hypot(p.x - q.x, p.y - q.y); }

double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d{b.x - a.x, b.y - a.y};
  const double t = std::clamp(((p.x - a.x) * d.x + (p.y - a.y) * d.y) / (d.x * d.x + d.y * d.y), 0.0, 1.0);
  return distance(p, {a.x + t * d.x, a.y + t * d.y});
}

double distance_to_border(const Vec2& p, const Ring& ring) {
  double least = 1e300;
  for (std::size_t i = 0; i < ring.size(); ++i)
    least = std::min(least, distance(p, ring[i], ring[(i + 1) % ring.size()]));
  return least;
}

double least_spacing(const std::vector<Vec2>& points) {
  double least = 1e300;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, distance(points[i], points[j]));
  return least;
}

/// Of the sample dying-throw: the side on top is up to one and a half times as long as the size asked, so that it gets
/// no point.
const Ring uncut_side{{0, 0}, {79.76, 27.74}, {137.5, 47.83}, {137.5, 100}, {-1, 100}};

}  // namespace

TEST_CASE("No point of a facet is on its border, nor near it, where an edge is longer than asked", "[refine]") {
  std::size_t n_points = 0;
  for (double size = 60; size < 140; size += 0.37) {
    CAPTURE(size);
    const std::vector<Vec2> points = sampled(uncut_side, size);
    for (const Vec2& p : points) CHECK(distance_to_border(p, uncut_side) >= 0.3999 * size);
    CHECK(least_spacing(points) >= 0.7499 * size);
    n_points += points.size();
  }
  CHECK(n_points > 20);
}

TEST_CASE("No point of a facet is near a segment inside it", "[refine]") {
  const Ring square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const Vec2 a{3, 3.3}, b{4.4, 3.9};
  for (double size = 0.95; size < 1.4; size += 0.05) {
    const std::vector<Vec2> points = sampled(square, size, {{a, b}});
    CAPTURE(size);
    for (const Vec2& p : points) {
      CHECK(distance(p, a, b) >= 0.3999 * size);
      CHECK(std::min(distance(p, a), distance(p, b)) >= 0.7499 * size);
    }
    CHECK(points.size() > 30);
  }
}

TEST_CASE("A polygon is filled with points", "[refine]") {
  Ring square;
  for (int i = 0; i < 10; ++i) square.push_back({1.0 * i, 0});
  for (int i = 0; i < 10; ++i) square.push_back({10, 1.0 * i});
  for (int i = 0; i < 10; ++i) square.push_back({10.0 - i, 10});
  for (int i = 0; i < 10; ++i) square.push_back({0, 10.0 - i});
  const std::vector<Vec2> points = sampled(square, 1.0);
  for (double x = 0.05; x < 10; x += 0.1)
    for (double y = 0.05; y < 10; y += 0.1) {
      double nearest = 1e300;
      for (const Vec2& p : points) nearest = std::min(nearest, distance(p, {x, y}));
      for (const Vec2& p : square) nearest = std::min(nearest, distance(p, {x, y}));
      CHECK(nearest < 1.0);
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace geomesh::bench {
namespace {

using Engine = std::mt19937_64;

double uniform(Engine& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

Vec3 in_cube(Engine& random, double half) {
  const double x = uniform(random, -half, half), y = uniform(random, -half, half);
  return {x, y, uniform(random, -half, half)};
}

/// Ten horizons over 50 km x 50 km, 35 m apart before folding; with 1e6 points about 150 m between points of one.
std::vector<Vec3> horizons(std::size_t n, Engine& random) {
  std::vector<Vec3> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = uniform(random, 0, 50000), y = uniform(random, 0, 50000);
    const double layer = static_cast<double>(i % 10);
    const double fold =
        200 * std::sin(x / 4000) * std::cos(y / 6000) + 15 * std::sin(x / 700 + layer) + 10 * std::cos(y / 900 - layer);
    points[i] = {x, y, -2000 - 35 * layer + fold};
  }
  return points;
}

/// A hundred balls of points about random centres, radii 1e-5 to 1e5 in steps of ten: spacings from 1e-7 to 1e4.
std::vector<Vec3> clusters(std::size_t n, Engine& random) {
  std::vector<Vec3> points;
  constexpr std::size_t n_clusters = 100;
  for (std::size_t k = 0; k < n_clusters; ++k) {
    const Vec3 center = in_cube(random, 5e5);
    const double radius = std::pow(10.0, -5.0 + static_cast<double>(k % 11));
    const std::size_t end = n * (k + 1) / n_clusters;
    while (points.size() < end) points.push_back(center + in_cube(random, radius));
  }
  return points;
}

std::vector<Vec3> lattice(std::size_t n) {
  const auto side = static_cast<int>(std::lround(std::cbrt(static_cast<double>(n))));
  std::vector<Vec3> points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      for (int k = 0; k < side; ++k) points.push_back({double(i), double(j), double(k)});
  return points;
}

Vec3 on_sphere(Engine& random) {
  for (;;) {
    const Vec3 p = in_cube(random, 1);
    const double r2 = dot(p, p);
    if (r2 > 1e-4 && r2 <= 1) return (1 / std::sqrt(r2)) * p;
  }
}

}  // namespace

std::vector<Vec3> make_points(const std::string& name, std::size_t n, unsigned seed) {
  Engine random(seed);
  std::vector<Vec3> points;
  if (name == "uniform") {
    while (points.size() < n) points.push_back(in_cube(random, 0.5));
  } else if (name == "horizons") {
    points = horizons(n, random);
  } else if (name == "clusters") {
    points = clusters(n, random);
  } else if (name == "grid") {
    points = lattice(n);
  } else if (name == "sphere") {
    while (points.size() < n) points.push_back(on_sphere(random));
  } else if (name == "plane") {
    while (points.size() < n) points.push_back({uniform(random, 0, 1), uniform(random, 0, 1), 0.25});
  } else if (name == "line") {
    while (points.size() < n) points.push_back({static_cast<double>(random() % 1000000), 2, 3});
  } else {
    throw std::invalid_argument("no input is called " + name);
  }
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random() % i]);
  return points;
}

}  // namespace geomesh::bench

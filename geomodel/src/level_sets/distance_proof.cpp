// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/distance_proof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "common/parallel.hpp"

namespace geomesh::geomodel {
namespace {

using Corners = std::array<Vec3, 3>;

/// Number of times that a triangle is divided into four before its distance counts as not proven. Fewer divisions cost
/// more cells of the background mesh, and more divisions more time; the result is not affected otherwise.
constexpr int most_divisions = 4;
constexpr std::size_t n_samples_of_surface = 20'000;

Corners corners_of(const Isosurface& surface, std::size_t t) {
  const Triangle& v = surface.triangles[t];
  return {surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]};
}

std::array<Corners, 4> divided(const Corners& t) {
  const Vec3 ab = 0.5 * (t[0] + t[1]), bc = 0.5 * (t[1] + t[2]), ca = 0.5 * (t[2] + t[0]);
  return {Corners{t[0], ab, ca}, Corners{ab, t[1], bc}, Corners{ca, bc, t[2]}, Corners{ab, bc, ca}};
}

/// Proves that a scalar field is above the isovalue (side 1) or below it (side -1) everywhere on a triangle.
struct OneSide {
  const ScalarField& field;
  LinearFunction linear;  ///< linear approximation of the scalar field near an isosurface triangle
  double value, side;

  bool holds(const Corners& moved, int divisions) const {
    Box3 box;
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& p : moved) {
      box.add(p);
      least = std::min(least, side * (linear(p) - value));
    }
    const Range residual = field.residual_range(box, linear);
    if (least + (side > 0 ? residual.low : -residual.high) > 0) return true;
    if (divisions == 0) return false;
    const std::array<Corners, 4> parts = divided(moved);
    return std::all_of(parts.begin(), parts.end(), [&](const Corners& part) { return holds(part, divisions - 1); });
  }
};

/// Shifts an isosurface triangle along the gradient of its cell, up and down, and proves that the field is above the
/// isovalue on one copy and below it on the other.
bool is_proven(const ScalarField& field, const Corners& triangle, const Vec3& gradient, double value, double distance) {
  const double slope = length_of(gradient);
  if (!(slope > 0)) return false;
  return std::ranges::all_of(std::array{1.0, -1.0}, [&](double side) {
    const Vec3 way = (side * distance / slope) * gradient;
    const OneSide proof{field, {triangle[0], value, gradient}, value, side};
    return proof.holds({triangle[0] + way, triangle[1] + way, triangle[2] + way}, most_divisions);
  });
}

/// A sample point of an isosurface triangle, as two places on either side of it at which the field is evaluated.
struct Sample {
  std::size_t triangle;
  Vec3 below, above;
};

std::vector<Sample> take_samples(const Isosurface& surface, double distance, std::uint64_t seed) {
  std::vector<double> sums;
  double sum = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Corners c = corners_of(surface, t);
    sums.push_back(sum += length_of(cross(c[1] - c[0], c[2] - c[0])));
  }
  std::mt19937_64 random(seed);
  const auto next = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < n_samples_of_surface && sum > 0; ++i) {
    const auto at = std::upper_bound(sums.begin(), sums.end(), next() * sum);
    const auto t = std::min(static_cast<std::size_t>(at - sums.begin()), surface.triangles.size() - 1);
    const Corners c = corners_of(surface, t);
    double u = next(), v = next();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3 p = c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]);
    const double slope = length_of(surface.gradient[t]);
    const Vec3 way = slope > 0 ? (distance / slope) * surface.gradient[t] : Vec3{};
    samples.push_back({t, p - way, p + way});
  }
  return samples;
}

}  // namespace

std::vector<std::size_t> not_proven_within(const ScalarField& field, const Isosurface& surface, double value,
                                           double distance) {
  std::vector<char> is_open(surface.triangles.size(), 0);
  parallel_for(surface.triangles.size(), [&](std::size_t t) {
    is_open[t] = !is_proven(field, corners_of(surface, t), surface.gradient[t], value, distance);
  });
  std::vector<std::size_t> rows;
  for (std::size_t t = 0; t < is_open.size(); ++t)
    if (is_open[t]) rows.push_back(t);
  return rows;
}

SampledDistance sample_within(const ScalarField& field, const Isosurface& surface, double value, double distance,
                              std::uint64_t seed) {
  const std::vector<Sample> samples = take_samples(surface, distance, seed);
  std::vector<Vec3> places;
  for (const Sample& s : samples) {
    places.push_back(s.below);
    places.push_back(s.above);
  }
  std::vector<double> values(places.size());
  field.values(places, values);
  SampledDistance result{samples.size(), {}};
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (!(values[2 * i] <= value && value <= values[2 * i + 1])) result.beyond.push_back(samples[i].triangle);
  std::sort(result.beyond.begin(), result.beyond.end());
  result.beyond.erase(std::unique(result.beyond.begin(), result.beyond.end()), result.beyond.end());
  return result;
}

}  // namespace geomesh::geomodel

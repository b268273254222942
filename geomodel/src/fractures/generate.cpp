// SPDX-License-Identifier: GPL-3.0-or-later
#include "fractures/generate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t most_fractures = 200'000;

/// Uniform numbers from 0 to below 1, the same in every library.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : random_(seed) {}
  double operator()() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 random_;
};

double radius(const FractureFamily& family, Uniform& next) {
  const double u = next();
  if (family.least_radius == family.greatest_radius) return family.least_radius;
  if (family.exponent == 0) return family.least_radius * std::pow(family.greatest_radius / family.least_radius, u);
  const double a = std::pow(family.least_radius, -family.exponent);
  const double b = std::pow(family.greatest_radius, -family.exponent);
  return std::pow(a - u * (a - b), -1 / family.exponent);
}

/// Cosine of the angle to the mean pole, by inversion of its distribution.
double cosine_of_scatter(double kappa, double u) {
  if (kappa == 0) return 1 - 2 * u;
  return std::clamp(1 + std::log(u + (1 - u) * std::exp(-2 * kappa)) / kappa, -1.0, 1.0);
}

Ellipse disc(const FractureFamily& family, const Box3& box, Uniform& next) {
  Ellipse disc;
  disc.major = disc.minor = radius(family, next);
  for (std::size_t a = 0; a < 3; ++a) {
    const double low = box.min[a] - family.greatest_radius, high = box.max[a] + family.greatest_radius;
    disc.center[a] = low + next() * (high - low);
  }
  const auto [strike, dip] = axes_of_plane(family.dip_direction, family.dip);
  const Vec3 mean = cross(dip, strike);
  const double cosine = cosine_of_scatter(family.kappa, next());
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)), turn = 2 * std::numbers::pi * next();
  const Vec3 about = std::cos(turn) * strike + std::sin(turn) * dip;  // at right angles to the mean pole
  const Vec3 pole = cosine * mean + sine * about;
  disc.x_axis = cross(mean, about);
  disc.y_axis = cross(pole, disc.x_axis);
  return disc;
}

}  // namespace

std::vector<Fracture> generate_fractures(const std::vector<FractureFamily>& families, const Box3& box, int n_corners,
                                         std::uint64_t seed) {
  std::vector<Fracture> fractures;
  const Vec3 size = box.max - box.min;
  Uniform next(seed);
  for (const FractureFamily& family : families) {
    const double wanted = family.p32 * size.x * size.y * size.z;
    double area = 0;
    std::size_t n_tried = 0, n_found = 0;
    while (family.p32 > 0 ? area < wanted : n_found < family.count) {
      Fracture fracture{family.name + "_" + std::to_string(n_found + 1),
                        polygon_of(disc(family, box, next), n_corners, PolygonSize::same_area)};
      if (++n_tried > 100 * most_fractures || fractures.size() >= most_fractures)
        throw Error(ErrorKind::usage, "fractures: the family " + family.name + " would need more than " +
                                          std::to_string(most_fractures) +
                                          " discs; a smaller p32 or larger radii were expected");
      const double in_box = area_of(clipped(fracture.corners, box));
      if (!(in_box > 0)) continue;
      area += in_box;
      ++n_found;
      fractures.push_back(std::move(fracture));
    }
  }
  return fractures;
}

}  // namespace geomesh::geomodel

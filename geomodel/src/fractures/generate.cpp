// SPDX-License-Identifier: GPL-3.0-or-later
#include "fractures/generate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/sizes_in_range.hpp"
#include "geomesh/geomodel/words.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t most_fractures = 200'000;
/// Limit on the number of discs that are generated. Centres lie in the box and around it up to the largest radius, so
/// most discs may miss the box.
constexpr std::size_t most_tries = 100 * most_fractures;

/// Uniform random numbers in [0, 1), which are the same with every standard library.
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
  const double ratio = family.greatest_radius / family.least_radius;
  if (family.exponent == 0) return family.least_radius * std::pow(ratio, u);
  return family.least_radius * std::pow(1 - u * (1 - std::pow(ratio, -family.exponent)), -1 / family.exponent);
}

/// Returns the cosine of a random angle between a pole and the mean pole, by inversion of its distribution.
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
  // random direction perpendicular to the mean pole of the fractures
  const Vec3 about = std::cos(turn) * strike + std::sin(turn) * dip;
  const Vec3 pole = cosine * mean + sine * about;
  disc.x_axis = cross(mean, about);
  disc.y_axis = cross(pole, disc.x_axis);
  return disc;
}

/// Returns the mean area of a family's discs, from the second moment of the power law of radii.
double mean_area(const FractureFamily& family) {
  const double r = family.least_radius, x = family.greatest_radius / r, e = family.exponent;
  double moment = 1;
  if (x > 1)
    moment = e == 0   ? (x * x - 1) / (2 * std::log(x))
             : e == 2 ? 2 * std::log(x) / (1 - 1 / (x * x))
                      : e / (2 - e) * (std::pow(x, 2 - e) - 1) / (1 - std::pow(x, -e));
  return std::numbers::pi * r * r * moment;
}

/// Returns the volume of the places that are at most half of the box's diagonal from a disc, by Steiner's formula. If
/// the box meets the disc, the centre of the box is one of these places.
double volume_about_disc(double radius, double half_diagonal) {
  const double r = radius, d = half_diagonal;
  return std::numbers::pi * d * (2 * r * r + std::numbers::pi * r * d + 4.0 / 3 * d * d);
}

[[noreturn]] void refuse(const FractureFamily& family, const std::string& text) {
  throw Error(ErrorKind::usage, "fractures: " + text + " (family " + family.name + ")");
}

/// Rejects a family of discs at once if generating it would fail after millions of discs. Every disc whose centre lies
/// in the box meets the box, so at least p32 V / A discs are expected for a box of volume V, a mean disc area A and an
/// area p32 of discs per volume. If centres are generated in a volume W, each disc adds V / W of its area on average.
void require_drawable(const FractureFamily& family, const Box3& box) {
  const Vec3 size = box.max - box.min;
  const double volume = size.x * size.y * size.z, r = family.greatest_radius;
  const double drawn_from = (size.x + 2 * r) * (size.y + 2 * r) * (size.z + 2 * r);
  double farthest = 0;
  for (std::size_t a = 0; a < 3; ++a) farthest = std::max({farthest, std::abs(box.min[a]), std::abs(box.max[a])});
  if (family.least_radius < least_told_apart * farthest)
    refuse(family, "a radius of " + short_words(family.least_radius) +
                       " cannot be distinguished from a point at coordinates of " + short_words(farthest) +
                       "; is it in the model's units?");
  const double area = mean_area(family);
  if (family.p32 > 0 && !(area > 0 && std::isfinite(area)))
    refuse(family, "radii from " + short_words(family.least_radius) + " to " + short_words(r) +
                       " with an exponent of " + short_words(family.exponent) +
                       " have no mean area that can be computed; an exponent from 1 to 4 is usual");
  const double discs = family.p32 * volume / area;
  if (discs > static_cast<double>(most_fractures))
    refuse(family, "a p32 of " + short_words(family.p32) + " needs about " + count_words(discs) + " discs, more than " +
                       count_words(most_fractures) + "; a smaller p32 or larger radii were expected");
  const double half_diagonal = std::hypot(size.x, size.y, size.z) / 2;
  const double tries = family.p32 > 0
                           ? family.p32 * drawn_from / area
                           : static_cast<double>(family.count) * drawn_from / volume_about_disc(r, half_diagonal);
  if (!(tries <= static_cast<double>(most_tries)))
    refuse(family, "radii of up to " + short_words(r) + " are so much larger than the model, which is " +
                       short_words(2 * half_diagonal) +
                       " across, that hardly a disc meets it; is radius.max in the model's units?");
}

}  // namespace

std::vector<Fracture> generate_fractures(const std::vector<FractureFamily>& families, const Box3& box, int n_corners,
                                         std::uint64_t seed) {
  std::vector<Fracture> fractures;
  const Vec3 size = box.max - box.min;
  Uniform next(seed);
  for (const FractureFamily& family : families) {
    require_drawable(family, box);
    const double wanted = family.p32 * size.x * size.y * size.z;
    double area = 0;
    std::size_t n_tried = 0, n_found = 0;
    while (family.p32 > 0 ? area < wanted : n_found < family.count) {
      Fracture fracture{family.name + "_" + std::to_string(n_found + 1),
                        polygon_of(disc(family, box, next), n_corners, PolygonSize::same_area)};
      if (++n_tried > most_tries || fractures.size() >= most_fractures)
        refuse(family, "more than " + count_words(most_fractures) +
                           " discs would be needed; a smaller p32 or larger radii were expected");
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

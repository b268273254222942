// SPDX-License-Identifier: GPL-3.0-or-later
#include "noisy_faults.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dice.hpp"
#include "soup_models.hpp"

namespace geomesh::geomodel::testing {

namespace {

const Box3 model_box{{0, 0, -2000}, {4000, 3000, 0}};

/// A plane through the box: a point of it, its strike, its dip's direction and its normal.
struct Plane {
  Vec3 middle, strike, dip, normal;
};

Plane plane_of(Dice& dice) {
  const double strike = dice.between(0, std::numbers::pi), dip = dice.between(0.7, 1.5);
  const Vec3 along{std::cos(strike), std::sin(strike), 0};
  const Vec3 down{-std::sin(strike) * std::cos(dip), std::cos(strike) * std::cos(dip), -std::sin(dip)};
  return {{dice.between(1300, 2700), dice.between(1000, 2000), -1000}, along, down, cross(along, down)};
}

/// About the plane, turned in it by `angle` radians about its strike and its dip.
TriangulatedSurface fault(Dice& dice, const std::string& name, const Plane& plane, unsigned cells, double angle,
                          const NoisyFaultsOptions& options) {
  TriangulatedSurface s;
  s.name = name;
  s.kind = SurfaceKind::fault;
  constexpr double half = 3600;  // beyond the box on all sides
  const double turn = dice.between(0, 2 * std::numbers::pi), phase = dice.between(0, 6.28);
  const double waves = dice.between(0.5, 3) * 2 * std::numbers::pi / half;
  for (unsigned j = 0; j <= cells; ++j)
    for (unsigned i = 0; i <= cells; ++i) {
      const double u = half * (2.0 * i / cells - 1), v = half * (2.0 * j / cells - 1);
      const double off = std::tan(angle) * (u * std::cos(turn) + v * std::sin(turn)) +
                         options.waviness * std::sin(waves * u + phase) * std::cos(waves * v) +
                         options.noise * (2 * dice.unit() - 1);
      s.points.push_back(plane.middle + u * plane.strike + v * plane.dip + off * plane.normal);
    }
  for (unsigned j = 0; j < cells; ++j)
    for (unsigned i = 0; i < cells; ++i) {
      const VertexIndex q = j * (cells + 1) + i;
      s.triangles.push_back({q, q + 1, q + cells + 2});
      s.triangles.push_back({q, q + cells + 2, q + cells + 1});
    }
  return s;
}

double least_height(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
  return std::sqrt(dot(n, n) / longest);
}

}  // namespace

std::vector<TriangulatedSurface> noisy_faults(unsigned seed, const NoisyFaultsOptions& options) {
  Dice dice(seed);
  std::vector<TriangulatedSurface> faults;
  for (unsigned b = 0; b < options.n_bundles; ++b) {
    const Plane plane = plane_of(dice);
    for (unsigned k = 0; k < options.n_in_bundle; ++k) {
      const double angle = dice.log_between(options.least_angle, 2) * std::numbers::pi / 180;
      faults.push_back(fault(dice, "fault_" + std::to_string(b) + "_" + std::to_string(k), plane,
                             options.cells + dice.from_to(0, 5), k == 0 ? 0 : angle, options));
    }
  }
  return faults;
}

NoisyFaultsModel noisy_faults_model(unsigned seed, const NoisyFaultsOptions& options) {
  const std::vector<TriangulatedSurface> faults = noisy_faults(seed, options);
  ArrangementOptions arranged;
  arranged.box = model_box;
  const PolygonSoup soup = arrange(faults, {}, {}, arranged).soup;
  NoisyFaultsModel model;
  model.plc = complex_of(soup);
  model.narrowest = model_box.max.x - model_box.min.x;
  for (const TriangulatedSurface& s : faults) model.n_given += s.triangles.size();
  for (const Triangle& t : soup.facets)
    model.narrowest = std::min(model.narrowest, least_height(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]));
  return model;
}

NoisyFaultsOptions noisy_faults_options(unsigned seed) {
  Dice dice(seed + 1000003);
  NoisyFaultsOptions options;
  options.n_bundles = dice.from_to(1, 3);
  options.n_in_bundle = options.n_bundles == 1 ? dice.from_to(3, 4) : 2;
  options.cells = dice.from_to(8, 20);
  options.noise = dice.log_between(0.01, 10);
  options.waviness = dice.log_between(0.01, 20);
  options.least_angle = dice.log_between(1e-4, 0.1);
  return options;
}

}  // namespace geomesh::geomodel::testing

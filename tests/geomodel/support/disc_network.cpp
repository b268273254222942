// SPDX-License-Identifier: GPL-3.0-or-later
#include "disc_network.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "geomesh/geomodel/arrangement.hpp"

namespace geomesh::geomodel::testing {

namespace {

constexpr unsigned n_corners = 12;

class DiscMaker {
 public:
  DiscMaker(unsigned seed, double radius) : random_(seed), radius_(radius) {}

  TriangulatedSurface make(unsigned i) {
    const Vec3 centre{unit(), unit(), unit()};
    const double height = 2 * unit() - 1, turn = 2 * std::numbers::pi * unit(), across = std::sqrt(1 - height * height);
    const Vec3 normal{across * std::cos(turn), across * std::sin(turn), height};
    const Vec3 any = std::fabs(height) < 0.7 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    Vec3 first = cross(normal, any);
    first = (1 / std::sqrt(dot(first, first))) * first;
    const Vec3 second = cross(normal, first);
    TriangulatedSurface out;
    out.name = "disc_" + std::to_string(i);
    for (unsigned k = 0; k < n_corners; ++k) {
      const double angle = 2 * std::numbers::pi * k / n_corners;
      out.points.push_back(centre + radius_ * (std::cos(angle) * first + std::sin(angle) * second));
    }
    for (VertexIndex k = 1; k + 1 < n_corners; ++k) out.triangles.push_back({0, k, k + 1});
    return out;
  }

 private:
  double unit() { return (static_cast<double>(random_()) + 0.5) / 4294967296.0; }

  std::mt19937 random_;
  double radius_;
};

test::FamilyModel network_of_family(unsigned i) {
  return disc_network(i,
                      static_cast<unsigned>(std::lround(10 * std::pow(200, i / (test::ModelFamily::n_models - 1.0)))));
}

}  // namespace

test::FamilyModel disc_network(unsigned seed, unsigned n) { return disc_network(seed, n, 1.1 / std::cbrt(n)); }

test::FamilyModel disc_network(unsigned seed, unsigned n, double radius) {
  DiscMaker maker(seed, radius);
  std::vector<TriangulatedSurface> surfaces;
  for (unsigned i = 0; i < n; ++i) surfaces.push_back(maker.make(i));
  ArrangementOptions options;
  options.box = Box3{{0, 0, 0}, {1, 1, 1}};
  const PolygonSoup soup = arrange(surfaces, {}, {}, options).soup;
  test::FamilyModel out;
  out.name = "discs_" + std::to_string(n) + "_" + std::to_string(seed);
  out.plc.points = soup.points;
  for (const Triangle& t : soup.facets) out.plc.add_triangle(t);
  out.volume = 1;
  return out;
}

test::ModelFamily disc_family() { return {"discs", network_of_family}; }

}  // namespace geomesh::geomodel::testing

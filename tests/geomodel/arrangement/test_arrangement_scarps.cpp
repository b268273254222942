// SPDX-License-Identifier: GPL-3.0-or-later
// Faults between two blocks of a topography, where a body reaches over them.
#include <catch2/catch.hpp>

#include "arrangement_inputs.hpp"
#include "require_sound.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

constexpr double fault_at = 5, size = 10;
const Box3 box{{0, 0, 0}, {size, size, size}};

/// Flat on either side of the fault.
TriangulatedSurface two_blocks(double left, double right, unsigned n) {
  auto blocks =
      grid_surface("ground", SurfaceKind::horizon, n, 0, fault_at, 0, size, [&](double, double) { return left; });
  const auto other =
      grid_surface("", SurfaceKind::horizon, n, fault_at, size, 0, size, [&](double, double) { return right; });
  const auto first = static_cast<VertexIndex>(blocks.points.size());
  blocks.points.insert(blocks.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& t : other.triangles) blocks.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  return blocks;
}

/// Upright at x = 5. `turned`: every second triangle is turned over.
TriangulatedSurface upright_fault(unsigned n, bool turned) {
  auto fault =
      grid_surface("f", SurfaceKind::fault, n, -1, size + 1, -1, size + 1, [](double, double) { return fault_at; });
  for (Vec3& p : fault.points) p = {p.z, p.x, p.y};
  for (std::size_t k = 0; turned && k < fault.triangles.size(); k += 2)
    std::swap(fault.triangles[k][1], fault.triangles[k][2]);
  return fault;
}

struct FaultArea {
  double between = 0, in_body = 0;  ///< at heights between the blocks; inside of the body elsewhere
};

FaultArea fault_area(const std::vector<TriangulatedSurface>& surfaces, double low, double high, const Vec3& centre,
                     const Vec3& radii) {
  ArrangementOptions options;
  options.box = box;
  const PolygonSoup soup = arrange(surfaces, {}, {}, options).soup;
  require_sound(soup);
  FaultArea found;
  for (Index f = 0; f < soup.facets.size(); ++f) {
    if (soup.origins[soup.origin_offsets[f]].surface != 1) continue;
    const Triangle& t = soup.facets[f];
    const Vec3 &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    const Vec3 p = (1.0 / 3) * (a + b + c), q = p - centre;
    const double area = 0.5 * std::sqrt(dot(cross(b - a, c - a), cross(b - a, c - a)));
    const Vec3 scaled{q.x / radii.x, q.y / radii.y, q.z / radii.z};
    if (p.z > low && p.z < high)
      found.between += area;
    else if (dot(scaled, scaled) < 0.5)
      found.in_body += area;
  }
  return found;
}

}  // namespace

TEST_CASE("scarps: no body takes the fault between two blocks of what ends the model", "[arrangement]") {
  // Found by random options 6366: a salt reached over a scarp, and the ground in it was open to the air.
  const auto [left, right] = GENERATE(std::pair{7.0, 3.0}, std::pair{3.0, 7.0});
  const auto [z, height] = GENERATE(std::pair{5.0, 4.5}, std::pair{7.0, 1.5}, std::pair{3.0, 1.5}, std::pair{5.0, 1.0});
  const bool turned = GENERATE(false, true);
  INFO(left << " " << right << ", body at " << z << " +- " << height << ", turned " << turned);
  const Vec3 centre{fault_at + 0.3, 5, z}, radii{2, 2, height};
  TriangulatedSurface body = ellipsoid("salt", centre, radii, 3);
  body.cuts_all = true;
  TriangulatedSurface ground = two_blocks(left, right, 4);
  ground.ends_model = true;
  const FaultArea area = fault_area({ground, upright_fault(3, turned), body}, 3, 7, centre, radii);
  CHECK(area.between == Approx(4 * size));
  CHECK(area.in_body == 0);
}

TEST_CASE("scarps: a body takes all of a fault at a horizon that ends no model, or has no throw", "[arrangement]") {
  const bool ends_model = GENERATE(false, true);
  const Vec3 centre{fault_at, 5, 5}, radii{2, 2, 4.5};
  TriangulatedSurface body = ellipsoid("salt", centre, radii, 3);
  body.cuts_all = true;
  TriangulatedSurface ground = two_blocks(ends_model ? 5 : 7, ends_model ? 5 : 3, 4);
  ground.ends_model = ends_model;
  const FaultArea area = fault_area({ground, upright_fault(3, false), body}, 3, 7, centre, radii);
  CHECK(area.between < 4 * size - 10);
  CHECK(area.in_body == 0);
}

TEST_CASE("scarps: of a fault past the end of one block alone a body takes all", "[arrangement]") {
  const Vec3 centre{fault_at, 5, 5}, radii{2, 2, 4.5};
  TriangulatedSurface body = ellipsoid("salt", centre, radii, 3);
  body.cuts_all = true;
  TriangulatedSurface ground =
      grid_surface("ground", SurfaceKind::horizon, 4, 0, fault_at, 0, size, [](double, double) { return 6; });
  ground.ends_model = true;
  const FaultArea area = fault_area({ground, upright_fault(3, false), body}, 3, 7, centre, radii);
  CHECK(area.between < 4 * size - 10);
  CHECK(area.in_body == 0);
}

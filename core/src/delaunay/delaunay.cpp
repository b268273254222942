// SPDX-License-Identifier: MIT
#include "geomesh/core/delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "delaunay/cavity.hpp"
#include "delaunay/spatial_order.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh {
namespace {

void check_coordinates(std::span<const Vec3> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && exponents_are_safe(points.subspan(i, 1))) continue;
    throw Error(ErrorKind::invalid_input,
                "point " + std::to_string(i) + " has a coordinate that is not finite, or so large or so near zero that exact arithmetic "
                "would over- or underflow (allowed: 0 and magnitudes from 2^-148 to 2^148)",
                {{}, {}, {static_cast<VertexIndex>(i)}, {p}});
  }
}

/// The first of equal points stands for all.
std::vector<VertexIndex> find_representatives(std::span<const Vec3> points) {
  std::vector<VertexIndex> order(points.size());
  for (VertexIndex v = 0; v < order.size(); ++v) order[v] = v;
  std::sort(order.begin(), order.end(), [&](VertexIndex a, VertexIndex b) {
    const int c = compare_lexicographic(points[a], points[b]);
    return c != 0 ? c < 0 : a < b;
  });
  std::vector<VertexIndex> representative(points.size());
  VertexIndex first = no_vertex;
  for (const VertexIndex v : order) {
    if (first == no_vertex || !(points[v] == points[first])) first = v;
    representative[v] = first;
  }
  return representative;
}

/// Moves four affinely independent points to the front; positively oriented.
Tetrahedron first_tetrahedron(std::span<const Vec3> points, std::vector<VertexIndex>& order) {
  const auto no_volume = [](const char* what) {
    return Error(ErrorKind::cannot_mesh, std::string("all points lie ") + what + ": there is no volume to triangulate");
  };
  if (order.size() < 2) throw no_volume("at one place");
  const Vec3 &a = points[order[0]], &b = points[order[1]];
  auto third = std::find_if(order.begin() + 2, order.end(), [&](VertexIndex v) { return !collinear(a, b, points[v]); });
  if (third == order.end()) throw no_volume("on one line");
  std::rotate(order.begin() + 2, third, third + 1);
  const Vec3& c = points[order[2]];
  auto fourth = std::find_if(order.begin() + 3, order.end(), [&](VertexIndex v) { return orient3d(a, b, c, points[v]) != Sign::zero; });
  if (fourth == order.end()) throw no_volume("in one plane");
  std::rotate(order.begin() + 3, fourth, fourth + 1);
  Tetrahedron first{order[0], order[1], order[2], order[3]};
  if (orient3d(a, b, c, points[order[3]]) == Sign::negative) std::swap(first[0], first[1]);
  return first;
}

}  // namespace

DelaunayTetrahedralization delaunay_tetrahedralization(std::span<const Vec3> points, const DelaunayOptions&, const RunContext& context) {
  check_coordinates(points);
  DelaunayTetrahedralization result;
  result.representative = find_representatives(points);
  std::vector<VertexIndex> order;
  for (VertexIndex v = 0; v < points.size(); ++v)
    if (result.representative[v] == v) order.push_back(v);
  order = spatial_order(points, std::move(order));

  const Tetrahedron first = first_tetrahedron(points, order);
  result.mesh.reserve(7 * order.size() + 64);
  CavityInserter inserter(result.mesh, points);
  inserter.start(first);
  for (std::size_t i = 4; i < order.size(); ++i) {
    inserter.insert(order[i]);
    if (i % 65536 == 0) {
      context.check_cancelled();
      context.report(i, order.size());
    }
  }
  result.statistics.walk_steps = inserter.walk_steps();
  return result;
}

}  // namespace geomesh

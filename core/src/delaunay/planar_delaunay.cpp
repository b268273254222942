// SPDX-License-Identifier: MIT
#include "geomesh/core/planar_delaunay.hpp"

#include <algorithm>
#include <string>

#include "delaunay/cavity_insertion.hpp"
#include "delaunay/plane_space.hpp"
#include "delaunay/twins.hpp"
#include "geomesh/core/predicates.hpp"
#include "mesh/spatial_order.hpp"

namespace geomesh {
namespace {

/// Moves three points that are not collinear to the front, positively oriented; returns the axis to drop.
int bring_first_triangle(std::span<const Vec3> points, std::vector<VertexIndex>& order) {
  const auto no_area = [] {
    return Error(ErrorKind::cannot_mesh, "all points lie on one line: there is no area to triangulate");
  };
  const auto second =
      std::find_if(order.begin(), order.end(), [&](VertexIndex v) { return !(points[v] == points[order[0]]); });
  if (second == order.end()) throw no_area();
  std::rotate(order.begin() + 1, second, second + 1);
  const Vec3 &a = points[order[0]], &b = points[order[1]];
  const auto third =
      std::find_if(order.begin() + 2, order.end(), [&](VertexIndex v) { return !collinear(a, b, points[v]); });
  if (third == order.end()) throw no_area();
  std::rotate(order.begin() + 2, third, third + 1);
  const Vec3& c = points[order[2]];
  for (int axis = 0;; ++axis) {
    const Sign turn =
        orient2d(PlaneSpace::project(a, axis), PlaneSpace::project(b, axis), PlaneSpace::project(c, axis));
    if (turn == Sign::zero) continue;
    if (turn == Sign::negative) std::swap(order[0], order[1]);
    return axis;
  }
}

}  // namespace

DelaunayTriangulation delaunay_triangulation_in_plane(std::span<const Vec3> points) {
  if (!exponents_are_safe(points))
    throw Error(ErrorKind::invalid_input,
                "a coordinate is not finite, or out of the range of exact arithmetic (2^-148 to 2^148)");
  std::vector<VertexIndex> order = spatial_order(points).order;
  const int axis = bring_first_triangle(points, order);
  for (VertexIndex v = 0; v < points.size(); ++v)
    if (orient3d(points[order[0]], points[order[1]], points[order[2]], points[v]) != Sign::zero)
      throw Error(ErrorKind::invalid_input, "point " + std::to_string(v) + " is not in the plane of the others",
                  {{}, {}, {v}, {points[v]}});

  const auto n = static_cast<VertexIndex>(points.size());
  std::vector<PointRecord> records(points.size() + 1);
  for (VertexIndex i = 0; i < n; ++i) records[i] = PointRecord{points[order[i]], order[i]};
  records[n] = PointRecord{points[0], infinite_vertex};
  DelaunayTriangulation result;
  CavityInsertion<PlaneSpace> insertion(result.mesh, PlaneSpace(records.data(), n, axis), SlotSource(0, 0, 0, 1));
  insertion.start({0, 1, 2});
  std::vector<Twin> twins;
  for (VertexIndex v = 3; v < n; ++v)
    if (insertion.insert(v) == InsertionOutcome::duplicate) twins.push_back({v, insertion.twin()});
  insertion.slots().finish(result.mesh);
  result.representative = merge_twins(twins, records.data(), n);
  for (CellIndex c = 0; c < result.mesh.n_slots(); ++c) {
    for (unsigned i = 0; i < 3; ++i) result.mesh.set_vertex(c, i, records[result.mesh.vertex(c, i)].id);
    result.mesh.flags(c) = 0;
  }
  return result;
}

DelaunayTriangulation delaunay_triangulation(std::span<const Vec2> points) {
  std::vector<Vec3> flat;
  flat.reserve(points.size());
  for (const Vec2& p : points) flat.push_back({p.x, p.y, 0});
  return delaunay_triangulation_in_plane(flat);
}

}  // namespace geomesh

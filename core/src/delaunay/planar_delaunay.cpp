// SPDX-License-Identifier: MIT
#include "geomesh/core/planar_delaunay.hpp"

#include <algorithm>

#include "delaunay/cavity_insertion.hpp"
#include "delaunay/plane_space.hpp"
#include "delaunay/twins.hpp"
#include "geomesh/core/predicates.hpp"
#include "mesh/spatial_order.hpp"

namespace geomesh {
namespace {

/// Moves three points that are not collinear to the front, positively oriented.
void bring_first_triangle(std::span<const Vec2> points, std::vector<VertexIndex>& order) {
  const auto no_area = [] {
    return Error(ErrorKind::cannot_mesh, "all points lie on one line: there is no area to triangulate");
  };
  const auto second =
      std::find_if(order.begin(), order.end(), [&](VertexIndex v) { return !(points[v] == points[order[0]]); });
  if (second == order.end()) throw no_area();
  std::rotate(order.begin() + 1, second, second + 1);
  const auto turn = [&](VertexIndex v) { return orient2d(points[order[0]], points[order[1]], points[v]); };
  const auto third = std::find_if(order.begin() + 2, order.end(), [&](VertexIndex v) { return turn(v) != Sign::zero; });
  if (third == order.end()) throw no_area();
  std::rotate(order.begin() + 2, third, third + 1);
  if (turn(order[2]) == Sign::negative) std::swap(order[0], order[1]);
}

}  // namespace

DelaunayTriangulation delaunay_triangulation(std::span<const Vec2> points) {
  std::vector<Vec3> flat;
  flat.reserve(points.size());
  for (const Vec2& p : points) flat.push_back({p.x, p.y, 0});
  if (!exponents_are_safe(flat))
    throw Error(ErrorKind::invalid_input,
                "a coordinate is not finite, or out of the range of exact arithmetic (2^-148 to 2^148)");
  std::vector<VertexIndex> order = spatial_order(flat).order;
  bring_first_triangle(points, order);
  const auto n = static_cast<VertexIndex>(points.size());
  std::vector<PointRecord> records(points.size() + 1);
  for (VertexIndex i = 0; i < n; ++i) records[i] = PointRecord{flat[order[i]], order[i]};
  records[n] = PointRecord{flat[0], infinite_vertex};
  DelaunayTriangulation result;
  CavityInsertion<PlaneSpace> insertion(result.mesh, PlaneSpace(records.data(), n, {}), SlotSource(0, 0, 0, 1));
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

}  // namespace geomesh

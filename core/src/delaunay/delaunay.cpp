// SPDX-License-Identifier: MIT
#include "geomesh/core/delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "delaunay/cavity_insertion.hpp"
#include "delaunay/space3.hpp"
#include "delaunay/spatial_order.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh {
namespace {

void check_coordinates(std::span<const Vec3> points) {
  if (exponents_are_safe(points)) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (exponents_are_safe(points.subspan(i, 1))) continue;
    throw Error(ErrorKind::invalid_input,
                "point " + std::to_string(i) + " has a coordinate that is not finite, or so large or so near zero that exact arithmetic "
                "would over- or underflow (allowed: 0 and magnitudes from 2^-148 to 2^148, about 3e-45 to 3e44)",
                {{}, {}, {static_cast<VertexIndex>(i)}, {points[i]}});
  }
}

/// Moves four affinely independent points to the front, the others keeping their order; positively oriented.
Tetrahedron first_tetrahedron(std::span<const Vec3> points, std::vector<VertexIndex>& order) {
  const auto no_volume = [](const char* what) {
    return Error(ErrorKind::cannot_mesh, std::string("all points lie ") + what + ": there is no volume to triangulate");
  };
  const auto bring = [&](std::ptrdiff_t place, auto&& fits) {
    const auto found = std::find_if(order.begin() + std::min<std::ptrdiff_t>(place, std::ssize(order)), order.end(), fits);
    if (found == order.end()) return false;
    std::rotate(order.begin() + place, found, found + 1);
    return true;
  };
  if (order.empty()) throw Error(ErrorKind::cannot_mesh, "there are no points to triangulate");
  const Vec3& a = points[order[0]];
  if (!bring(1, [&](VertexIndex v) { return !(points[v] == a); })) throw no_volume("at one place");
  const Vec3& b = points[order[1]];
  if (!bring(2, [&](VertexIndex v) { return !collinear(a, b, points[v]); })) throw no_volume("on one line");
  const Vec3& c = points[order[2]];
  if (!bring(3, [&](VertexIndex v) { return orient3d(a, b, c, points[v]) != Sign::zero; })) throw no_volume("in one plane");
  if (orient3d(a, b, c, points[order[3]]) == Sign::negative) return {1, 0, 2, 3};
  return {0, 1, 2, 3};
}

/// A position whose point equals an inserted vertex.
struct Twin {
  VertexIndex position, vertex;
};

/// Gives each vertex the least id of the points equal to it, and each point that id.
std::vector<VertexIndex> merge_twins(const std::vector<Twin>& twins, PointRecord* records, VertexIndex n) {
  std::vector<VertexIndex> representative(n);
  for (VertexIndex i = 0; i < n; ++i) representative[i] = i;
  for (const Twin& t : twins) {
    VertexIndex &kept = records[t.vertex].id, &other = records[t.position].id;
    if (other < kept) std::swap(kept, other);
    representative[other] = kept;
  }
  for (VertexIndex i = 0; i < n; ++i) representative[i] = representative[representative[i]];
  return representative;
}

}  // namespace

DelaunayTetrahedralization delaunay_tetrahedralization(std::span<const Vec3> points, const DelaunayOptions& options, const RunContext& context) {
  check_coordinates(points);
  DelaunayTetrahedralization result;
  SpatialOrder spatial = spatial_order(points);
  const Tetrahedron first = first_tetrahedron(points, spatial.order);

  const auto n = static_cast<VertexIndex>(points.size());
  PodArray<PointRecord> records;
  records.grow_to(std::size_t{n} + 1);
  for (VertexIndex i = 0; i < n; ++i) records[i] = PointRecord{points[spatial.order[i]], spatial.order[i]};
  records[n] = PointRecord{Vec3{}, infinite_vertex};

  result.mesh.reserve(8 * points.size() + 64);
  CavityInsertion<Space3> insertion(result.mesh, Space3(records.data(), n, coordinate_unit(points)), SlotSource(0, 0, 0, 1));
  insertion.start(first);
  std::vector<Twin> twins;
  for (VertexIndex v = 4; v < n; ++v) {
    if (insertion.insert(v) == InsertionOutcome::duplicate) twins.push_back({v, insertion.twin()});
    if (v % 65536 == 0) {
      context.check_cancelled();
      context.report(v, n);
    }
  }
  (void)options;
  result.representative = merge_twins(twins, records.data(), n);
  auto* cells = result.mesh.cells();
  for (const CellIndex c : insertion.slots().unused(result.mesh.n_slots())) cells[c].vertices[0] = no_vertex;
  result.mesh.compact();
  for (CellIndex c = 0; c < result.mesh.n_slots(); ++c)
    for (VertexIndex& v : cells[c].vertices) v = records[v].id;
  result.statistics.walk_steps = insertion.walk_steps();
  result.statistics.exact_calls = insertion.space().exact_calls();
  return result;
}

}  // namespace geomesh

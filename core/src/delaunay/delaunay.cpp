// SPDX-License-Identifier: MIT
#include "geomesh/core/delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "delaunay/cavity_stage.hpp"
#include "delaunay/parallel.hpp"
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
  const unsigned threads = thread_count(context.threads);
  const auto n = static_cast<VertexIndex>(points.size());
  DelaunayTetrahedralization result;
  TetMesh& mesh = result.mesh;
  mesh.reserve(8 * points.size() + 64 * SlotSource::block);
  // The cells' memory serves the sort first: 16 bytes a point of the 256 that follow.
  SpatialOrder spatial = spatial_order(points, {reinterpret_cast<std::uint64_t*>(mesh.cells()), 2 * points.size()}, threads);
  const Tetrahedron first = first_tetrahedron(points, spatial.order);

  PodArray<PointRecord> records;
  records.grow_to(std::size_t{n} + 1);
  for_each_index(n, threads, [&](std::size_t i) {
    records[i] = PointRecord{points[spatial.order[i]], spatial.order[i], PointRecord::no_local, spatial.place[i]};
  });
  records[n] = PointRecord{points[0], infinite_vertex, PointRecord::no_local, 0};
  const std::vector<std::size_t> round_begin = std::move(spatial.round_begin);
  spatial = {};

  CavityStage stage(mesh, records.data(), n, coordinate_unit(points), options.cluster_distance, context);
  stage.start(first);
  for (std::size_t r = 0; r + 1 < round_begin.size(); ++r)
    if (round_begin[r + 1] > 4) stage.insert_round(static_cast<VertexIndex>(std::max<std::size_t>(round_begin[r], 4)), static_cast<VertexIndex>(round_begin[r + 1]));
  stage.insert_waiting();
  stage.finish(result.statistics);

  result.representative = merge_twins(stage.twins(), records.data(), n);
  TetMesh::Cell* cells = mesh.cells();
  for_each_index(mesh.n_slots(), threads, [&](std::size_t c) {
    for (VertexIndex& v : cells[c].vertices) v = records[v].id;
  });
  return result;
}

}  // namespace geomesh

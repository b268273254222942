// SPDX-License-Identifier: MIT
#include "geomesh/core/delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "common/parallel.hpp"
#include "delaunay/cavity_stage.hpp"
#include "delaunay/flip_insertion.hpp"
#include "delaunay/twins.hpp"
#include "geomesh/core/predicates.hpp"
#include "mesh/spatial_order.hpp"

namespace geomesh {
namespace {

/// Limit that follows from 30-bit cell indices: 8 cells per point suffice for any input with a mesh of linear size.
constexpr std::size_t most_points = 120000000;

void check_coordinates(std::span<const Vec3> points) {
  if (points.size() > most_points)
    throw Error(ErrorKind::cannot_mesh,
                std::to_string(points.size()) + " points are more than the " + std::to_string(most_points) +
                    " that cells with 32-bit indices can hold; mesh parts of the model one by one");
  if (exponents_are_safe(points)) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (exponents_are_safe(points.subspan(i, 1))) continue;
    throw Error(ErrorKind::invalid_input,
                "point " + std::to_string(i) +
                    " has a coordinate that is not finite, or so large or so near zero that exact arithmetic "
                    "would over- or underflow (allowed: 0 and magnitudes from 2^-148 to 2^148, about 3e-45 to 3e44)",
                {{}, {}, {static_cast<VertexIndex>(i)}, {points[i]}});
  }
}

/// Moves four affinely independent points to the front, positively oriented, and keeps the order of the others.
Tetrahedron first_tetrahedron(std::span<const Vec3> points, std::vector<VertexIndex>& order) {
  const auto no_volume = [](const char* what) {
    return Error(ErrorKind::cannot_mesh, std::string("all points lie ") + what + ": there is no volume to triangulate");
  };
  const auto bring = [&](std::ptrdiff_t place, auto&& fits) {
    const auto found =
        std::find_if(order.begin() + std::min<std::ptrdiff_t>(place, std::ssize(order)), order.end(), fits);
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
  if (!bring(3, [&](VertexIndex v) { return orient3d(a, b, c, points[v]) != Sign::zero; }))
    throw no_volume("in one plane");
  if (orient3d(a, b, c, points[order[3]]) == Sign::negative) return {1, 0, 2, 3};
  return {0, 1, 2, 3};
}

/// Returns the cluster distance for the option `auto`: 2^-44 of the model's extent if two consecutive points on the
/// Hilbert curve are that close, otherwise 0. At that distance, differences of coordinates have at most nine
/// significant bits. Deferring at larger distances does not pay (docs/decisions/delaunay.md, "Deferred points").
double chosen_distance(const PodArray<PointRecord>& records, VertexIndex n) {
  Box3 box;
  double least = std::numeric_limits<double>::infinity();
  for (VertexIndex v = 0; v < n; ++v) {
    box.add(records[v]);
    if (v == 0) continue;
    const Vec3 step = records[v] - records[v - 1];
    const double d2 = dot(step, step);
    if (d2 > 0 && d2 < least) least = d2;
  }
  const double distance = 0x1p-44 * std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
  return least < distance * distance ? distance : 0;
}

std::vector<Twin> insert_by_flips(DelaunayTetrahedralization& result, PodArray<PointRecord>& records,
                                  const Tetrahedron& first, double unit, double cluster_distance,
                                  const RunContext& context) {
  const auto n = static_cast<VertexIndex>(records.size() - 1);
  FlipInsertion insertion(result.mesh, Space3(records.data(), n, unit), SlotSource(0, 0, 0, 1));
  insertion.start(first);
  std::vector<Twin> twins;
  std::vector<VertexIndex> waiting;
  const auto insert = [&](VertexIndex v, double distance) {
    const InsertionOutcome outcome = insertion.insert(v, distance);
    if (outcome == InsertionOutcome::duplicate) twins.push_back({v, insertion.twin()});
    if (outcome == InsertionOutcome::too_near) waiting.push_back(v);
    if (v % 16384 == 0) {
      context.check_cancelled();
      context.report(v, n);
    }
  };
  for (VertexIndex v = 4; v < n; ++v) insert(v, cluster_distance);
  result.statistics.points_deferred = waiting.size();
  for (const VertexIndex v : std::exchange(waiting, {})) insert(v, 0);
  insertion.slots().finish(result.mesh);
  result.statistics.stuck_faces = insertion.stuck_faces();
  result.statistics.walk_steps = insertion.walk_steps();
  result.statistics.exact_calls = insertion.space().exact_calls();
  return twins;
}

/// Converts positions in insertion order to the caller's indices.
void finish(DelaunayTetrahedralization& result, const std::vector<Twin>& twins, PodArray<PointRecord>& records,
            unsigned threads) {
  TetMesh::Cell* cells = result.mesh.cells();
  result.representative = merge_twins(twins, records.data(), static_cast<VertexIndex>(records.size() - 1));
  for_each_index(result.mesh.n_slots(), threads, [&](std::size_t c) {
    for (VertexIndex& v : cells[c].vertices) v = records[v].id;
    result.mesh.flags(static_cast<CellIndex>(c)) = 0;
  });
}

}  // namespace

DelaunayTetrahedralization delaunay_tetrahedralization(std::span<const Vec3> points, const DelaunayOptions& options,
                                                       const RunContext& context) {
  check_coordinates(points);
  const unsigned threads = thread_count(context.threads);
  const auto n = static_cast<VertexIndex>(points.size());
  DelaunayTetrahedralization result;
  TetMesh& mesh = result.mesh;
  mesh.reserve(8 * points.size() + 64 * SlotSource::block);
  // The memory of the mesh's cells first serves for sorting the points, which takes 16 of its 256 bytes per point.
  SpatialOrder spatial =
      spatial_order(points, {reinterpret_cast<std::uint64_t*>(mesh.cells()), 2 * points.size()}, threads);
  const Tetrahedron first = first_tetrahedron(points, spatial.order);

  PodArray<PointRecord> records;
  records.grow_to(std::size_t{n} + 1);
  for_each_index(n, threads, [&](std::size_t i) {
    records[i] = PointRecord{points[spatial.order[i]], spatial.order[i], PointRecord::no_local, spatial.place[i]};
  });
  records[n] = PointRecord{points[0], infinite_vertex, PointRecord::no_local, 0};
  const std::vector<std::size_t> round_begin = std::move(spatial.round_begin);
  spatial = {};

  const double unit = coordinate_unit(points);
  const double distance = options.cluster_distance < 0 ? chosen_distance(records, n) : options.cluster_distance;
  if (options.algorithm == DelaunayAlgorithm::flip) {
    const std::vector<Twin> twins = insert_by_flips(result, records, first, unit, distance, context);
    finish(result, twins, records, threads);
    return result;
  }
  CavityStage stage(mesh, records.data(), n, unit, distance, context);
  stage.start(first);
  for (std::size_t r = 0; r + 1 < round_begin.size(); ++r)
    if (round_begin[r + 1] > 4)
      stage.insert_round(static_cast<VertexIndex>(std::max<std::size_t>(round_begin[r], 4)),
                         static_cast<VertexIndex>(round_begin[r + 1]));
  stage.insert_waiting();
  stage.finish(result.statistics);

  finish(result, stage.twins(), records, threads);
  return result;
}

std::size_t make_delaunay(TetMesh& mesh, std::span<const Vec3> points) {
  check_coordinates(points);
  const auto n = static_cast<VertexIndex>(points.size());
  PodArray<PointRecord> records;
  records.grow_to(std::size_t{n} + 1);
  std::vector<char> used(points.size(), 0);
  for (VertexIndex v = 0; v < n; ++v) records[v] = PointRecord{points[v], v};
  records[n] = PointRecord{Vec3{}, infinite_vertex};
  mesh.compact();
  for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
    mesh.flags(c) = mesh.is_ghost(c) ? FlipInsertion::ghost_flag : 0;
    for (unsigned i = 0; i < 4; ++i) {
      const VertexIndex v = mesh.vertex(c, i);
      if (v == infinite_vertex)
        mesh.set_vertex(c, i, n);
      else
        used[v] = 1;
    }
  }
  SlotSource slots;
  slots.restart(mesh.n_slots(), mesh.n_slots());
  FlipInsertion flips(mesh, Space3(records.data(), n, coordinate_unit(points)), slots);
  const std::size_t stuck = flips.flip_all();
  flips.slots().finish(mesh);
  if (stuck == 0) {
    DelaunayTetrahedralization result;
    std::swap(result.mesh, mesh);
    finish(result, {}, records, 1);
    std::swap(result.mesh, mesh);
    return 0;
  }
  std::vector<Vec3> kept;
  std::vector<VertexIndex> row;
  for (VertexIndex v = 0; v < n; ++v)
    if (used[v]) {
      kept.push_back(points[v]);
      row.push_back(v);
    }
  mesh = delaunay_tetrahedralization(kept).mesh;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    for (unsigned i = 0; i < 4; ++i)
      if (mesh.vertex(c, i) != infinite_vertex) mesh.set_vertex(c, i, row[mesh.vertex(c, i)]);
  return stuck;
}

}  // namespace geomesh

// SPDX-License-Identifier: MIT
#include "remesh/tolerance/verify_surfaces.hpp"

#include <algorithm>

#include "common/parallel.hpp"
#include "plc/find_crossing.hpp"
#include "search/cover_proof.hpp"

namespace geomesh::remesh {

namespace {

/// What is left of the tolerance is for rounding in the distances and cuts.
constexpr double proven_share = 1 - 1e-6;
constexpr std::size_t chunk = 256;

using Items = std::vector<search::ClosestPointTrees::Item>;

/// Judges the items against those of their groups in the set. Returns the largest distance found.
double judge(const Items& items, const search::ClosestPointTrees& set, std::span<const std::uint8_t> open_edges,
             double tolerance, unsigned threads, Breach kind, std::vector<Breach>& breaches) {
  std::vector<search::Cover> covers(items.size());
  for_each_task((items.size() + chunk - 1) / chunk, threads, [&](std::size_t k) {
    search::CoverProver prover(set, proven_share * tolerance, open_edges);
    for (std::size_t i = k * chunk; i < std::min(items.size(), (k + 1) * chunk); ++i)
      covers[i] = prover.judge(items[i].corners, items[i].group);
  });
  double largest = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    largest = std::max(largest, covers[i].farthest);
    if (covers[i].is_proven) continue;
    kind.place = covers[i].place;
    kind.distance = covers[i].farthest;
    kind.group = items[i].group;
    kind.facet = items[i].id;
    breaches.push_back(kind);
  }
  return largest;
}

}  // namespace

Items face_items(const DomainMesh& mesh) {
  Items items;
  for_each_face_of_facets(mesh, [&](const Triangle& t, FaceTag tag) {
    items.push_back({{mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2])}, mesh.patch_of(tag), tag.facet()});
  });
  return items;
}

Items curve_items(const DomainMesh& mesh) {
  Items items;
  for (const auto& [a, b] : mesh.curve_edges())
    items.push_back({{mesh.point(a), mesh.point(b), mesh.point(b)}, mesh.curve_of(a, b), no_index});
  return items;
}

SurfaceItems surface_items(const DomainMesh& faces_of, const DomainMesh& curves_of) {
  SurfaceItems items{
      {face_items(faces_of), faces_of.n_patches()}, {curve_items(curves_of), curves_of.n_curve_classes()}, {}};
  items.open_edges = search::find_open_edges(items.faces.items());
  return items;
}

Deviations verify_surfaces(const DomainMesh& mesh, const SurfaceItems& input, double tolerance, unsigned threads) {
  Deviations found;
  const SurfaceItems result = surface_items(mesh, mesh);
  const Breach face_off{.on_curve = false, .of_input = false}, curve_off{.on_curve = true, .of_input = false};
  const Breach input_face_off{.on_curve = false, .of_input = true}, input_curve_off{.on_curve = true, .of_input = true};
  threads = thread_count(threads);
  found.result_to_input =
      std::max(judge(result.faces.items(), input.faces, input.open_edges, tolerance, threads, face_off, found.breaches),
               judge(result.curves.items(), input.curves, {}, tolerance, threads, curve_off, found.breaches));
  found.input_to_result = std::max(
      judge(input.faces.items(), result.faces, result.open_edges, tolerance, threads, input_face_off, found.breaches),
      judge(input.curves.items(), result.curves, {}, tolerance, threads, input_curve_off, found.breaches));
  return found;
}

std::vector<TightZone> crossings_outside(const DomainMesh& mesh) {
  PiecewiseLinearComplex outside;
  for (VertexIndex v = 0; v < mesh.n_vertices(); ++v) outside.points.push_back(mesh.point(v));
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    for (unsigned i = 0; i < 4; ++i) {
      if (!mesh.is_live(c) || mesh.has_neighbor(c, i)) continue;
      for (const unsigned k : face_vertices[i]) outside.loop_vertices.push_back(mesh.vertices(c)[k]);
      outside.loop_offsets.push_back(static_cast<Index>(outside.loop_vertices.size()));
      outside.facet_loops.push_back(static_cast<Index>(outside.loop_offsets.size() - 1));
    }
  std::vector<TightZone> zones;
  for (const PlcCrossing& crossing : find_crossings(outside)) {
    Box3 box;
    box.add(mesh.point(crossing.a));
    box.add(mesh.point(crossing.b));
    for (const VertexIndex v : outside.loop(crossing.facet)) box.add(mesh.point(v));
    zones.push_back({box, 0});
  }
  return zones;
}

}  // namespace geomesh::remesh

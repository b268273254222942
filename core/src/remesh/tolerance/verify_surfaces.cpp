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

/// What is judged: the items, against those of their groups in the set.
struct Judgement {
  const Items& items;
  const search::ClosestPointTrees& set;
  std::span<const std::uint8_t> open_edges;
  Breach kind;
};

double limit_of(const search::ClosestPointTrees::Item& item, const Breach& kind, const LocalTolerance& tolerance) {
  return proven_share * (kind.of_input ? tolerance.most_on(item.corners) : tolerance.least_at(item.corners));
}

/// Returns the largest distance found.
double judge(const Judgement& what, const LocalTolerance& tolerance, unsigned threads, std::vector<Breach>& breaches) {
  const Items& items = what.items;
  std::vector<search::Cover> covers(items.size());
  for_each_task((items.size() + chunk - 1) / chunk, threads, [&](std::size_t k) {
    search::CoverProver prover(what.set, proven_share * tolerance.greatest(), what.open_edges);
    for (std::size_t i = k * chunk; i < std::min(items.size(), (k + 1) * chunk); ++i) {
      prover.set_limit(limit_of(items[i], what.kind, tolerance));
      covers[i] = prover.judge(items[i].corners, items[i].group);
    }
  });
  double largest = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    largest = std::max(largest, covers[i].farthest);
    if (covers[i].is_proven) continue;
    Breach breach = what.kind;
    breach.place = covers[i].place;
    breach.distance = covers[i].farthest;
    breach.group = items[i].group;
    breach.facet = items[i].id;
    breaches.push_back(breach);
  }
  return largest;
}

}  // namespace

Items face_items(const DomainMesh& mesh) {
  Items items;
  mesh.for_each_facet_face([&](FaceRef f) {
    items.push_back({mesh.places(mesh.face(f)), mesh.patch_of(mesh.tag(f)), mesh.tag(f).facet()});
  });
  return items;
}

Items curve_items(const DomainMesh& mesh) {
  Items items;
  for (const auto& [a, b] : mesh.curve_edges())
    items.push_back({mesh.places(Triangle{a, b, b}), mesh.curve_of(a, b), no_index});
  return items;
}

SurfaceItems surface_items(const DomainMesh& faces_of, const DomainMesh& curves_of) {
  SurfaceItems items{
      {face_items(faces_of), faces_of.n_patches()}, {curve_items(curves_of), curves_of.n_curve_classes()}, {}};
  items.open_edges = search::find_open_edges(items.faces.items());
  return items;
}

Deviations verify_surfaces(const DomainMesh& mesh, const SurfaceItems& input, const LocalTolerance& tolerance,
                           unsigned threads) {
  Deviations found;
  const SurfaceItems result = surface_items(mesh, mesh);
  const auto largest = [&](const SurfaceItems& of, const SurfaceItems& to, bool of_input) {
    const auto judged = [&](const Judgement& j) { return judge(j, tolerance, thread_count(threads), found.breaches); };
    const double faces = judged({of.faces.items(), to.faces, to.open_edges, {.on_curve = false, .of_input = of_input}});
    return std::max(faces, judged({of.curves.items(), to.curves, {}, {.on_curve = true, .of_input = of_input}}));
  };
  found.result_to_input = largest(result, input, false);
  found.input_to_result = largest(input, result, true);
  return found;
}

std::vector<TightZone> crossings_outside(const DomainMesh& mesh) {
  PiecewiseLinearComplex outside;
  for (VertexIndex v = 0; v < mesh.n_vertices(); ++v) outside.points.push_back(mesh.point(v));
  for (const CellIndex c : mesh.live_cells())
    for (unsigned i = 0; i < 4; ++i)
      if (!mesh.has_neighbor(c, i)) outside.add_triangle(mesh.face(c, i));
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

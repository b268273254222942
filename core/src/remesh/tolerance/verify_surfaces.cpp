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

/// By group and corners.
bool is_before(const search::ClosestPointTrees::Item& a, const search::ClosestPointTrees::Item& b) {
  const auto key = [](const auto& item) {
    const auto& [p, q, r] = item.corners;
    return std::tuple(item.group, p.x, p.y, p.z, q.x, q.y, q.z, r.x, r.y, r.z);
  };
  return key(a) < key(b);
}

std::vector<std::size_t> in_order(const Items& items) {
  std::vector<std::size_t> rows(items.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  std::ranges::sort(rows, [&](std::size_t a, std::size_t b) { return is_before(items[a], items[b]); });
  return rows;
}

constexpr std::size_t no_row = static_cast<std::size_t>(-1);

/// What is the same in two lists of items, and what is not.
struct Difference {
  std::vector<std::size_t> same;        ///< by item of the second: its row in the first, or no_row
  search::ClosestPointTrees exchanged;  ///< those of either that are not in the other
};

Difference difference(const Items& first, const Items& second, std::size_t n_groups) {
  Difference d{std::vector<std::size_t>(second.size(), no_row), {}};
  const std::vector<std::size_t> f = in_order(first), s = in_order(second);
  Items exchanged;
  std::size_t i = 0, j = 0;
  while (i < f.size() || j < s.size()) {
    if (j == s.size() || (i < f.size() && is_before(first[f[i]], second[s[j]]))) {
      exchanged.push_back(first[f[i++]]);
    } else if (i == f.size() || is_before(second[s[j]], first[f[i]])) {
      exchanged.push_back(second[s[j++]]);
    } else {
      d.same[s[j++]] = f[i++];
    }
  }
  d.exchanged = search::ClosestPointTrees(std::move(exchanged), n_groups);
  return d;
}

/// What is judged: the items, against those of their groups in the set.
struct Judgement {
  const Items& items;
  const search::ClosestPointTrees& set;
  std::span<const std::uint8_t> open_edges;
  Breach kind;
};

/// Covers of items as far as they are known already.
using Known = std::vector<std::optional<search::Cover>>;

/// Of the result: those of the same items before.
Known known_of_result(const Difference& d, const std::vector<search::Cover>& before) {
  Known known(d.same.size());
  for (std::size_t i = 0; i < known.size(); ++i)
    if (d.same[i] != no_row) known[i] = before[d.same[i]];
  return known;
}

/// Of the input: those that were proven by what is there still.
Known known_of_input(const Difference& d, const Items& input, double reach, const std::vector<search::Cover>& before) {
  Known known(input.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    Box3 box;
    for (const Vec3& p : input[i].corners) {
      box.add(p - Vec3{reach, reach, reach});
      box.add(p + Vec3{reach, reach, reach});
    }
    bool is_left = before[i].is_proven;
    d.exchanged.for_each_in(box, input[i].group, [&](const auto&) { is_left = false; });
    if (is_left) known[i] = before[i];
  }
  return known;
}

double limit_of(const search::ClosestPointTrees::Item& item, const Breach& kind, const LocalTolerance& tolerance,
                search::RecentPlaces& recent) {
  return proven_share *
         (kind.of_input ? tolerance.most_on(item.corners) : tolerance.least_at(item.corners, recent));
}

/// Returns the largest distance found.
double judge(const Judgement& what, const LocalTolerance& tolerance, unsigned threads, const Known& known,
             std::vector<search::Cover>& covers, std::vector<Breach>& breaches) {
  const Items& items = what.items;
  covers.assign(items.size(), {});
  for_each_task((items.size() + chunk - 1) / chunk, threads, [&](std::size_t k) {
    search::CoverProver prover(what.set, proven_share * tolerance.greatest(), what.open_edges);
    search::RecentPlaces recent;
    for (std::size_t i = k * chunk; i < std::min(items.size(), (k + 1) * chunk); ++i) {
      if (i < known.size() && known[i]) {
        covers[i] = *known[i];
        continue;
      }
      prover.set_limit(limit_of(items[i], what.kind, tolerance, recent));
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
                           unsigned threads, VerifiedSurfaces* before) {
  Deviations found;
  VerifiedSurfaces now{surface_items(mesh, mesh), {}, {}, {}, {}};
  const bool is_first = !before || before->input_faces.empty();
  const auto largest = [&](const auto& of_result, const auto& of_input, std::span<const std::uint8_t> open_of_result,
                           std::span<const std::uint8_t> open_of_input, bool on_curve, auto VerifiedSurfaces::*covers,
                           auto VerifiedSurfaces::*input_covers) {
  };
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

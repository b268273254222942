// SPDX-License-Identifier: MIT
#include "remesh/tolerance/verify_surfaces.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "common/parallel.hpp"
#include "plc/find_crossing.hpp"

namespace geomesh::remesh {

namespace {

/// Share of the tolerance within which pieces must be; the rest allows for rounding in distances and intersections.
constexpr double proven_share = 1 - 1e-6;
constexpr std::size_t chunk = 256;

using Items = std::vector<search::ClosestPointTrees::Item>;

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

struct Difference {
  std::vector<std::size_t> same;        ///< index of each face or edge of the second list in the first, or no_row
  search::ClosestPointTrees exchanged;  ///< pieces (faces or curve edges) that only one of the two lists contains
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

/// For each face or curve edge, the distance found by an earlier verification, if it is still valid.
using Known = std::vector<std::optional<search::Cover>>;

struct KnownCovers {
  Known result, input;
};

/// Collects the distances found earlier that are still valid: for pieces of the result that existed before, and for
/// pieces of the input near which no piece of the result has been added or removed.
KnownCovers known_covers(const Items& before, const Items& now, std::size_t n_groups, const Items& input, double reach,
                         const VerifiedSurfaces::Covers& covers) {
  const Difference d = difference(before, now, n_groups);
  KnownCovers known{Known(now.size()), Known(input.size())};
  for (std::size_t i = 0; i < known.result.size(); ++i)
    if (d.same[i] != no_row) known.result[i] = covers.result[d.same[i]];
  for (std::size_t i = 0; i < known.input.size(); ++i) {
    const auto& item = input[i];
    bool is_left = covers.input[i].is_proven;
    d.exchanged.for_each_in(search::box_about(item.corners, reach), item.group, [&](const auto&) { is_left = false; });
    if (is_left) known.input[i] = covers.input[i];
  }
  return known;
}

/// A verification: each piece of the surfaces `judged` must be near the surfaces `set`.
struct Judgement {
  const search::ReferenceSurfaces &judged, &set;
  Breach kind;
};

struct Judge {
  const LocalTolerance& tolerance;
  unsigned threads;
  std::vector<Breach>& breaches;  ///< receives pieces not proven to be within the tolerance

  /// Stores how far each piece is from the other model (distances in `known` are kept), and returns the largest.
  double largest(const Judgement& what, const Known& known, std::vector<search::Cover>& covers) const {
    const Items& items = what.judged.pieces();
    const double deviation = what.judged.deviation_of_pieces();
    covers.assign(items.size(), {});
    for_each_task((items.size() + chunk - 1) / chunk, threads, [&](std::size_t k) {
      search::RecentPlaces recent;
      std::vector<std::size_t> rows;
      std::vector<search::DistanceQuestion> questions;
      for (std::size_t i = k * chunk; i < std::min(items.size(), (k + 1) * chunk); ++i) {
        if (!known.empty() && known[i]) {
          covers[i] = *known[i];
          continue;
        }
        rows.push_back(i);
        questions.push_back({items[i].corners, items[i].group, limit_of(items[i], what.kind, recent) - deviation, {}});
      }
      what.set.within(questions);
      for (std::size_t i = 0; i < rows.size(); ++i) covers[rows[i]] = questions[i].answer;
    });
    double largest = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
      largest = std::max(largest, covers[i].farthest);
      if (!covers[i].is_proven) add_breach(items[i], covers[i], what.kind);
    }
    return largest;
  }

 private:
  double limit_of(const search::ClosestPointTrees::Item& item, const Breach& kind, search::RecentPlaces& recent) const {
    return proven_share * (kind.of_input ? tolerance.most_on(item.corners) : tolerance.least_at(item.corners, recent));
  }
  void add_breach(const search::ClosestPointTrees::Item& item, const search::Cover& cover, Breach breach) const {
    breach.place = cover.place;
    breach.distance = cover.farthest;
    breach.group = item.group;
    breach.facet = item.id;
    breaches.push_back(breach);
  }
};

}  // namespace

search::TriangleSurfaces faces_of(const DomainMesh& mesh, std::vector<Vec3> normals) {
  Items items;
  mesh.for_each_facet_face([&](FaceRef f) {
    items.push_back({mesh.places(mesh.face(f)), mesh.patch_of(mesh.tag(f)), mesh.tag(f).facet()});
  });
  return {std::move(items), mesh.n_patches(), std::move(normals)};
}

search::TriangleSurfaces curves_of(const DomainMesh& mesh) {
  Items items;
  for (const auto& [a, b] : mesh.curve_edges())
    items.push_back({mesh.places(Triangle{a, b, b}), mesh.curve_of(a, b), no_index});
  return {std::move(items), mesh.n_curve_classes()};
}

Deviations verify_surfaces(const DomainMesh& mesh, const ReferenceModel& input, const LocalTolerance& tolerance,
                           unsigned threads, VerifiedSurfaces* before) {
  VerifiedSurfaces now;
  now.result_faces = faces_of(mesh);
  now.result_curves = curves_of(mesh);
  KnownCovers faces, curves;
  if (before && !before->faces.result.empty()) {
    const double reach = tolerance.greatest();
    faces = known_covers(before->result_faces.pieces(), now.result_faces.pieces(), mesh.n_patches(),
                         input.faces.pieces(), reach, before->faces);
    curves = known_covers(before->result_curves.pieces(), now.result_curves.pieces(), mesh.n_curve_classes(),
                          input.curves.pieces(), reach, before->curves);
  }
  Deviations found;
  const Judge judge{tolerance, thread_count(threads), found.breaches};
  found.result_to_input =
      std::max(judge.largest({now.result_faces, input.faces, {}}, faces.result, now.faces.result),
               judge.largest({now.result_curves, input.curves, {.on_curve = true}}, curves.result, now.curves.result));
  found.input_to_result =
      std::max(judge.largest({input.faces, now.result_faces, {.of_input = true}}, faces.input, now.faces.input),
               judge.largest({input.curves, now.result_curves, {.on_curve = true, .of_input = true}}, curves.input,
                             now.curves.input));
  if (before) *before = std::move(now);
  return found;
}

std::vector<TightZone> crossings_outside(const DomainMesh& mesh, unsigned threads) {
  PiecewiseLinearComplex outside;
  for (VertexIndex v = 0; v < mesh.n_vertices(); ++v) outside.points.push_back(mesh.point(v));
  for (const CellIndex c : mesh.live_cells())
    for (unsigned i = 0; i < 4; ++i)
      if (!mesh.has_neighbor(c, i)) outside.add_triangle(mesh.face(c, i));
  std::vector<TightZone> zones;
  for (const PlcCrossing& crossing : find_crossings(outside, thread_count(threads))) {
    Box3 box;
    box.add(mesh.point(crossing.a));
    box.add(mesh.point(crossing.b));
    for (const VertexIndex v : outside.loop(crossing.facet)) box.add(mesh.point(v));
    zones.push_back({box, 0});
  }
  return zones;
}

}  // namespace geomesh::remesh

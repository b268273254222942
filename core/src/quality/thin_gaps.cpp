// SPDX-License-Identifier: MIT
#include "quality/thin_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry.hpp"
#include "quality/measure/shape.hpp"

namespace geomesh {

namespace {

constexpr double least_cosine = 0.5;  // 60 degrees
constexpr double straight_sine = 1e-3;

search::ClosestPointTrees trees_of_patches(const SoupStars& stars) {
  const ConstrainedTetrahedralization& mesh = stars.mesh();
  std::vector<search::ClosestPointTrees::Item> items;
  Index n_patches = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Triangle& t = mesh.faces[f].vertices;
    items.push_back({{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]}, stars.patch_of(f), f});
    n_patches = std::max(n_patches, stars.patch_of(f) + 1);
  }
  return search::ClosestPointTrees(std::move(items), n_patches);
}

}  // namespace

GapFinder::GapFinder(const SoupStars& stars, double angle, bool fixed_vertices)
    : stars_(stars),
      mesh_(stars.mesh()),
      patches_(trees_of_patches(stars)),
      cosine_(std::cos(angle * pi / 180)),
      sine_(std::sin(angle * pi / 180)),
      fixed_vertices_(fixed_vertices) {}

Vec3 GapFinder::normal_towards(Index face, const Vec3& inside) const {
  const Triangle& t = mesh_.faces[face].vertices;
  const Vec3& p = mesh_.points[t[0]];
  const Vec3 n = unit(cross(mesh_.points[t[1]] - p, mesh_.points[t[2]] - p));
  return dot(n, inside - p) < 0 ? -1 * n : n;
}

bool GapFinder::is_on(VertexIndex v, Index patch) const {
  const auto faces = stars_.faces(v);
  return std::any_of(faces.begin(), faces.end(), [&](Index f) { return stars_.patch_of(f) == patch; });
}

bool GapFinder::has_side(VertexIndex v, VertexIndex other) const {
  const auto edges = stars_.edges(v);
  return std::any_of(edges.begin(), edges.end(), [&](const SoupEdge& e) { return e.other == other; });
}

bool GapFinder::is_fixed(VertexIndex v) const {
  return fixed_vertices_ && mesh_.input_vertex[v] != no_vertex &&
         (!stars_.edges(v).empty() || !stars_.faces(v).empty());
}

/// Finds a facet at the start of the path that faces the facet with `opposite_normal` across the gap. `step` is the
/// unit direction of the path.
bool GapFinder::leaves_facet(const Way& way, const Vec3& step, const Vec3& opposite_normal, Gap& found) const {
  for (const Index f : stars_.faces(way.from)) {
    if (is_on(way.to, stars_.patch_of(f))) continue;
    const Vec3 n = normal_towards(f, way.inside);
    if (dot(n, step) < least_cosine || dot(n, opposite_normal) > -cosine_) continue;
    found.facet_a = mesh_.faces[f].facet;
    return true;
  }
  return false;
}

/// Finds a segment at vertex v to which the path, with unit direction `step`, leads at a large angle. The segment must
/// be parallel to the facet with `normal` if that is given, and to the direction `parallel` if that is given.
bool GapFinder::leaves_segment(VertexIndex v, const Vec3& step, const Vec3* normal, const Vec3* parallel,
                               Gap& found) const {
  for (const SoupEdge& e : stars_.edges(v)) {
    const Vec3 d = unit(mesh_.points[e.other] - mesh_.points[v]);
    if (std::abs(dot(d, step)) > least_cosine) continue;
    if (normal && std::abs(dot(d, *normal)) > sine_) continue;
    if (parallel && std::abs(dot(d, *parallel)) < cosine_) continue;
    found.facet_a = stars_.facet_of(e.face), found.segment_a = e.segment;
    return true;
  }
  return false;
}

/// Follows a straight segment from the vertex way.to along the edge `first`, and returns its other end. The segment
/// continues at points that meshing has added to it; it ends at a corner, at a turn, or at the vertex way.from.
VertexIndex GapFinder::end_of_segment(const Way& way, const SoupEdge& first) const {
  VertexIndex before = way.to, at = first.other;
  while (at != way.from && mesh_.input_vertex[at] == no_vertex) {
    const auto edges = stars_.edges(at);
    if (edges.size() != 2) break;
    const VertexIndex next = edges[0].other == before ? edges[1].other : edges[0].other;
    const Vec3 d = unit(mesh_.points[at] - mesh_.points[before]), e = unit(mesh_.points[next] - mesh_.points[at]);
    if (next == way.to || dot(d, e) < 0 || length(cross(d, e)) > straight_sine) break;
    before = std::exchange(at, next);
  }
  return at;
}

void GapFinder::to_facets(const Way& way, double above, Gap& best) const {
  const Vec3& from = mesh_.points[way.from];
  for (const Index g : stars_.faces(way.to)) {
    if (is_on(way.from, stars_.patch_of(g))) continue;
    const auto nearest = patches_.closest(from, stars_.patch_of(g), best.width);
    if (!(nearest.distance > above) || !(nearest.distance < best.width)) continue;
    const Vec3 step = unit(nearest.point - from), normal = normal_towards(g, way.inside);
    if (-dot(normal, step) < least_cosine) continue;
    Gap found{.width = nearest.distance, .facet_b = mesh_.faces[g].facet};
    if (is_fixed(way.from) && !stars_.faces(way.from).empty())
      found.facet_a = mesh_.faces[stars_.faces(way.from).front()].facet;
    if (leaves_facet(way, step, normal, found) || leaves_segment(way.from, step, &normal, nullptr, found) ||
        is_fixed(way.from))
      best = found;
  }
}

void GapFinder::to_segments(const Way& way, double above, Gap& best) const {
  const Vec3 &from = mesh_.points[way.from], &to = mesh_.points[way.to];
  for (const SoupEdge& e : stars_.edges(way.to)) {
    const VertexIndex end = end_of_segment(way, e);
    if (end == way.from || has_side(way.from, e.other)) continue;
    const Vec3 nearest = search::closest_on_segment(from, to, mesh_.points[end]),
               along = unit(mesh_.points[e.other] - to);
    const double width = distance(from, nearest);
    if (!(width > above) || !(width < best.width)) continue;
    const Vec3 step = unit(nearest - from);
    if (std::abs(dot(along, step)) > least_cosine) continue;
    Gap found{.width = width, .facet_b = stars_.facet_of(e.face), .segment_b = e.segment};
    if (is_fixed(way.from) && !stars_.faces(way.from).empty())
      found.facet_a = mesh_.faces[stars_.faces(way.from).front()].facet;
    if (leaves_segment(way.from, step, nullptr, &along, found) || is_fixed(way.from)) best = found;
  }
}

void GapFinder::to_vertex(const Way& way, double above, Gap& best) const {
  if (!is_fixed(way.from) || !is_fixed(way.to) || has_side(way.from, way.to)) return;
  const double width = distance(mesh_.points[way.from], mesh_.points[way.to]);
  if (!(width > above) || !(width < best.width)) return;
  const auto facet_at = [&](VertexIndex v) {
    return stars_.faces(v).empty() ? no_index : mesh_.faces[stars_.faces(v).front()].facet;
  };
  best = {.width = width, .facet_a = facet_at(way.from), .facet_b = facet_at(way.to)};
}

Gap GapFinder::narrowest(Index tetrahedron, double above) const {
  const Tetrahedron& t = mesh_.tetrahedra[tetrahedron];
  const Vec3 inside = 0.25 * ((mesh_.points[t[0]] + mesh_.points[t[1]]) + (mesh_.points[t[2]] + mesh_.points[t[3]]));
  Gap best;
  for (const VertexIndex from : t)
    for (const VertexIndex to : t) {
      if (from == to) continue;
      const Way way{from, to, inside};
      to_facets(way, above, best);
      to_segments(way, above, best);
      to_vertex(way, above, best);
    }
  return best;
}

}  // namespace geomesh

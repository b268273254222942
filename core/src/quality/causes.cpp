// SPDX-License-Identifier: MIT
#include "quality/causes.hpp"

#include <algorithm>
#include <cmath>

#include "geomesh/core/simplex_mesh.hpp"
#include "quality/shape.hpp"
#include "search/closest_point.hpp"

namespace geomesh {

namespace {

const double degrees = 180 / std::acos(-1.0);

double angle(const Vec3& a, const Vec3& b) { return std::atan2(remesh::length(cross(a, b)), dot(a, b)) * degrees; }

/// Least angle between a direction and the sector between two others.
double angle_to_sector(const Vec3& d, const Vec3& a, const Vec3& b) {
  const double at_sides = std::min(angle(d, a), angle(d, b));
  const Vec3 n = cross(a, b);
  const double nn = dot(n, n);
  if (!(nn > 0)) return at_sides;
  const Vec3 foot = d - (dot(d, n) / nn) * n;  // within the sector where it turns from a towards b and not beyond
  if (dot(cross(a, foot), n) >= 0 && dot(cross(foot, b), n) >= 0) return std::min(at_sides, angle(d, foot));
  return at_sides;
}

/// Distance between two segments: the least over a grid refined about its least, enough for a report.
double distance_between_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  double low = 0, high = 1;
  const auto at = [&](double t) {
    const Vec3 p = a + t * (b - a);
    return remesh::distance(p, search::closest_on_segment(p, c, d));
  };
  for (unsigned k = 0; k < 60; ++k) {  // the distance is convex in t
    const double u = low + (high - low) / 3, v = high - (high - low) / 3;
    (at(u) < at(v) ? high : low) = at(u) < at(v) ? v : u;
  }
  return at(0.5 * (low + high));
}

}  // namespace

CauseFinder::CauseFinder(const PiecewiseLinearComplex&, const ConstrainedTetrahedralization& mesh, const QualityOptions& options)
    : mesh_(mesh), options_(options), faces_at_(mesh.points.size()), edges_at_(mesh.points.size()), forced_(mesh.points.size()) {
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (const VertexIndex v : mesh.faces[f].vertices) faces_at_[v].push_back(f);
  collect_edges();
}

Index CauseFinder::patch_of(Index face) const {
  const Index facet = mesh_.faces[face].facet;
  return facet < options_.facet_patch.size() ? options_.facet_patch[facet] : facet;
}

void CauseFinder::collect_edges() {
  struct Use {
    VertexIndex a, b;
    Index facet, patch;
  };
  std::vector<Use> uses;
  for (Index f = 0; f < mesh_.faces.size(); ++f)
    for (unsigned k = 0; k < 3; ++k) {
      const VertexIndex a = mesh_.faces[f].vertices[k], b = mesh_.faces[f].vertices[(k + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), mesh_.faces[f].facet, patch_of(f)});
    }
  std::sort(uses.begin(), uses.end(),
            [](const Use& x, const Use& y) { return std::tuple(x.a, x.b, x.facet) < std::tuple(y.a, y.b, y.facet); });
  for (std::size_t i = 0, j; i < uses.size(); i = j) {
    for (j = i; j < uses.size() && uses[j].a == uses[i].a && uses[j].b == uses[i].b;) ++j;
    if (j - i == 2 && uses[i].patch == uses[i + 1].patch) continue;  // in the inside of a facet, or of a remeshed patch
    edges_at_[uses[i].a].push_back({uses[i].b, no_index, uses[i].facet});
    edges_at_[uses[i].b].push_back({uses[i].a, no_index, uses[i].facet});
  }
  for (const auto& e : mesh_.edges) {
    edges_at_[e.a].push_back({e.b, e.segment, no_index});
    edges_at_[e.b].push_back({e.a, e.segment, no_index});
  }
}

double CauseFinder::angle_between(VertexIndex v, Index face_a, Index face_b) const {
  const auto sides = [&](Index f) {
    const Triangle& t = mesh_.faces[f].vertices;
    const unsigned k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
    return std::array{t[(k + 1) % 3], t[(k + 2) % 3]};
  };
  const auto s = sides(face_a), t = sides(face_b);
  const auto d = [&](VertexIndex x) { return mesh_.points[x] - mesh_.points[v]; };
  for (unsigned i = 0; i < 2; ++i)
    for (unsigned j = 0; j < 2; ++j)
      if (s[i] == t[j]) {
        // A common edge: the angle between the two half-planes.
        const Vec3 e = d(s[i]);
        return angle(cross(e, d(s[1 - i])), cross(e, d(t[1 - j])));
      }
  return std::min({angle_to_sector(d(s[0]), d(t[0]), d(t[1])), angle_to_sector(d(s[1]), d(t[0]), d(t[1])),
                   angle_to_sector(d(t[0]), d(s[0]), d(s[1])), angle_to_sector(d(t[1]), d(s[0]), d(s[1]))});
}

double CauseFinder::angle_of_edge(VertexIndex v, VertexIndex other, Index face) const {
  const Triangle& t = mesh_.faces[face].vertices;
  if (t[0] == other || t[1] == other || t[2] == other) return 180;  // the face's own side
  const unsigned k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
  const Vec3& p = mesh_.points[v];
  return angle_to_sector(mesh_.points[other] - p, mesh_.points[t[(k + 1) % 3]] - p, mesh_.points[t[(k + 2) % 3]] - p);
}

CauseFinder::ForcedAngle CauseFinder::least_angle_at(VertexIndex v) const {
  ForcedAngle least;
  least.angle = options_.forcing_angle;
  const auto found = [&](const ForcedAngle& f) {
    if (f.angle < least.angle) least = f;
  };
  const auto& faces = faces_at_[v];
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j)
      if (patch_of(faces[i]) != patch_of(faces[j]))
        found({angle_between(v, faces[i], faces[j]), mesh_.faces[faces[i]].facet, mesh_.faces[faces[j]].facet, no_index, no_index});
  const auto& edges = edges_at_[v];
  const Vec3& p = mesh_.points[v];
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j)
      if (edges[i].other != edges[j].other)
        found({angle(mesh_.points[edges[i].other] - p, mesh_.points[edges[j].other] - p), edges[i].facet, edges[j].facet,
               edges[i].segment, edges[j].segment});
    if (edges[i].segment == no_index) continue;
    for (const Index f : faces)
      found({angle_of_edge(v, edges[i].other, f), no_index, mesh_.faces[f].facet, edges[i].segment, no_index});
  }
  return least;
}

const CauseFinder::ForcedAngle& CauseFinder::forced_angle_at(VertexIndex v) {
  if (forced_[v].angle < 0) forced_[v] = least_angle_at(v);
  return forced_[v];
}

std::vector<Index> CauseFinder::facets_at(VertexIndex v) const {
  std::vector<Index> facets;
  for (const Index f : faces_at_[v]) facets.push_back(mesh_.faces[f].facet);
  std::sort(facets.begin(), facets.end());
  return facets;
}

bool CauseFinder::explain_by_gap(WorstElement& w) const {
  if (!options_.size) return false;
  const Tetrahedron& t = mesh_.tetrahedra[w.tetrahedron];
  const double limit = 0.25 * options_.size->at(w.place, mesh_.component[w.tetrahedron]);
  const auto apart = [&](std::initializer_list<VertexIndex> a, std::initializer_list<VertexIndex> b) {
    for (const VertexIndex x : a)
      for (const VertexIndex y : b) {
        const std::vector<Index> fx = facets_at(x), fy = facets_at(y);
        std::vector<Index> common;
        std::set_intersection(fx.begin(), fx.end(), fy.begin(), fy.end(), std::back_inserter(common));
        if (fx.empty() || fy.empty() || !common.empty()) return false;
      }
    return true;
  };
  const auto found = [&](double gap, VertexIndex a, VertexIndex b) {
    if (!(gap < limit) || (w.cause == ShapeCause::thin_gap && gap >= w.gap)) return;
    w.cause = ShapeCause::thin_gap;
    w.gap = gap;
    w.facet_a = facets_at(a).front(), w.facet_b = facets_at(b).front();
  };
  const auto p = [&](unsigned i) { return mesh_.points[t[i]]; };
  for (unsigned i = 0; i < 4; ++i) {
    const auto& f = face_vertices[i];
    if (apart({t[i]}, {t[f[0]], t[f[1]], t[f[2]]}))
      found(remesh::distance(p(i), search::closest_on_triangle(p(i), p(f[0]), p(f[1]), p(f[2]))), t[i], t[f[0]]);
  }
  for (unsigned e = 0; e < 3; ++e) {
    const auto [i, j] = edge_vertices[e];
    const auto [k, l] = edge_vertices[5 - e];
    if (apart({t[i], t[j]}, {t[k], t[l]})) found(distance_between_segments(p(i), p(j), p(k), p(l)), t[i], t[k]);
  }
  return w.cause == ShapeCause::thin_gap;
}

void CauseFinder::explain(WorstElement& w) {
  for (const VertexIndex v : mesh_.tetrahedra[w.tetrahedron]) {
    const ForcedAngle& forced = forced_angle_at(v);
    if (!(forced.angle < options_.forcing_angle)) continue;
    w.cause = ShapeCause::input_angle;
    w.forcing_angle = forced.angle;
    w.facet_a = forced.facet_a, w.facet_b = forced.facet_b;
    w.segment_a = forced.segment_a, w.segment_b = forced.segment_b;
    return;
  }
  explain_by_gap(w);
}

}  // namespace geomesh

// SPDX-License-Identifier: MIT
#include "quality/soup_star.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "common/geometry.hpp"
#include "quality/measure/shape.hpp"

namespace geomesh {

namespace {

/// Returns the least angle between a direction and the sector between two others.
double angle_to_sector(const Vec3& d, const Vec3& a, const Vec3& b) {
  const double at_sides = std::min(angle_between(d, a), angle_between(d, b));
  const Vec3 n = cross(a, b);
  const double nn = dot(n, n);
  if (!(nn > 0)) return at_sides;
  const Vec3 foot = d - (dot(d, n) / nn) * n;  // direction d projected to the plane of the directions a and b
  if (dot(cross(a, foot), n) < 0 || dot(cross(foot, b), n) < 0) return at_sides;
  const double height = std::abs(dot(d, n)) / std::sqrt(nn);  // accurate even if d is normal to the plane of a and b
  return std::min(at_sides, std::atan2(height, length(foot)) * degrees_per_radian);
}

}  // namespace

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * degrees_per_radian;
}

SoupStars::SoupStars(const ConstrainedTetrahedralization& mesh, std::span<const Index> facet_patch,
                     const InputCreases* creases)
    : mesh_(mesh),
      facet_patch_(facet_patch),
      creases_(creases),
      faces_at_(mesh.points.size()),
      edges_at_(mesh.points.size()) {
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (const VertexIndex v : mesh.faces[f].vertices) faces_at_[v].push_back(f);
  collect_edges();
}

Index SoupStars::patch_of(Index face) const {
  const Index facet = mesh_.faces[face].facet;
  return facet < facet_patch_.size() ? facet_patch_[facet] : facet;
}

void SoupStars::collect_edges() {
  struct Use {
    VertexIndex a, b;
    Index face, segment;
  };
  std::vector<Use> uses;
  for (Index f = 0; f < mesh_.faces.size(); ++f)
    for (unsigned k = 0; k < 3; ++k) {
      const VertexIndex a = mesh_.faces[f].vertices[k], b = mesh_.faces[f].vertices[(k + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), f, no_index});
    }
  for (const auto& e : mesh_.edges) uses.push_back({std::min(e.a, e.b), std::max(e.a, e.b), no_index, e.segment});
  std::sort(uses.begin(), uses.end(), [](const Use& x, const Use& y) {
    return std::tie(x.a, x.b, x.face, x.segment) < std::tie(y.a, y.b, y.face, y.segment);
  });
  for (std::size_t i = 0, j; i < uses.size(); i = j) {
    Index n_faces = 0;
    for (j = i; j < uses.size() && uses[j].a == uses[i].a && uses[j].b == uses[i].b; ++j)
      n_faces += uses[j].face != no_index;
    const bool is_listed = uses[j - 1].face == no_index;
    const bool is_within = !is_listed && n_faces == 2 && patch_of(uses[i].face) == patch_of(uses[i + 1].face);
    if (is_within && !is_crease(uses[i].face, uses[i + 1].face, uses[i].a, uses[i].b)) continue;
    const Index segment = is_listed ? uses[i + n_faces].segment : no_index;
    edges_at_[uses[i].a].push_back({uses[i].b, segment, uses[i].face, n_faces});
    edges_at_[uses[i].b].push_back({uses[i].a, segment, uses[i].face, n_faces});
  }
  for (auto& edges : edges_at_)
    std::sort(edges.begin(), edges.end(), [](const SoupEdge& x, const SoupEdge& y) { return x.other < y.other; });
}

bool SoupStars::is_crease(Index face, Index other, VertexIndex a, VertexIndex b) const {
  if (!creases_) return false;
  const auto apex = [&](Index f) -> const Vec3& {
    const Triangle& t = mesh_.faces[f].vertices;
    return mesh_.points[*std::find_if(t.begin(), t.end(), [&](VertexIndex v) { return v != a && v != b; })];
  };
  return creases_->has_fold(patch_of(face), mesh_.points[a], mesh_.points[b], apex(face), apex(other));
}

std::array<VertexIndex, 2> SoupStars::sides(VertexIndex v, Index face) const {
  const Triangle& t = mesh_.faces[face].vertices;
  const unsigned k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
  return {t[(k + 1) % 3], t[(k + 2) % 3]};
}

bool SoupStars::is_side(VertexIndex v, VertexIndex other) const {
  const auto& edges = edges_at_[v];
  const auto at =
      std::lower_bound(edges.begin(), edges.end(), other, [](const SoupEdge& e, VertexIndex x) { return e.other < x; });
  return at != edges.end() && at->other == other;
}

std::vector<SoupStars::Fan> SoupStars::fans(VertexIndex v) const {
  std::vector<Fan> found;
  std::vector<bool> taken(faces_at_[v].size(), false);
  for (std::size_t first = 0; first < taken.size(); ++first) {
    if (taken[first]) continue;
    taken[first] = true;
    Fan fan{patch_of(faces_at_[v][first]), {faces_at_[v][first]}};
    for (std::size_t k = 0; k < fan.faces.size(); ++k)
      for (const VertexIndex x : sides(v, fan.faces[k])) {
        if (is_side(v, x)) continue;
        for (std::size_t i = 0; i < taken.size(); ++i) {
          const auto s = sides(v, faces_at_[v][i]);
          if (taken[i] || (s[0] != x && s[1] != x)) continue;
          taken[i] = true;
          fan.faces.push_back(faces_at_[v][i]);
        }
      }
    found.push_back(std::move(fan));
  }
  return found;
}

void SoupStars::compare_edges(VertexIndex v, MeetingAngle& least) const {
  const auto& edges = edges_at_[v];
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const double degrees = angle_between(direction(v, edges[i].other), direction(v, edges[j].other));
      if (degrees < least.degrees)
        least = {degrees, facet_of(edges[i].face), facet_of(edges[j].face), edges[i].segment, edges[j].segment};
    }
}

void SoupStars::compare_edge_with_fan(VertexIndex v, const SoupEdge& edge, const Fan& fan, MeetingAngle& least) const {
  for (const Index f : fan.faces)
    if (const auto s = sides(v, f); s[0] == edge.other || s[1] == edge.other)
      return;  // the edge is a side of the facet or within it
  const Vec3 d = direction(v, edge.other);
  for (const Index f : fan.faces) {
    const auto s = sides(v, f);
    const double degrees = angle_to_sector(d, direction(v, s[0]), direction(v, s[1]));
    if (degrees < least.degrees) least = {degrees, facet_of(edge.face), facet_of(f), edge.segment, no_index};
  }
}

void SoupStars::compare_fans(VertexIndex v, const Fan& a, const Fan& b, MeetingAngle& least) const {
  for (const Index f : a.faces)
    for (const Index g : b.faces) {
      const auto s = sides(v, f), t = sides(v, g);
      for (unsigned i = 0; i < 2; ++i)
        for (unsigned j = 0; j < 2; ++j) {
          if (f == g || s[i] != t[j] || !is_side(v, s[i])) continue;
          const Vec3 along = direction(v, s[i]);
          const double degrees =
              angle_between(cross(along, direction(v, s[1 - i])), cross(along, direction(v, t[1 - j])));
          if (degrees < least.degrees) least = {degrees, facet_of(f), facet_of(g), no_index, no_index};
        }
    }
}

MeetingAngle SoupStars::least_angle(VertexIndex v) const {
  MeetingAngle least;
  compare_edges(v, least);
  const std::vector<Fan> at = fans(v);
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (const SoupEdge& e : edges_at_[v]) compare_edge_with_fan(v, e, at[i], least);
    for (std::size_t j = i; j < at.size(); ++j) compare_fans(v, at[i], at[j], least);
  }
  return least;
}

}  // namespace geomesh

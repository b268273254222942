// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/model/complex.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel::arrangement {

Projection projection_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  std::size_t k = std::fabs(n.x) >= std::fabs(n.y) ? 0 : 1;
  if (std::fabs(n.z) > std::fabs(n[k])) k = 2;
  for (std::size_t turn = 0; turn < 3; ++turn, k = (k + 1) % 3) {
    Projection frame{(k + 1) % 3, (k + 2) % 3, Sign::zero};
    frame.sign = orient2d(project(a, frame), project(b, frame), project(c, frame));
    if (frame.sign != Sign::zero) return frame;
  }
  return {};
}

void remove_repeated_segments(Complex& complex) {
  std::vector<std::array<Index, 4>> keys;
  for (Index s = 0; s < complex.segments.size(); ++s)
    keys.push_back({complex.segments[s].polyline, std::min(complex.segments[s].a, complex.segments[s].b),
                    std::max(complex.segments[s].a, complex.segments[s].b), s});
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint8_t> repeated(complex.segments.size(), 0);
  for (std::size_t k = 1; k < keys.size(); ++k)
    if (std::equal(keys[k].begin(), keys[k].begin() + 3, keys[k - 1].begin())) repeated[keys[k][3]] = 1;
  std::size_t kept = 0;
  for (std::size_t s = 0; s < complex.segments.size(); ++s) {
    if (repeated[s]) continue;
    complex.segments[kept] = complex.segments[s];
    complex.dirty_segment[kept++] = complex.dirty_segment[s];
  }
  complex.segments.resize(kept);
  complex.dirty_segment.resize(kept);
}

std::vector<Index> surfaces_of(std::span<const Origin> origins) {
  std::vector<Index> surfaces;
  for (const Origin& o : origins) surfaces.push_back(o.surface);
  std::sort(surfaces.begin(), surfaces.end());
  surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  return surfaces;
}

bool normalise_origins(std::vector<Origin>& origins) {
  std::stable_sort(origins.begin(), origins.end(), [](const Origin& a, const Origin& b) {
    return a.surface != b.surface ? a.surface < b.surface : a.triangle < b.triangle;
  });
  const auto same = [](const Origin& a, const Origin& b) { return a.surface == b.surface && a.triangle == b.triangle; };
  origins.erase(std::unique(origins.begin(), origins.end(), same), origins.end());
  const bool turned = origins.front().reversed;
  for (Origin& o : origins) o.reversed = o.reversed != turned;
  return turned;
}

Origin carried_over(Origin origin, const Triangle& from, const Triangle& to, VertexIndex a, VertexIndex b) {
  const auto goes_along = [&](const Triangle& t) {
    return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
  };
  if (goes_along(from) == goes_along(to)) origin.reversed = !origin.reversed;
  return origin;
}

void edit_origins(Complex& complex, const std::function<void(Index, std::vector<Origin>&)>& edit) {
  OriginLists edited;
  std::vector<Origin> origins;
  Index kept = 0;
  for (Index f = 0; f < complex.facets.size(); ++f) {
    origins.assign(complex.origins.of(f).begin(), complex.origins.of(f).end());
    edit(f, origins);
    if (origins.empty()) continue;
    complex.facets[kept] = complex.facets[f];
    complex.dirty_facet[kept] = complex.dirty_facet[f];
    if (normalise_origins(origins)) std::swap(complex.facets[kept][1], complex.facets[kept][2]);
    edited.push(origins);
    ++kept;
  }
  complex.facets.resize(kept);
  complex.dirty_facet.resize(kept);
  complex.origins = std::move(edited);
}

namespace {

/// Returns the facet's corners in ascending order, and whether sorting reverses its orientation.
std::pair<Triangle, bool> sorted_corners(Triangle t) {
  bool turned = false;
  for (const auto& [i, j] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{0, 1}})
    if (t[i] > t[j]) {
      std::swap(t[i], t[j]);
      turned = !turned;
    }
  return {t, turned};
}

}  // namespace

std::size_t merge_equal_facets(Complex& complex) {
  std::map<Triangle, std::vector<Index>> by_corners;
  for (Index f = 0; f < complex.facets.size(); ++f) by_corners[sorted_corners(complex.facets[f]).first].push_back(f);
  if (by_corners.size() == complex.facets.size()) return 0;
  Complex out;
  for (Index f = 0; f < complex.facets.size(); ++f) {
    const auto& [corners, turned] = sorted_corners(complex.facets[f]);
    const std::vector<Index>& equal = by_corners.at(corners);
    if (equal.front() != f) continue;
    std::vector<Origin> origins;
    std::uint8_t dirty = 0;
    for (const Index g : equal) {
      const bool reversed = sorted_corners(complex.facets[g]).second != turned;
      for (Origin o : complex.origins.of(g)) {
        o.reversed = o.reversed != reversed;
        origins.push_back(o);
      }
      dirty |= complex.dirty_facet[g];
    }
    Triangle t = complex.facets[f];
    if (normalise_origins(origins)) std::swap(t[1], t[2]);
    out.facets.push_back(t);
    out.origins.push(origins);
    out.dirty_facet.push_back(dirty);
  }
  const std::size_t n_gone = complex.facets.size() - out.facets.size();
  complex.facets = std::move(out.facets);
  complex.origins = std::move(out.origins);
  complex.dirty_facet = std::move(out.dirty_facet);
  return n_gone;
}

void drop_unused_points(Complex& complex) {
  std::vector<VertexIndex> row(complex.points.size(), no_vertex);
  const auto use = [&row](VertexIndex v) { row[v] = 0; };
  for (const Triangle& t : complex.facets) std::for_each(t.begin(), t.end(), use);
  for (const auto& s : complex.segments) {
    use(s.a);
    use(s.b);
  }
  for (const auto& p : complex.isolated_points) use(p.v);
  VertexIndex n = 0;
  for (VertexIndex v = 0; v < row.size(); ++v) {
    if (row[v] == no_vertex) continue;
    complex.points[n] = complex.points[v];
    complex.input_point[n] = complex.input_point[v];
    row[v] = n++;
  }
  complex.points.resize(n);
  complex.input_point.resize(n);
  for (Triangle& t : complex.facets)
    for (VertexIndex& v : t) v = row[v];
  for (auto& s : complex.segments) {
    s.a = row[s.a];
    s.b = row[s.b];
  }
  for (auto& p : complex.isolated_points) p.v = row[p.v];
}

double unit_in_the_last_place(const Complex& complex) {
  double largest = 0;
  for (const Vec3& p : complex.points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  return std::ldexp(1.0, std::ilogb(std::max(largest, 1e-300)) - 52);
}

double length(const Vec3& a) { return std::sqrt(dot(a, a)); }
double area(const Vec3& a, const Vec3& b, const Vec3& c) { return 0.5 * length(cross(b - a, c - a)); }

}  // namespace geomesh::geomodel::arrangement

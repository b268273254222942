// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/snap/steepen_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_set>

#include "arrangement/snap/facet_bisection.hpp"
#include "arrangement/snap/snap_search.hpp"
#include "geomesh/core/surface_distance.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

constexpr double slope = 0.035;       ///< rise over run that is made beside a curve: 2 degrees
constexpr double far_apart = 3;       ///< heights: surfaces that far apart stay
constexpr double least_cosine = 0.9;  ///< of the way to the other surface with the normal: else it is beside its border
constexpr unsigned most_bisections = 24;  ///< of a facet of 2^12 times the edges asked

bool is_of(const Complex& complex, Index facet, Index surface) {
  const auto origins = complex.origins.of(facet);
  return std::any_of(origins.begin(), origins.end(), [&](const Origin& o) { return o.surface == surface; });
}

Vec3 normal_of(const Complex& complex, Index facet) {
  const Triangle& t = complex.facets[facet];
  const Vec3& a = complex.points[t[0]];
  return cross(complex.points[t[1]] - a, complex.points[t[2]] - a);
}

/// A piece of the curve in which two surfaces cross.
using CurvePiece = std::array<Vec3, 2>;

Vec3 place_of(const Complex& complex, const Symbol& s) {
  if (s.is_point() || !s.is_line_plane()) return complex.points[s.a];
  const Vec3 &p = complex.points[s.a], &q = complex.points[s.b], n = normal_of(complex, s.c);
  const Vec3& on_plane = complex.points[complex.facets[s.c][0]];
  const double from = dot(n, p - on_plane), to = dot(n, q - on_plane);
  return from == to ? p : p + (from / (from - to)) * (q - p);
}

CurvePiece piece_of(const Complex& complex, const FacetContact& c) {
  CurvePiece piece{place_of(complex, c.ends[0]), place_of(complex, c.ends[0])};
  for (std::size_t k = 1; k < c.n_ends; ++k) {
    const Vec3 p = place_of(complex, c.ends[k]);
    if (length(p - piece[0]) > length(piece[1] - piece[0])) piece[1] = p;
  }
  return piece;
}

/// Curves of pairs of surfaces that cross at a small angle somewhere.
std::map<SurfacePair, std::vector<CurvePiece>> shallow_crossings(const Complex& complex, const Contacts& contacts,
                                                                 Index first_side) {
  std::map<SurfacePair, std::vector<CurvePiece>> curves;
  std::set<SurfacePair> shallow;
  for (const FacetContact& c : contacts.facets) {
    if (c.other == no_index) continue;
    const Vec3 n = normal_of(complex, c.facet), m = normal_of(complex, c.other);
    const bool is_shallow = length(cross(n, m)) < slope * std::abs(dot(n, m));
    for (const Origin& one : complex.origins.of(c.facet))
      for (const Origin& other : complex.origins.of(c.other)) {
        if (one.surface == other.surface || std::max(one.surface, other.surface) >= first_side) continue;
        const SurfacePair pair = surface_pair(one.surface, other.surface);
        curves[pair].push_back(piece_of(complex, c));
        if (is_shallow) shallow.insert(pair);
      }
  }
  std::erase_if(curves, [&](const auto& of) { return !shallow.contains(of.first); });
  return curves;
}

SurfaceDistance distance_to(const std::vector<CurvePiece>& curve) {
  std::vector<Vec3> points;
  std::vector<Triangle> pieces;
  for (const CurvePiece& piece : curve) {
    const auto row = static_cast<VertexIndex>(points.size());
    pieces.push_back({row, row + 1, row + 1});
    points.insert(points.end(), piece.begin(), piece.end());
  }
  return {points, pieces};
}

std::vector<Triangle> facets_of(const Complex& complex, Index surface) {
  std::vector<Triangle> facets;
  for (Index f = 0; f < complex.facets.size(); ++f)
    if (is_of(complex, f, surface)) facets.push_back(complex.facets[f]);
  return facets;
}

/// One surface of a pair, which moves off the other.
class Mover {
 public:
  Mover(Complex& complex, Index moves, Index stays, const std::vector<CurvePiece>& curve,
        const ArrangementOptions::Steepening& asked)
      : complex_(complex),
        surface_(moves),
        asked_(asked),
        to_other_(complex.points, facets_of(complex, stays)),
        to_curve_(distance_to(curve)) {}

  void split_beside_curve() {
    const double ramp = asked_.height / slope;
    const auto is_beside = [&](Index f) {
      if (!is_of(complex_, f, surface_)) return false;
      const Triangle& t = complex_.facets[f];
      double longest = 0;
      for (std::size_t k = 0; k < 3; ++k)
        longest = std::max(longest, length(complex_.points[t[k]] - complex_.points[t[(k + 1) % 3]]));
      return std::any_of(t.begin(), t.end(), [&](VertexIndex v) {
        const Vec3& p = complex_.points[v];
        const double to_curve = distance(to_curve_, p);
        // What is far from the other this near to the curve crosses it steeply.
        return to_curve < 2 * ramp + longest && distance(to_other_, p) < 2 * slope * (to_curve + longest);
      });
    };
    for (unsigned k = 0; k < most_bisections && bisect_facets(complex_, asked_.edge, is_beside); ++k) {
    }
  }

  /// `moved`: by vertex how far it was moved before.
  void move(std::vector<double>& moved, const BoxPlanes& planes, Displacement& told) {
    moved.resize(complex_.points.size(), 0);
    std::unordered_set<Vec3, PointHash> places(complex_.points.begin(), complex_.points.end());
    for (const auto& [v, normal] : own_vertices()) {
      const Vec3 p = complex_.points[v], step = step_from(p, normal, asked_.height - moved[v]);
      const Vec3 to = planes.onto(p + step, planes.of(p));
      const double way = length(to - p);
      if (!(way > 0) || !places.insert(to).second) continue;
      complex_.points[v] = to;
      moved[v] += way;
      ++told.points_moved;
      if (moved[v] > told.largest) told.largest = moved[v], told.where = to;
    }
    for (Index f = 0; f < complex_.facets.size(); ++f)
      if (is_of(complex_, f, surface_)) complex_.dirty_facet[f] = 1;
  }

 private:
  static double distance(const SurfaceDistance& to, const Vec3& p) { return length(to.closest(p) - p); }

  /// Vertices of this surface alone, with the normal there.
  std::map<VertexIndex, Vec3> own_vertices() const {
    std::map<VertexIndex, Vec3> normals;
    for (Index f = 0; f < complex_.facets.size(); ++f)
      if (is_of(complex_, f, surface_))
        for (const VertexIndex v : complex_.facets[f]) normals[v] = normals[v] + normal_of(complex_, f);
    const auto drop = [&](VertexIndex v) { normals.erase(v); };
    for (Index f = 0; f < complex_.facets.size(); ++f)
      if (complex_.origins.of(f).size() > 1 || !is_of(complex_, f, surface_))
        for (const VertexIndex v : complex_.facets[f]) drop(v);
    for (const auto& s : complex_.segments) drop(s.a), drop(s.b);
    for (const auto& p : complex_.isolated_points) drop(p.v);
    return normals;
  }

  /// Off the other, so that the height over it is as asked by the distance from the curve.
  Vec3 step_from(const Vec3& p, const Vec3& normal, double most) const {
    const double area = length(normal);
    if (!(area > 0) || !(most > 0)) return {};
    const Vec3 n = (1 / area) * normal, way = p - to_other_.closest(p);
    const double height = std::abs(dot(n, way));
    if (!(height > 0) || height < least_cosine * length(way)) return {};
    const double rest = std::clamp((far_apart - height / asked_.height) / (far_apart - 1), 0.0, 1.0);
    const double wanted = std::min(slope * distance(to_curve_, p), height + rest * asked_.height);
    const double step = std::min(wanted - height, most);
    return step > 0 ? (dot(n, way) < 0 ? -step : step) * n : Vec3{};
  }

  Complex& complex_;
  Index surface_;
  ArrangementOptions::Steepening asked_;
  SurfaceDistance to_other_, to_curve_;
};

}  // namespace

Displacement steepen_crossings(Complex& complex, const Contacts& contacts, const ArrangementOptions::Steepening& asked,
                               const Joining& volume) {
  Displacement told;
  if (!(asked.height > 0)) return told;
  const auto crossings = shallow_crossings(complex, contacts, static_cast<Index>(volume.first_side));
  const BoxPlanes planes(volume.box);
  std::vector<double> moved;
  for (const auto& [pair, curve] : crossings) {
    // The one of more facets needs less splitting.
    const std::size_t n_first = facets_of(complex, pair.first).size(),
                      n_second = facets_of(complex, pair.second).size();
    const bool moves_first = n_first > n_second;
    Mover mover(complex, moves_first ? pair.first : pair.second, moves_first ? pair.second : pair.first, curve, asked);
    mover.split_beside_curve();
    mover.move(moved, planes, told);
  }
  return told;
}

}  // namespace geomesh::geomodel::arrangement

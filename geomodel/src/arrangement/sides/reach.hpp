// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines the distance from which a surface moves to a side of the volume, or to an edge between two sides.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "arrangement/sides/side_facets.hpp"

namespace geomesh::geomodel::arrangement {

/// The distance ("reach") from which vertices and facets move to sides of the volume. A surface that runs along a side
/// within the tolerance bounds a thin unit, so it must be kept apart from the side: it moves to the side and its edges
/// only from within a twentieth of the tolerance. The same holds for vertices near a side that are not at an end of a
/// surface. All others move from within the tolerance. The complex must outlive this object and keep its facets.
class Reach {
 public:
  Reach(const Complex& complex, const Joining& joining, const SideFacets& sides, double tolerance)
      : complex_(complex), tolerance_(tolerance), least_(least_share * tolerance), sides_at_(sides.creases(joining)) {
    for (const auto& [crease, at] : sides_at_)
      for (const VertexIndex corner : {crease.first, crease.second}) creases_at_[corner].push_back(crease);
    list_facets_of_vertices(sides);
  }

  bool is_crease(const EdgeKey& e) const { return sides_at_.contains(e); }
  const std::map<EdgeKey, std::array<Index, 2>>& creases() const { return sides_at_; }

  /// Returns the distance within which a facet is moved onto the side of the volume that contains the facet `side`.
  double of_facet(Index facet, Index side) const { return follows(facet, side) ? least_ : tolerance_; }
  double of_facet(Index facet, const EdgeKey& crease) const {
    const auto& [s, t] = sides_at_.at(crease);
    return std::min(of_facet(facet, s), of_facet(facet, t));
  }
  /// Returns whether the facet's plane contains the direction of the volume's edge up to a small angle. A facet that
  /// crosses the edge plainly is thereby excluded.
  bool runs_along(Index facet, const EdgeKey& crease) const {
    const Vec3 n = normal(facet), d = complex_.points[crease.second] - complex_.points[crease.first];
    return std::fabs(dot(n, d)) < sine_of_followed * length(n) * length(d);
  }
  double of_vertex(VertexIndex v, Index side, bool is_end) const {
    return is_end ? least(v, [&](Index f) { return of_facet(f, side); }) : least_;
  }
  double of_vertex(VertexIndex v, const EdgeKey& crease) const {
    return least(v, [&](Index f) { return of_facet(f, crease); });
  }
  double of_vertex_to_corner(VertexIndex v, VertexIndex corner) const {
    double reach = tolerance_;
    for (const EdgeKey& crease : creases_at_.at(corner)) reach = std::min(reach, of_vertex(v, crease));
    return reach;
  }

 private:
  static constexpr double least_share = 0.05;  // of the tolerance
  // Largest sine of the angle between a facet and a side of the volume that counts as running along the side.
  static constexpr double sine_of_followed = 0.1;

  Vec3 normal(Index f) const {
    const Triangle& t = complex_.facets[f];
    return cross(complex_.points[t[1]] - complex_.points[t[0]], complex_.points[t[2]] - complex_.points[t[0]]);
  }
  bool follows(Index facet, Index side) const {
    const Vec3 m = normal(facet), n = normal(side);
    return length(cross(m, n)) < sine_of_followed * length(m) * length(n);
  }

  double least(VertexIndex v, auto of_facet) const {
    double reach = tolerance_;
    for (Index k = first_facet_[v]; k < first_facet_[v + std::size_t{1}]; ++k)
      reach = std::min(reach, of_facet(facets_[k]));
    return reach;
  }

  /// Lists for each vertex its facets, without those that are sides of the volume.
  void list_facets_of_vertices(const SideFacets& sides) {
    first_facet_.assign(complex_.points.size() + 1, 0);
    const auto visit = [&](auto take) {
      for (Index f = 0; f < complex_.facets.size(); ++f)
        if (!sides.is_of_side(f))
          for (const VertexIndex v : complex_.facets[f]) take(v, f);
    };
    visit([&](VertexIndex v, Index) { ++first_facet_[v + std::size_t{1}]; });
    for (std::size_t v = 1; v < first_facet_.size(); ++v) first_facet_[v] += first_facet_[v - 1];
    facets_.resize(first_facet_.back());
    std::vector<Index> next(first_facet_.begin(), first_facet_.end() - 1);
    visit([&](VertexIndex v, Index f) { facets_[next[v]++] = f; });
  }

  const Complex& complex_;
  double tolerance_, least_;
  std::map<EdgeKey, std::array<Index, 2>> sides_at_;  ///< per edge between two sides of the volume: a facet of either
  std::map<VertexIndex, std::vector<EdgeKey>> creases_at_;
  std::vector<Index> first_facet_, facets_;  ///< by vertex
};

}  // namespace geomesh::geomodel::arrangement

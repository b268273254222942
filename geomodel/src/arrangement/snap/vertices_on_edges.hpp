// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Collects vertices to insert on edges of facets, and makes vertices at places that have none.
#pragma once

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "arrangement/snap/snap.hpp"

namespace geomesh::geomodel::arrangement {

class VerticesOnEdges {
 public:
  VerticesOnEdges(const Complex& complex, double distance) : complex_(complex), distance_(distance) {}

  /// Returns the parameter (0 to 1 within the edge) of the point on the edge's line nearest to p.
  double parameter(const EdgeKey& e, const Vec3& p) const {
    const Vec3 d = point(e.second) - point(e.first);
    return dot(p - point(e.first), d) / dot(d, d);
  }
  Vec3 at(const EdgeKey& e, double t) const { return point(e.first) + t * (point(e.second) - point(e.first)); }

  /// Returns whether v is an end of the edge or inserted on it.
  bool is_on(const EdgeKey& e, VertexIndex v) const {
    if (v == e.first || v == e.second) return true;
    const auto on = on_edge_.find(e);
    return on != on_edge_.end() && std::find(on->second.begin(), on->second.end(), v) != on->second.end();
  }
  void insert(const EdgeKey& e, VertexIndex v) { on_edge_[e].push_back(v); }

  /// Returns a vertex of the edge, including inserted ones, that is closer to p than the distance, or no_vertex.
  VertexIndex nearer(const EdgeKey& e, const Vec3& p) const {
    const auto on = on_edge_.find(e);
    if (on != on_edge_.end())
      for (const VertexIndex v : on->second)
        if (length(point(v) - p) < distance_) return v;
    for (const VertexIndex v : {e.first, e.second})
      if (length(point(v) - p) < distance_) return v;
    return no_vertex;
  }

  /// Returns the vertices inserted in edges, in order along each edge.
  decltype(Insertions::on_edge) take_sorted() {
    for (auto& [edge, on] : on_edge_)
      std::sort(on.begin(), on.end(), [&, &e = edge](VertexIndex a, VertexIndex b) {
        const double s = parameter(e, point(a)), t = parameter(e, point(b));
        return s != t ? s < t : a < b;
      });
    return std::move(on_edge_);
  }

 private:
  const Vec3& point(VertexIndex v) const { return complex_.points[v]; }

  const Complex& complex_;
  double distance_;
  decltype(Insertions::on_edge) on_edge_;
};

/// Finds the vertices of a complex by their coordinates, so that no two get the same place.
class VerticesByPlace {
 public:
  explicit VerticesByPlace(Complex& complex) : complex_(complex) {}
  /// Returns the first vertex at p, making one if there is none, and whether it was made.
  std::pair<VertexIndex, bool> at(const Vec3& p) {
    for (; n_known_ < complex_.points.size(); ++n_known_)
      known_.emplace(complex_.points[n_known_], static_cast<VertexIndex>(n_known_));
    const auto [at, is_new] = known_.emplace(p, static_cast<VertexIndex>(complex_.points.size()));
    if (is_new) {
      complex_.points.push_back(p);
      complex_.input_point.push_back(no_index);
    }
    return {at->second, is_new};
  }

 private:
  Complex& complex_;
  std::unordered_map<Vec3, VertexIndex, PointHash> known_;  ///< vertices by coordinates, of the first n_known_ points
  std::size_t n_known_ = 0;
};

}  // namespace geomesh::geomodel::arrangement

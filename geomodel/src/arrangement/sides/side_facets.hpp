// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The facets of a complex that are sides of the volume, with a search by boxes.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "arrangement/join/join_surfaces.hpp"
#include "arrangement/model/complex.hpp"
#include "arrangement/search/bvh.hpp"

namespace geomesh::geomodel::arrangement {

/// Finds facets of the volume's sides. The complex must outlive this object and keep its facets. Thread-safe.
class SideFacets {
 public:
  SideFacets(const Complex& complex, const Joining& joining)
      : complex_(complex),
        is_of_side_(complex.facets.size(), 0),
        facets_(list(complex, joining, is_of_side_)),
        tree_(boxes_of(complex, facets_)) {}

  bool is_of_side(Index facet) const { return is_of_side_[facet] != 0; }
  const std::vector<Index>& all() const { return facets_; }

  /// Returns the edges between two sides of the volume, with a facet of each side.
  std::map<EdgeKey, std::array<Index, 2>> creases(const Joining& joining) const {
    struct SurfaceFacet {
      Index surface, facet;
    };
    std::map<EdgeKey, SurfaceFacet> first_at;
    std::map<EdgeKey, std::array<Index, 2>> creases;
    for (const Index f : facets_)
      for (const Origin& o : complex_.origins.of(f)) {
        if (o.surface < joining.first_side) continue;
        for (const EdgeKey& e : edges_of(complex_.facets[f])) {
          const SurfaceFacet& first = first_at.try_emplace(e, SurfaceFacet{o.surface, f}).first->second;
          if (first.surface != o.surface) creases.try_emplace(e, std::array{first.facet, f});
        }
      }
    return creases;
  }

  /// Calls visit(facet) for side facets whose bounding box comes within the distance of that of the points.
  template <class Points, class Visit>
  void visit_near(const Points& points, double distance, Visit&& visit) const {
    Box3 box;
    for (const Vec3& p : points) box.add(p);
    const Vec3 margin{distance, distance, distance};
    tree_.boxes_meeting({box.min - margin, box.max + margin}, [&](Index k) { visit(facets_[k]); });
  }

 private:
  static std::vector<Index> list(const Complex& complex, const Joining& joining,
                                 std::vector<std::uint8_t>& is_of_side) {
    std::vector<Index> facets;
    for (Index f = 0; f < complex.facets.size(); ++f)
      for (const Origin& o : complex.origins.of(f))
        if (o.surface >= joining.first_side && !is_of_side[f]) {
          is_of_side[f] = 1;
          facets.push_back(f);
        }
    return facets;
  }
  static std::vector<Box3> boxes_of(const Complex& complex, const std::vector<Index>& facets) {
    std::vector<Box3> boxes;
    for (const Index f : facets) {
      Box3& box = boxes.emplace_back();
      for (const VertexIndex v : complex.facets[f]) box.add(complex.points[v]);
    }
    return boxes;
  }

  const Complex& complex_;
  std::vector<std::uint8_t> is_of_side_;
  std::vector<Index> facets_;
  BoxTree tree_;
};

}  // namespace geomesh::geomodel::arrangement

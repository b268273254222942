// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/clip/scarps.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

// Fraction of the length of a topography's ends at a fault that may contradict that the fault is a scarp.
constexpr double least_share = 0.01;

int number(Sign sign) { return sign == Sign::zero ? 0 : sign == Sign::positive ? 1 : -1; }

using FacetsAtEdges = std::map<EdgeKey, std::vector<Index>>;

/// The facets of one fault, which the topography or the base of the model cuts.
class FaultAtEnd {
 public:
  FaultAtEnd(const Arranged& arranged, const std::vector<Index>& facets, const FacetsAtEdges& end)
      : arranged_(arranged), facets_(facets), end_(end) {
    for (const Index f : facets)
      for (const EdgeKey& e : edges_of(arranged.facets[f])) at_[e].push_back(f);
  }

  template <typename Visit>
  void visit_scarps(Visit&& visit) {
    for (const Index f : facets_) {
      if (turned_.contains(f)) continue;
      const std::vector<Index> piece = take_piece(f);
      if (is_scarp(piece))
        for (const Index g : piece) visit(g);
    }
  }

 private:
  const Vec3& point(VertexIndex v) const { return arranged_.vertices.rounded(v); }
  Sign side_of(Index facet, const Vec3& p) const {
    const Triangle& t = arranged_.facets[facet];
    return orient3d(point(t[0]), point(t[1]), point(t[2]), p);
  }
  bool goes_from(Index facet, VertexIndex a, VertexIndex b) const {
    const Triangle& t = arranged_.facets[facet];
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] == a && t[(k + 1) % 3] == b) return true;
    return false;
  }
  VertexIndex corner_beside(Index facet, const EdgeKey& e) const {
    const Triangle& t = arranged_.facets[facet];
    return *std::find_if(t.begin(), t.end(), [&](VertexIndex v) { return v != e.first && v != e.second; });
  }

  /// Returns the fault's facets connected with `first` across edges at which neither topography nor base lies, and
  /// stores the orientation of each relative to `first`.
  std::vector<Index> take_piece(Index first) {
    std::vector<Index> piece{first};
    turned_[first] = 1;
    for (std::size_t k = 0; k < piece.size(); ++k)
      for (const EdgeKey& e : edges_of(arranged_.facets[piece[k]])) {
        const std::vector<Index>& facets = at_.at(e);
        if (facets.size() != 2 || end_.contains(e)) continue;
        const Index other = facets[0] == piece[k] ? facets[1] : facets[0];
        const bool agree = goes_from(piece[k], e.first, e.second) != goes_from(other, e.first, e.second);
        if (turned_.emplace(other, agree ? turned_[piece[k]] : -turned_[piece[k]]).second) piece.push_back(other);
      }
    return piece;
  }

  /// Sums the lengths along which the topography or base ends at the piece of fault. The sums are separate for ends
  /// above and below the piece, and for each side of the piece on which the ground then lies.
  bool is_scarp(const std::vector<Index>& piece) const {
    std::array<std::array<double, 2>, 2> lengths{};
    for (const Index f : piece)
      for (const EdgeKey& e : edges_of(arranged_.facets[f])) {
        const auto ending = end_.find(e);
        if (ending == end_.end() || ending->second.size() != 1) continue;
        const Index sheet = ending->second[0];
        const int side = number(side_of(f, point(corner_beside(sheet, e)))) * turned_.at(f);
        const int above = number(side_of(sheet, point(corner_beside(f, e)))) * up_side(sheet);
        if (side == 0 || above == 0) continue;
        lengths[above < 0 ? 1 : 0][side * above < 0 ? 1 : 0] += length(point(e.second) - point(e.first));
      }
    const auto agree = [&](std::size_t ground) {
      const double other = lengths[0][1 - ground] + lengths[1][1 - ground];
      const double all = lengths[0][ground] + lengths[1][ground] + other;
      return lengths[0][ground] > 0 && lengths[1][ground] > 0 && other <= least_share * all;
    };
    return agree(0) || agree(1);
  }

  /// Returns the sign that orient3d() has for places above the facet.
  int up_side(Index facet) const {
    const Triangle& t = arranged_.facets[facet];
    const auto in_map = [&](std::size_t k) { return Vec2{point(t[k]).x, point(t[k]).y}; };
    static const int above_positive = number(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}));
    return number(orient2d(in_map(0), in_map(1), in_map(2))) * above_positive;
  }

  const Arranged& arranged_;
  const std::vector<Index>& facets_;
  const FacetsAtEdges& end_;
  FacetsAtEdges at_;
  std::map<Index, int> turned_;  ///< orientation of facets relative to the first one of their piece of fault: 1 or -1
};

}  // namespace

std::vector<std::uint8_t> scarps(const Arranged& arranged, const SurfaceList& surfaces) {
  std::vector<std::uint8_t> marks(arranged.facets.size(), 0);
  if (std::ranges::none_of(surfaces.given, &TriangulatedSurface::ends_model)) return marks;
  std::map<Index, FacetsAtEdges> ends;
  std::map<Index, std::vector<Index>> faults;
  for (Index f = 0; f < arranged.facets.size(); ++f)
    for (const Index s : surfaces_of(arranged.origins.of(f))) {
      if (surfaces[s].ends_model)
        for (const EdgeKey& e : edges_of(arranged.facets[f])) ends[s][e].push_back(f);
      else if (surfaces[s].kind == SurfaceKind::fault)
        faults[s].push_back(f);
    }
  for (const auto& [row, end] : ends)
    for (const auto& [fault, facets] : faults)
      FaultAtEnd(arranged, facets, end).visit_scarps([&](Index f) { marks[f] = 1; });
  return marks;
}

}  // namespace geomesh::geomodel::arrangement

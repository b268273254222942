// SPDX-License-Identifier: GPL-3.0-or-later
// Divides TetGen facets into connected pieces.
#include <algorithm>

#include "readers/triangles/polygon.hpp"
#include "readers/triangles/tetgen.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// The closed polygons of a TetGen facet, with the polygon that directly surrounds each.
class Nesting {
 public:
  Nesting(const std::vector<Vec3>& points, const TetgenFacet& facet, const std::vector<std::size_t>& closed)
      : points_(points), project_(largest(points, facet, closed)) {
    for (const std::size_t i : closed) {
      std::vector<Vec2> outline;
      for (const VertexIndex v : facet.polygons[i]) outline.push_back(project_(points[v]));
      outlines_.push_back(std::move(outline));
    }
    parent_.assign(outlines_.size(), none);
    for (std::size_t i = 0; i < outlines_.size(); ++i) parent_[i] = innermost_around(i);
  }

  std::size_t parent(std::size_t i) const { return parent_[i]; }
  /// Returns the innermost closed polygon of the facet with p inside or on its border; `none` if there is none.
  std::size_t innermost_at(const Vec3& p) const {
    const Vec2 q = project_(p);
    std::size_t best = none;
    for (std::size_t i = 0; i < outlines_.size(); ++i)
      if (side_of_polygon(outlines_[i], q) >= 0 && (best == none || contains(best, i))) best = i;
    return best;
  }

 private:
  static std::vector<Vec3> largest(const std::vector<Vec3>& points, const TetgenFacet& facet,
                                   const std::vector<std::size_t>& closed) {
    std::vector<Vec3> best;
    double best_area = -1;
    for (const std::size_t i : closed) {
      std::vector<Vec3> polygon;
      for (const VertexIndex v : facet.polygons[i]) polygon.push_back(points[v]);
      Vec3 area;
      for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        area = area + cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
      if (dot(area, area) > best_area) {
        best_area = dot(area, area);
        best = std::move(polygon);
      }
    }
    return best;
  }

  /// Returns whether polygon `inner` lies in polygon `outer`, by its first vertex that is not on the border of `outer`.
  bool contains(std::size_t outer, std::size_t inner) const {
    if (outer == inner) return false;
    for (const Vec2& p : outlines_[inner]) {
      const int side = side_of_polygon(outlines_[outer], p);
      if (side != 0) return side > 0;
    }
    return false;
  }

  std::size_t innermost_around(std::size_t i) const {
    std::size_t best = none;
    for (std::size_t k = 0; k < outlines_.size(); ++k)
      if (contains(k, i) && (best == none || contains(best, k))) best = k;
    return best;
  }

  const std::vector<Vec3>& points_;
  PlaneProjection project_;
  std::vector<std::vector<Vec2>> outlines_;
  std::vector<std::size_t> parent_;
};

void add_outline_as_segments(const std::vector<VertexIndex>& loop, FacetPiece& piece) {
  for (std::size_t k = 0; k < loop.size(); ++k) piece.segments.push_back({loop[k], loop[(k + 1) % loop.size()]});
}

}  // namespace

std::vector<FacetPiece> facet_pieces(const std::vector<Vec3>& points, const TetgenFacet& facet) {
  std::vector<std::size_t> closed;
  for (std::size_t i = 0; i < facet.polygons.size(); ++i)
    if (facet.polygons[i].size() >= 3) closed.push_back(i);
  if (closed.empty()) return {};
  const Nesting nesting(points, facet, closed);
  std::vector<bool> is_hole(closed.size(), false);
  for (const Vec3& h : facet.holes) {
    const std::size_t i = nesting.innermost_at(h);
    if (i != none) is_hole[i] = true;
  }
  // A closed polygon of a facet is in the connected piece of the polygon around it, unless it begins its own piece.
  std::vector<FacetPiece> pieces;
  std::vector<std::size_t> piece_of(closed.size(), none);
  std::vector<bool> known(closed.size(), false);
  auto depth_first = [&](auto&& self, std::size_t i) -> void {
    if (known[i]) return;
    known[i] = true;
    const std::size_t p = nesting.parent(i);
    if (p != none) self(self, p);
    const std::size_t around = p == none ? none : piece_of[p];
    const std::vector<VertexIndex>& loop = facet.polygons[closed[i]];
    if (is_hole[i]) {
      if (around != none) pieces[around].loops.push_back(loop);
    } else if (around == none) {
      piece_of[i] = pieces.size();
      pieces.push_back({{loop}, {}, {}});
    } else {
      piece_of[i] = around;
      add_outline_as_segments(loop, pieces[around]);
    }
  };
  for (std::size_t i = 0; i < closed.size(); ++i) depth_first(depth_first, i);
  for (const std::vector<VertexIndex>& polygon : facet.polygons) {
    if (polygon.size() >= 3 || polygon.empty()) continue;
    std::size_t at = nesting.innermost_at(points[polygon.front()]);
    if (at != none && piece_of[at] == none && polygon.size() == 2) at = nesting.innermost_at(points[polygon.back()]);
    if (at == none || piece_of[at] == none) continue;
    FacetPiece& piece = pieces[piece_of[at]];
    if (polygon.size() == 1) {
      piece.points.push_back(polygon.front());
    } else {
      piece.segments.push_back({polygon[0], polygon[1]});
    }
  }
  return pieces;
}

}  // namespace geomesh::geomodel

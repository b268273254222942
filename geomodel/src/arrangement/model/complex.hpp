// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Input and output of a round of the arrangement: triangles, wells' segments and points, each with its input origins.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "geomesh/geomodel/arrangement.hpp"

namespace geomesh::geomodel::arrangement {

inline constexpr std::size_t no_memory_bound = ~std::size_t{0};

using Origin = PolygonSoup::Origin;

/// An edge or a well's segment, given by its ends, the smaller index first.
using EdgeKey = std::pair<VertexIndex, VertexIndex>;
inline EdgeKey edge_key(VertexIndex a, VertexIndex b) { return a < b ? EdgeKey{a, b} : EdgeKey{b, a}; }
/// Returns the keys of a triangle's three edges; edge k connects corner k and the next.
inline std::array<EdgeKey, 3> edges_of(const Triangle& t) {
  return {edge_key(t[0], t[1]), edge_key(t[1], t[2]), edge_key(t[2], t[0])};
}

/// Lists of origins (input triangles), one list for each facet, stored consecutively.
struct OriginLists {
  std::vector<Origin> items;
  std::vector<Index> offsets{0};
  std::span<const Origin> of(std::size_t facet) const {
    return {items.data() + offsets[facet], items.data() + offsets[facet + 1]};
  }
  void push(std::span<const Origin> list) {
    items.insert(items.end(), list.begin(), list.end());
    offsets.push_back(static_cast<Index>(items.size()));
  }
};

/// Facets, segments and points of an arrangement round. Points are distinct; facets have area, may cross and overlap.
struct Complex {
  std::vector<Vec3> points;
  std::vector<Index> input_point;  ///< as PolygonSoup::input_point
  std::vector<Triangle> facets;
  OriginLists origins;
  std::vector<PolygonSoup::Segment> segments;
  std::vector<PolygonSoup::IsolatedPoint> isolated_points;
  /// For each facet and each segment: whether it is dirty (may cross others). Items that are not dirty do not cross.
  std::vector<std::uint8_t> dirty_facet, dirty_segment;
};

/// A facet that lost its area when its corners were rounded or merged, with the current places of its corners.
struct VanishedFacet {
  std::vector<Index> surfaces{};  ///< surfaces of the facet; only for the first one, the loss of the facet is reported
  std::array<Vec3, 3> corners{};
};

/// Ascending, each once.
std::vector<Index> surfaces_of(std::span<const Origin> origins);

/// Removes segments that occur twice because a well runs back along the same line.
void remove_repeated_segments(Complex& complex);

/// Sorts the origins (input triangles) of a facet by surface and triangle and drops repeated ones. Returns true if the
/// first origin then has the reverse orientation: all are inverted, and the caller must invert the facet.
bool normalise_origins(std::vector<Origin>& origins);

/// Calls edit(facet, origins) for each facet, to change its origins (input triangles). Facets without any origin left
/// are removed. Facets whose first origin then has the reverse orientation are inverted. O(n).
void edit_origins(Complex& complex, const std::function<void(Index, std::vector<Origin>&)>& edit);

/// Returns an origin (input triangle) of facet `from` for its neighbour `to`, oriented as its surface continues there.
Origin carried_over(Origin origin, const Triangle& from, const Triangle& to, VertexIndex a, VertexIndex b);

/// Merges facets on the same three vertices into the first of them, with the origins (input triangles) of all. Returns
/// how many were removed.
std::size_t merge_equal_facets(Complex& complex);

struct PointHash {
  std::size_t operator()(const Vec3& p) const {
    const std::hash<double> h;
    return (h(p.x) * 0x9E3779B97F4A7C15ull ^ h(p.y)) * 0xC2B2AE3D27D4EB4Full ^ h(p.z);
  }
};

/// Removes points that no facet, segment or isolated point uses; the others keep their order.
void drop_unused_points(Complex& complex);

/// A facet's plane projected along the axis in which its normal is longest in doubles; `sign` is its orientation in the
/// projection, never zero.
struct Projection {
  std::size_t i = 0, j = 1;
  Sign sign = Sign::zero;
};
inline Vec2 project(const Vec3& p, const Projection& frame) { return {p[frame.i], p[frame.j]}; }
/// Returns the projection for the plane of a, b, c. Its sign is zero only if the three points are exactly collinear.
Projection projection_of(const Vec3& a, const Vec3& b, const Vec3& c);

/// Returns the unit in the last place of the complex' largest coordinate.
double unit_in_the_last_place(const Complex& complex);

double area(const Vec3& a, const Vec3& b, const Vec3& c);
double length(const Vec3& a);

}  // namespace geomesh::geomodel::arrangement

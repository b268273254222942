// SPDX-License-Identifier: MIT
#include "geomesh/core/surface_distance.hpp"

#include <vector>

#include "search/cover_proof.hpp"

namespace geomesh {

namespace {

/// Share of the distance limit with which proofs work. The rest covers rounding errors of computed distances.
constexpr double proven_share = 1 - 1e-6;

std::vector<search::ClosestPointTrees::Item> items_of(std::span<const Vec3> points,
                                                      std::span<const Triangle> triangles) {
  std::vector<search::ClosestPointTrees::Item> items;
  items.reserve(triangles.size());
  for (const Triangle& t : triangles)
    items.push_back({{points[t[0]], points[t[1]], points[t[2]]}, 0, static_cast<Index>(items.size())});
  return items;
}

}  // namespace

struct SurfaceDistance::Search {
  search::ClosestPointTrees trees;
  std::vector<std::uint8_t> open_edges;
  search::CoverProver prover;

  Search(std::span<const Vec3> points, std::span<const Triangle> triangles)
      : trees(items_of(points, triangles), 1),
        open_edges(search::find_open_edges(trees.items())),
        prover(trees, 0, open_edges) {}
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;
};

Vec3 closest_on_triangle(const Vec3& p, const std::array<Vec3, 3>& triangle) {
  return search::closest_on_triangle(p, triangle[0], triangle[1], triangle[2]);
}

SurfaceDistance::SurfaceDistance(std::span<const Vec3> points, std::span<const Triangle> triangles)
    : search_(std::make_unique<Search>(points, triangles)) {}
SurfaceDistance::~SurfaceDistance() = default;
SurfaceDistance::SurfaceDistance(SurfaceDistance&&) noexcept = default;
SurfaceDistance& SurfaceDistance::operator=(SurfaceDistance&&) noexcept = default;

bool SurfaceDistance::empty() const { return !search_->trees.has_group(0); }

Vec3 SurfaceDistance::closest(const Vec3& p) const { return search_->trees.closest(p, 0).point; }

Index SurfaceDistance::closest_triangle(const Vec3& p) const { return search_->trees.closest(p, 0).item; }

bool SurfaceDistance::is_within(const std::array<Vec3, 3>& triangle, double limit) const {
  search_->prover.set_limit(proven_share * limit);
  return search_->prover.judge(triangle, 0).is_proven;
}

}  // namespace geomesh

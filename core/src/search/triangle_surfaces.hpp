// SPDX-License-Identifier: MIT
/// @file
/// Reference surfaces that consist of triangles, or curves that consist of line segments.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <vector>

#include "search/proven_distance.hpp"
#include "search/reference_surfaces.hpp"

namespace geomesh::search {

class TriangleSurfaces final : public ReferenceSurfaces {
 public:
  TriangleSurfaces() = default;
  /// `pieces` are triangles of surfaces, or segments of curves; `normals`, which may be missing, their unit normals.
  TriangleSurfaces(std::vector<Piece> pieces, std::size_t n_groups, std::vector<Vec3> normals = {});

  ClosestPoint closest(const Vec3& p, Index group,
                       double limit = std::numeric_limits<double>::infinity()) const override {
    return trees_.closest(p, group, limit);
  }
  Vec3 normal(Index item, const Vec3&) const override { return item < normals_.size() ? normals_[item] : Vec3{}; }
  /// O(log n + k) for n triangles of all surfaces, k of them near the given triangle.
  bool within(const Corners& triangle, Index group, double limit, Index& over) const override;
  void within(std::span<DistanceQuestion> questions) const override;
  const std::vector<Piece>& pieces() const override { return trees_.items(); }
  void visit_pieces(const Box3& box, Index group, const std::function<void(const Piece&)>& visit) const override {
    trees_.for_each_in(box, group, visit);
  }
  bool is_even(const Box3& box, Index group, double least_cosine) const override;

 private:
  struct Scratch {
    DistanceProver prover{0};
    std::vector<SheetTriangle> nearby;
    std::vector<Index> rows;  // for each triangle in `nearby`, its row among the items of trees_
  };
  ClosestPointTrees trees_;
  std::vector<std::uint8_t> open_edges_;  // mask of open edges of each triangle (find_open_edges); empty for curves
  std::vector<Vec3> normals_;
  mutable tbb::enumerable_thread_specific<Scratch> scratch_;
};

}  // namespace geomesh::search

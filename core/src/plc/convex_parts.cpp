// SPDX-License-Identifier: MIT
#include "plc/convex_parts.hpp"

#include <algorithm>

namespace geomesh {

namespace {

/// Stores polygons as rings of triangle corners: the edge that begins at corner c ends where that of next_[c] begins.
class PartFinder {
 public:
  explicit PartFinder(const FlatPatch& patch)
      : patch_(patch), n_corners_(3 * patch.n_triangles()), is_left_out_(n_corners_, false) {
    for (Index c = 0; c < n_corners_; ++c) {
      next_.push_back(c % 3 == 2 ? c - 2 : c + 1);
      previous_.push_back(c % 3 == 0 ? c + 2 : c - 1);
    }
  }

  std::vector<ConvexPart> run(std::vector<FlatPatch::Edge> segments) {
    for (FlatPatch::Edge& s : segments) std::sort(s.begin(), s.end());
    std::sort(segments.begin(), segments.end());
    for (Index c = 0; c < n_corners_; ++c) {
      const Index d = patch_.opposite(c);
      if (d == no_index || d < c) continue;
      const FlatPatch::Edge edge{std::min(patch_.vertex(c), patch_.vertex(d)),
                                 std::max(patch_.vertex(c), patch_.vertex(d))};
      if (!std::binary_search(segments.begin(), segments.end(), edge)) leave_out(c, d);
    }
    std::vector<ConvexPart> out;
    std::vector<bool> is_done(patch_.n_triangles(), false);
    for (Index t = 0; t < patch_.n_triangles(); ++t)
      if (!is_done[t]) out.push_back(part_about(t, is_done));
    return out;
  }

 private:
  /// Returns whether the angle at the vertex of corner c is convex without the edge whose two sides are c and d.
  bool stays_convex(Index c, Index d) const {
    const VertexIndex before = patch_.vertex(previous_[c]), after = patch_.vertex(next_[next_[d]]);
    return before != after && patch_.turn(before, patch_.vertex(c), after) != Sign::negative;
  }
  void leave_out(Index c, Index d) {
    if (!stays_convex(c, d) || !stays_convex(d, c)) return;
    is_left_out_[c] = is_left_out_[d] = true;
    link(previous_[c], next_[d]);
    link(previous_[d], next_[c]);
  }
  void link(Index c, Index d) {
    next_[c] = d;
    previous_[d] = c;
  }

  ConvexPart part_about(Index triangle, std::vector<bool>& is_done) const {
    ConvexPart out;
    out.triangles = {triangle};
    is_done[triangle] = true;
    Index first = no_index;
    for (std::size_t i = 0; i < out.triangles.size(); ++i)
      for (Index c = 3 * out.triangles[i]; c < 3 * out.triangles[i] + 3; ++c) {
        const Index d = patch_.opposite(c);
        if (!is_left_out_[c]) {
          first = std::min(first, c);
          continue;
        }
        if (c < d) out.left_out.push_back({patch_.vertex(c), patch_.vertex(d), apex(c), apex(d)});
        if (is_done[d / 3]) continue;
        is_done[d / 3] = true;
        out.triangles.push_back(d / 3);
      }
    std::sort(out.triangles.begin(), out.triangles.end());
    Index c = first;
    do {
      out.border.push_back(patch_.vertex(c));
      c = next_[c];
    } while (c != first);
    return out;
  }
  VertexIndex apex(Index corner) const { return patch_.vertex(corner % 3 == 0 ? corner + 2 : corner - 1); }

  const FlatPatch& patch_;
  Index n_corners_;
  std::vector<bool> is_left_out_;
  std::vector<Index> next_, previous_;
};

}  // namespace

std::vector<ConvexPart> convex_parts(const FlatPatch& patch, std::span<const FlatPatch::Edge> segments) {
  return PartFinder(patch).run({segments.begin(), segments.end()});
}

}  // namespace geomesh

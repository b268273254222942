// SPDX-License-Identifier: MIT
#include "search/proven_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "common/geometry.hpp"

namespace geomesh::search {

namespace {

constexpr std::size_t most_pieces = 100;
constexpr double least_piece = 1.0 / 16;  ///< of the limit

/// Returns the edge that two triangles share, found by equal corners; for line segments, their common end twice.
std::optional<std::array<Vec3, 2>> common_edge(const Corners& x, const Corners& y) {
  std::array<Vec3, 2> edge;
  std::size_t n = 0;
  for (const Vec3& p : x)
    if (n < 2 && std::find(y.begin(), y.end(), p) != y.end()) edge[n++] = p;
  const bool is_line = x[1] == x[2];
  if (n == 1 && is_line) edge[n++] = edge[0];
  return n == 2 ? std::optional(edge) : std::nullopt;
}

}  // namespace

DistanceProver::Spot DistanceProver::spot(const Vec3& p, Index row) const {
  const Vec3 q = set_[row].triangle->closest_to(p);
  return {distance(p, q), q};
}

bool DistanceProver::is_within(const Corners& triangle, std::span<const Corners> set) {
  std::vector<ClosestPointTrees::Item> items;
  for (const Corners& corners : set) items.push_back({corners, 0, 0});
  const std::vector<PreparedTriangle> prepared(set.begin(), set.end());
  const std::vector<std::uint8_t> open = find_open_edges(items);
  std::vector<SheetTriangle> rows;
  for (std::size_t i = 0; i < set.size(); ++i) rows.push_back({&prepared[i], open[i]});
  return is_within(triangle, rows);
}

bool DistanceProver::is_within(const Corners& triangle, std::span<const SheetTriangle> set) {
  set_ = set;
  candidates_.clear();
  centres_.clear();
  n_pieces_ = 0;
  for (Index row = 0; row < set.size(); ++row) candidates_.push_back({row, {}});
  const Range all{0, candidates_.size()};
  sheet_row_ = find_sheet(triangle, all);
  if (sheet_row_ != no_index) return true;
  for (Candidate& c : candidates_)
    c.at = {spot(triangle[0], c.row), spot(triangle[1], c.row), spot(triangle[2], c.row)};
  centres_.resize(candidates_.size());
  return !has_corner_beyond(all) && covers(triangle, all);
}

bool DistanceProver::has_corner_beyond(Range range) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::none_of(candidates_.begin() + range.first, candidates_.begin() + range.last,
                     [&](const Candidate& c) { return c.at[k].distance <= limit_; }))
      return true;
  return false;
}

bool DistanceProver::by_one_triangle(Range range) const {
  return std::any_of(candidates_.begin() + range.first, candidates_.begin() + range.last, [&](const Candidate& c) {
    return c.at[0].distance <= limit_ && c.at[1].distance <= limit_ && c.at[2].distance <= limit_;
  });
}

bool DistanceProver::by_pair(const Candidate& x, const Candidate& y, std::size_t corner_at_y) const {
  const std::size_t i = (corner_at_y + 1) % 3, j = (corner_at_y + 2) % 3;
  const double off = std::max({y.at[corner_at_y].distance, x.at[i].distance, x.at[j].distance});
  if (off > limit_) return false;
  const auto edge = common_edge(set_[x.row].triangle->corners(), set_[y.row].triangle->corners());
  if (!edge) return false;
  for (const std::size_t k : {i, j}) {
    const auto [p, q] = closest_on_segments(x.at[k].point, y.at[corner_at_y].point, (*edge)[0], (*edge)[1]);
    if (off + distance(p, q) > limit_) return false;
  }
  return true;
}

bool DistanceProver::by_two_triangles(Range range) {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    by_two_.clear();
    for (std::size_t j = range.first; j < range.last; ++j) {
      const auto& at = candidates_[j].at;
      if (at[(corner + 1) % 3].distance <= limit_ && at[(corner + 2) % 3].distance <= limit_) by_two_.push_back(j);
    }
    for (std::size_t i = range.first; i < range.last && !by_two_.empty(); ++i)
      if (candidates_[i].at[corner].distance <= limit_)
        for (const std::size_t j : by_two_)
          if (i != j && by_pair(candidates_[j], candidates_[i], corner)) return true;
  }
  return false;
}

Index DistanceProver::find_sheet(const Corners& piece, Range range) const {
  SheetProof proof(piece, limit_);
  if (!proof.is_possible()) return no_index;
  Index row = no_index;
  for (std::size_t k = range.first; k < range.last; ++k) {
    if (proof.judge(set_[candidates_[k].row]) == Over::border) return no_index;
    if (row == no_index && proof.is_proven()) row = candidates_[k].row;
  }
  return row;
}

bool DistanceProver::covers(const Corners& piece, Range range) {
  std::size_t longest_at = 0;
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (const double l = distance(piece[i], piece[(i + 1) % 3]); l > longest) longest = l, longest_at = i;
  const std::size_t a = longest_at, b = (a + 1) % 3, c = (a + 2) % 3;
  const Vec3 centre = 0.5 * (piece[a] + piece[b]);
  const double radius = std::max(0.5 * longest, distance(centre, piece[c]));
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = range.first; k < range.last; ++k) {
    centres_[k] = spot(centre, candidates_[k].row);
    nearest = std::min(nearest, centres_[k].distance);
  }
  if (nearest + radius <= limit_) return true;
  if (nearest > limit_) return false;
  if (by_one_triangle(range) || (n_pieces_ > 0 && find_sheet(piece, range) != no_index) || by_two_triangles(range))
    return true;
  if (longest <= least_piece * limit_ || ++n_pieces_ >= most_pieces) return false;
  for (const std::size_t replaced : {b, a}) {
    Corners corners = piece;
    corners[replaced] = centre;
    candidates_.resize(range.last);
    centres_.resize(range.last);
    for (std::size_t k = range.first; k < range.last; ++k) {
      if (centres_[k].distance > limit_ + radius) continue;
      Candidate kept = candidates_[k];
      kept.at[replaced] = centres_[k];
      candidates_.push_back(kept);
      centres_.push_back({});
    }
    if (!covers(corners, {range.last, candidates_.size()})) return false;
  }
  return true;
}

}  // namespace geomesh::search

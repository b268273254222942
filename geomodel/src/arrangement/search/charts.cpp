// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/search/charts.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "arrangement/model/separation.hpp"
#include "common/parallel.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

/// The three neighbours of each facet, beyond its edges k (from corner k to corner k+1). A neighbour is stored as 4 *
/// facet + edge; no_index if the edge does not have exactly two facets.
using Neighbours = std::vector<std::array<Index, 3>>;

constexpr Index facet_of(Index side) { return side / 4; }
constexpr Index edge_of(Index side) { return side % 4; }

Neighbours find_neighbours(const Complex& complex) {
  struct EdgeUse {
    VertexIndex other;
    Index side;
  };
  const std::size_t n = complex.facets.size();
  std::vector<Index> begin(complex.points.size() + 2, 0);
  for (const Triangle& t : complex.facets)
    for (std::size_t k = 0; k < 3; ++k) ++begin[std::min(t[k], t[(k + 1) % 3]) + 2];
  for (std::size_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<EdgeUse> sides(3 * n);
  for (Index f = 0; f < n; ++f)
    for (Index k = 0; k < 3; ++k) {
      const VertexIndex a = complex.facets[f][k], b = complex.facets[f][(k + 1) % 3];
      sides[begin[std::min(a, b) + 1]++] = {std::max(a, b), 4 * f + k};
    }
  Neighbours neighbours(n, {no_index, no_index, no_index});
  parallel_for(complex.points.size(), [&](std::size_t v) {
    const std::span<EdgeUse> at(sides.data() + begin[v], sides.data() + begin[v + 1]);
    std::sort(at.begin(), at.end(), [](const EdgeUse& a, const EdgeUse& b) {
      return a.other != b.other ? a.other < b.other : a.side < b.side;
    });
    for (std::size_t k = 0, end; k < at.size(); k = end) {
      for (end = k + 1; end < at.size() && at[end].other == at[k].other;) ++end;
      if (end != k + 2) continue;
      neighbours[facet_of(at[k].side)][edge_of(at[k].side)] = at[k + 1].side;
      neighbours[facet_of(at[k + 1].side)][edge_of(at[k + 1].side)] = at[k].side;
    }
  });
  return neighbours;
}

struct View {
  std::size_t axis;
  /// Smallest cosine of the angle between the projection axis and the normal of a facet that may join the chart.
  double least_cosine;
};

/// Finds charts among the facets begin .. end - 1, and numbers them from 0 in the order of their least facet indices.
class ChartFinder {
 public:
  ChartFinder(const Complex& complex, const Neighbours& neighbours, Index begin, Index end,
              std::vector<Index>& chart_of)
      : complex_(complex),
        neighbours_(neighbours),
        begin_(begin),
        end_(end),
        chart_of_(chart_of),
        turn_(end - begin, 0) {}

  Index run() {
    // A wide cone of normals gives few charts; parts that overlap themselves in projection are divided with a narrow
    // one.
    for (const double least_cosine : {0.25, 0.6}) {
      visited_.assign(end_ - begin_, 0);
      for (Index f = begin_; f < end_; ++f)
        if (chart_of_[f] == no_index && !visited_[f - begin_]) try_chart(f, least_cosine);
    }
    return n_charts_;
  }

 private:
  /// Smallest number of facets of a chart. For fewer, proving that they do not cross takes longer than testing pairs.
  static constexpr std::size_t least_facets = 24;

  void try_chart(Index seed, double least_cosine) {
    const Vec3 n = normal(seed);
    std::size_t axis = std::fabs(n.x) >= std::fabs(n.y) ? 0 : 1;
    if (std::fabs(n.z) > std::fabs(n[axis])) axis = 2;
    flood(seed, {axis, least_cosine});
    if (facets_.size() >= least_facets && winds_at_most_once(complex_.points, axis, border())) {
      for (const Index f : facets_) chart_of_[f] = n_charts_;
      ++n_charts_;
    }
    for (const Index f : facets_) turn_[f - begin_] = 0;
  }

  Vec3 normal(Index f) const {
    const auto& [a, b, c] = complex_.facets[f];
    return cross(complex_.points[b] - complex_.points[a], complex_.points[c] - complex_.points[a]);
  }

  /// Returns the facet's orientation in the projection, or 0 if it is too steep or its sign is not proven by doubles.
  int turn_as_seen(Index f, const View& view) const {
    const Vec3 n = normal(f);
    if (!(n[view.axis] * n[view.axis] >= view.least_cosine * view.least_cosine * dot(n, n))) return 0;
    const std::size_t i = (view.axis + 1) % 3, j = (view.axis + 2) % 3;
    const auto flat = [&](VertexIndex v) { return Vec2{complex_.points[v][i], complex_.points[v][j]}; };
    const Triangle& t = complex_.facets[f];
    return proven_turn(flat(t[0]), flat(t[1]), flat(t[2]));
  }

  bool is_within(Index f) const { return f >= begin_ && f < end_ && chart_of_[f] == no_index && !visited_[f - begin_]; }

  /// Returns edge k of facet f, in the direction in which the chart lies on its left.
  BorderEdge directed(Index f, std::size_t k) const {
    const Triangle& t = complex_.facets[f];
    const VertexIndex a = t[k], b = t[(k + 1) % 3];
    return turn_[f - begin_] > 0 ? BorderEdge{a, b} : BorderEdge{b, a};
  }

  void flood(Index seed, const View& view) {
    facets_.clear();
    visited_[seed - begin_] = 1;
    turn_[seed - begin_] = static_cast<std::int8_t>(turn_as_seen(seed, view));
    if (turn_[seed - begin_] == 0) return;
    facets_.push_back(seed);
    for (std::size_t next = 0; next < facets_.size(); ++next)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index beyond = neighbours_[facets_[next]][k];
        if (beyond == no_index || !is_within(facet_of(beyond))) continue;
        const Index g = facet_of(beyond);
        const int turn = turn_as_seen(g, view);
        if (turn == 0) continue;
        turn_[g - begin_] = static_cast<std::int8_t>(turn);
        // The surface folds over at the edge between the two facets, so the chart ends there.
        if (directed(g, edge_of(beyond)).from == directed(facets_[next], k).from) {
          turn_[g - begin_] = 0;
          continue;
        }
        visited_[g - begin_] = 1;
        facets_.push_back(g);
      }
  }

  std::vector<BorderEdge> border() const {
    std::vector<BorderEdge> edges;
    for (const Index f : facets_)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index beyond = neighbours_[f][k];
        const Index g = beyond == no_index ? no_index : facet_of(beyond);
        const bool inner = g != no_index && g >= begin_ && g < end_ && turn_[g - begin_] != 0 &&
                           directed(g, edge_of(beyond)).from != directed(f, k).from;
        if (!inner) edges.push_back(directed(f, k));
      }
    return edges;
  }

  const Complex& complex_;
  const Neighbours& neighbours_;
  Index begin_, end_;
  std::vector<Index>& chart_of_;
  /// For each facet of the current chart: its orientation in the projection; 0 for other facets.
  std::vector<std::int8_t> turn_;
  /// For each facet: whether it was added to a chart or tried as a seed in the current pass.
  std::vector<std::uint8_t> visited_;
  std::vector<Index> facets_;
  Index n_charts_ = 0;
};

/// Returns the first facet of each run of consecutive facets of one surface, followed by the number of facets.
std::vector<Index> surface_runs(const Complex& complex) {
  std::vector<Index> runs;
  for (Index f = 0; f < complex.facets.size(); ++f)
    if (f == 0 || complex.origins.of(f)[0].surface != complex.origins.of(f - 1)[0].surface) runs.push_back(f);
  runs.push_back(static_cast<Index>(complex.facets.size()));
  return runs;
}

}  // namespace

std::vector<Index> find_charts(const Complex& complex) {
  const Neighbours neighbours = find_neighbours(complex);
  const std::vector<Index> runs = surface_runs(complex);
  std::vector<Index> chart_of(complex.facets.size(), no_index), n_charts(runs.size() - 1, 0);
  parallel_for(n_charts.size(), [&](std::size_t r) {
    n_charts[r] = ChartFinder(complex, neighbours, runs[r], runs[r + 1], chart_of).run();
  });
  Index first = 0;
  for (std::size_t r = 0; r < n_charts.size(); ++r) {
    for (Index f = runs[r]; f < runs[r + 1]; ++f)
      if (chart_of[f] != no_index) chart_of[f] += first;
    first += n_charts[r];
  }
  return chart_of;
}

}  // namespace geomesh::geomodel::arrangement

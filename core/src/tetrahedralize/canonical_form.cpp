// SPDX-License-Identifier: MIT
#include "tetrahedralize/canonical_form.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

#include "mesh/spatial_order.hpp"
#include "tetrahedralize/canonical_frame.hpp"

namespace geomesh {

namespace {

using Loop = std::vector<VertexIndex>;

std::vector<VertexIndex> used_vertices(const PiecewiseLinearComplex& plc) {
  std::vector<std::uint8_t> is_used(plc.points.size(), 0);
  for (const VertexIndex v : plc.loop_vertices) is_used[v] = 1;
  for (const auto& s : plc.facet_segments) is_used[s.a] = is_used[s.b] = 1;
  for (const auto& p : plc.facet_points) is_used[p.v] = 1;
  for (const auto& s : plc.segments) is_used[s.a] = is_used[s.b] = 1;
  for (const VertexIndex v : plc.isolated_points) is_used[v] = 1;
  std::vector<VertexIndex> used;
  for (VertexIndex v = 0; v < is_used.size(); ++v)
    if (is_used[v]) used.push_back(v);
  return used;
}

/// Rotates the loop to its smallest vertex and directs it towards the smaller neighbour; if a vertex occurs more than
/// once, chooses the least of all sequences. Returns whether it was reversed.
bool begin_at_least(std::span<VertexIndex> loop) {
  const auto least = std::min_element(loop.begin(), loop.end());
  if (std::count(least, loop.end(), *least) == 1) {
    std::rotate(loop.begin(), least, loop.end());
    if (loop[1] < loop.back()) return false;
    std::reverse(loop.begin() + 1, loop.end());
    return true;
  }
  const Loop given(loop.begin(), loop.end()), backwards(given.rbegin(), given.rend());
  bool is_reversed = false;
  for (const Loop* way : {&given, &backwards})
    for (std::size_t start = 0; start < given.size(); ++start) {
      Loop turned = *way;
      std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start), turned.end());
      if (!std::lexicographical_compare(turned.begin(), turned.end(), loop.begin(), loop.end())) continue;
      std::copy(turned.begin(), turned.end(), loop.begin());
      is_reversed = way == &backwards;
    }
  return is_reversed;
}

/// The loops of a complex with renumbered vertices, each from its smallest vertex, and the order of facets by them.
class TurnedLoops {
 public:
  /// `local` contains the number in the canonical form of each point of the complex.
  TurnedLoops(const PiecewiseLinearComplex& plc, const std::vector<VertexIndex>& local) : plc_(plc) {
    turned_.reserve(plc.loop_vertices.size());
    for (const VertexIndex v : plc.loop_vertices) turned_.push_back(local[v]);
    is_reversed_.resize(plc.n_facets());
    for (Index f = 0; f < plc.n_facets(); ++f)
      for (Index l = plc.facet_loops[f]; l < plc.facet_loops[f + 1]; ++l) {
        const bool is_reversed =
            begin_at_least({turned_.data() + plc.loop_offsets[l], turned_.data() + plc.loop_offsets[l + 1]});
        if (l == plc.facet_loops[f]) is_reversed_[f] = is_reversed;
      }
  }

  std::size_t n_vertices() const { return turned_.size(); }
  bool is_reversed(Index f) const { return is_reversed_[f]; }
  /// Returns the vertex with the smallest index of the facet's outer loop.
  VertexIndex first(Index f) const { return turned_[plc_.loop_offsets[plc_.facet_loops[f]]]; }
  std::span<const VertexIndex> outer(Index f) const { return loop(plc_.facet_loops[f]); }
  /// Returns the outer loop of facet f, followed by its holes in ascending order.
  std::vector<std::span<const VertexIndex>> ordered_loops(Index f) const {
    std::vector<std::span<const VertexIndex>> loops;
    for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l) loops.push_back(loop(l));
    std::sort(loops.begin() + 1, loops.end(), is_less);
    return loops;
  }
  /// Returns whether facet f comes before g. Facets are ordered by outer loop, holes, and the caller's number.
  bool is_before(Index f, Index g) const {
    const auto a = outer(f), b = outer(g);
    if (is_less(a, b)) return true;
    if (is_less(b, a)) return false;
    if (plc_.n_loops(f) > 1 || plc_.n_loops(g) > 1) {
      const auto holes_a = ordered_loops(f), holes_b = ordered_loops(g);
      if (std::lexicographical_compare(holes_a.begin(), holes_a.end(), holes_b.begin(), holes_b.end(), is_less))
        return true;
      if (std::lexicographical_compare(holes_b.begin(), holes_b.end(), holes_a.begin(), holes_a.end(), is_less))
        return false;
    }
    return f < g;
  }

 private:
  std::span<const VertexIndex> loop(Index l) const {
    return {turned_.data() + plc_.loop_offsets[l], turned_.data() + plc_.loop_offsets[l + 1]};
  }
  static bool is_less(std::span<const VertexIndex> a, std::span<const VertexIndex> b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }

  const PiecewiseLinearComplex& plc_;
  std::vector<VertexIndex> turned_;        ///< as plc_.loop_vertices
  std::vector<std::uint8_t> is_reversed_;  ///< per facet
};

/// Builds the complex with vertices, facets and segments in the canonical order.
class Builder {
 public:
  explicit Builder(const PiecewiseLinearComplex& plc) : plc_(plc) {}

  CanonicalForm run() {
    number_vertices();
    const TurnedLoops loops(plc_, local_);
    number_facets(loops);
    add_facets(loops);
    add_inner_items();
    add_segments();
    for (const VertexIndex v : plc_.isolated_points) out_.plc.isolated_points.push_back(local_[v]);
    std::sort(out_.plc.isolated_points.begin(), out_.plc.isolated_points.end());
    add_seeds(plc_.region_seeds, out_.plc.region_seeds);
    add_seeds(plc_.hole_seeds, out_.plc.hole_seeds);
    return std::move(out_);
  }

 private:
  void number_vertices() {
    std::vector<VertexIndex> used = used_vertices(plc_);
    const AxisFrame frame = out_.names.frame = canonical_frame(plc_, used);
    std::vector<Vec3> points;
    points.reserve(used.size());
    for (const VertexIndex v : used) points.push_back(frame.enter(plc_.points[v]));
    local_.assign(plc_.points.size(), no_vertex);
    out_.plc.points.reserve(used.size());
    out_.names.vertex.reserve(used.size());
    for (const VertexIndex i : hilbert_order(points)) {
      local_[used[i]] = static_cast<VertexIndex>(out_.plc.points.size());
      out_.plc.points.push_back(points[i]);
      out_.names.vertex.push_back(used[i]);
    }
  }

  /// Sorts the facets by their first vertex in one pass, then the few facets with the same first vertex.
  void number_facets(const TurnedLoops& loops) {
    std::vector<Index> begin(out_.plc.points.size() + 1, 0);
    for (Index f = 0; f < plc_.n_facets(); ++f) ++begin[loops.first(f) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index>& order = out_.names.facet;
    order.resize(plc_.n_facets());
    std::vector<Index> next(begin.begin(), begin.end() - 1);
    for (Index f = 0; f < plc_.n_facets(); ++f) order[next[loops.first(f)]++] = f;
    for (std::size_t v = 0; v + 1 < begin.size(); ++v)
      std::sort(order.begin() + begin[v], order.begin() + begin[v + 1],
                [&](Index f, Index g) { return loops.is_before(f, g); });
    row_of_facet_.resize(order.size());
    for (Index row = 0; row < order.size(); ++row) row_of_facet_[order[row]] = row;
  }

  void add_facets(const TurnedLoops& loops) {
    PiecewiseLinearComplex& out = out_.plc;
    out.loop_vertices.reserve(loops.n_vertices());
    out.loop_offsets.reserve(plc_.loop_offsets.size());
    out.facet_loops.reserve(plc_.facet_loops.size());
    const auto add_loop = [&](std::span<const VertexIndex> loop) {
      out.loop_vertices.insert(out.loop_vertices.end(), loop.begin(), loop.end());
      out.loop_offsets.push_back(static_cast<Index>(out.loop_vertices.size()));
    };
    for (const Index f : out_.names.facet) {
      if (plc_.n_loops(f) == 1)
        add_loop(loops.outer(f));
      else
        for (const auto& loop : loops.ordered_loops(f)) add_loop(loop);
      out.facet_loops.push_back(static_cast<Index>(out.loop_offsets.size() - 1));
      out_.names.facet_is_reversed.push_back(loops.is_reversed(f));
    }
    out.facet_provenance.assign(plc_.n_facets(), no_index);
  }

  void add_inner_items() {
    for (const auto& s : plc_.facet_segments)
      out_.plc.facet_segments.push_back(
          {row_of_facet_[s.facet], std::min(local_[s.a], local_[s.b]), std::max(local_[s.a], local_[s.b])});
    std::sort(out_.plc.facet_segments.begin(), out_.plc.facet_segments.end(),
              [](const auto& s, const auto& t) { return std::tie(s.facet, s.a, s.b) < std::tie(t.facet, t.a, t.b); });
    for (const auto& p : plc_.facet_points) out_.plc.facet_points.push_back({row_of_facet_[p.facet], local_[p.v]});
    std::sort(out_.plc.facet_points.begin(), out_.plc.facet_points.end(),
              [](const auto& p, const auto& q) { return std::tie(p.facet, p.v) < std::tie(q.facet, q.v); });
  }

  void add_segments() {
    std::vector<Index>& order = out_.names.segment;
    order.resize(plc_.segments.size());
    std::iota(order.begin(), order.end(), Index{0});
    const auto ends = [&](Index s) { return std::minmax(local_[plc_.segments[s].a], local_[plc_.segments[s].b]); };
    std::stable_sort(order.begin(), order.end(), [&](Index s, Index t) {
      const std::pair<VertexIndex, VertexIndex> a = ends(s), b = ends(t);
      return a < b;
    });
    for (const Index s : order) {
      const auto [a, b] = std::minmax({local_[plc_.segments[s].a], local_[plc_.segments[s].b]});
      out_.plc.segments.push_back({a, b, plc_.segments[s].curve});
      out_.names.segment_is_reversed.push_back(a != local_[plc_.segments[s].a]);
    }
  }

  void add_seeds(const std::vector<PiecewiseLinearComplex::Seed>& from,
                 std::vector<PiecewiseLinearComplex::Seed>& to) const {
    for (const auto& seed : from) to.push_back({out_.names.frame.enter(seed.point), seed.id});
  }

  const PiecewiseLinearComplex& plc_;
  CanonicalForm out_;
  std::vector<VertexIndex> local_;   ///< number in the canonical form of each of the caller's points
  std::vector<Index> row_of_facet_;  ///< row in the canonical form of each of the caller's facets
};

}  // namespace

CanonicalForm canonical_form(const PiecewiseLinearComplex& plc) { return Builder(plc).run(); }

std::vector<Index> provenance_of(const PiecewiseLinearComplex& plc, const ModelNames& names) {
  std::vector<Index> out;
  for (const Index f : names.facet) out.push_back(plc.facet_provenance[f]);
  return out;
}

}  // namespace geomesh

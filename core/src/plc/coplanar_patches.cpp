// SPDX-License-Identifier: MIT
#include "plc/coplanar_patches.hpp"

#include <algorithm>
#include <numeric>

#include "geomesh/core/predicates.hpp"

namespace geomesh {

namespace {

/// A facet, segment or inner segment at an edge; `facet` is no_index for all that is no plain triangle.
struct EdgeUse {
  VertexIndex a, b;  ///< a < b
  Index facet;
  VertexIndex apex;
  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

/// Lists the facets and segments at each edge of a complex.
class EdgeUses {
 public:
  explicit EdgeUses(const PiecewiseLinearComplex& plc) : plc_(plc) { list_uses(); }

  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    for (std::size_t i = 0, j = 0; i < uses_.size(); i = j) {
      while (j < uses_.size() && uses_[j].a == uses_[i].a && uses_[j].b == uses_[i].b) ++j;
      visit(std::span<const EdgeUse>(uses_.data() + i, j - i));
    }
  }

 private:
  void list_uses() {
    has_inner_items_.assign(plc_.n_facets(), false);
    for (const auto& s : plc_.facet_segments) has_inner_items_[s.facet] = true;
    for (const auto& p : plc_.facet_points) has_inner_items_[p.facet] = true;
    std::vector<EdgeUse> uses;
    uses.reserve(plc_.loop_vertices.size() + plc_.segments.size() + plc_.facet_segments.size());
    const auto add_use = [&uses](VertexIndex a, VertexIndex b, Index facet, VertexIndex apex) {
      uses.push_back({std::min(a, b), std::max(a, b), facet, apex});
    };
    for (Index f = 0; f < plc_.n_facets(); ++f)
      for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l) {
        const auto loop = plc_.loop(l);
        const std::size_t n = loop.size();
        for (std::size_t i = 0; i < n; ++i)
          add_use(loop[i], loop[(i + 1) % n], is_triangle(f) ? f : no_index, loop[(i + 2) % n]);
      }
    for (const auto& s : plc_.segments) add_use(s.a, s.b, no_index, no_vertex);
    for (const auto& s : plc_.facet_segments) add_use(s.a, s.b, no_index, no_vertex);
    sort(uses);
  }
  /// By the first end at one go, then the few of each.
  void sort(const std::vector<EdgeUse>& uses) {
    std::vector<Index> begin(plc_.points.size() + 1, 0);
    for (const EdgeUse& use : uses) ++begin[use.a + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> end = begin;
    uses_.resize(uses.size());
    for (const EdgeUse& use : uses) uses_[end[use.a]++] = use;
    for (std::size_t v = 0; v < plc_.points.size(); ++v)
      std::sort(uses_.begin() + begin[v], uses_.begin() + begin[v + 1]);
  }
  bool is_triangle(Index f) const {
    return plc_.n_loops(f) == 1 && plc_.outer_loop(f).size() == 3 && !has_inner_items_[f];
  }

  const PiecewiseLinearComplex& plc_;
  std::vector<bool> has_inner_items_;
  std::vector<EdgeUse> uses_;  ///< sorted
};

/// Whether nothing but two coplanar triangles of one surface lie at an edge. `provenance`: by facet.
bool is_inside_patch(const PiecewiseLinearComplex& plc, std::span<const Index> provenance,
                     std::span<const EdgeUse> uses) {
  if (uses.size() != 2 || uses[0].facet == no_index || uses[1].facet == no_index) return false;
  if (provenance[uses[0].facet] != provenance[uses[1].facet]) return false;
  const auto& p = plc.points;
  return orient3d(p[uses[0].a], p[uses[0].b], p[uses[0].apex], p[uses[1].apex]) == Sign::zero;
}

/// Finds patches by uniting the two triangles at each edge inside a patch.
class PatchFinder {
 public:
  PatchFinder(const PiecewiseLinearComplex& plc, std::span<const Index> provenance)
      : plc_(plc), provenance_(provenance), edges_(plc), patch_(plc.n_facets()) {
    std::iota(patch_.begin(), patch_.end(), Index{0});
    edges_.for_each_edge([&](std::span<const EdgeUse> uses) {
      if (!is_inside_patch(plc_, provenance_, uses)) return;
      unite(uses[0].facet, uses[1].facet);
      inner_edges_.push_back({uses[0].a, uses[0].b, uses[0].apex, uses[1].apex});
      facet_of_inner_edge_.push_back(uses[0].facet);
    });
  }

  /// All patches together decide.
  bool are_far_from_delaunay(double most_crossings) {
    std::vector<Index> begin(plc_.n_facets() + 1, 0);
    for (Index& f : facet_of_inner_edge_) ++begin[(f = find(f)) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> first = begin;
    first.erase(std::unique(first.begin(), first.end()), first.end());
    std::vector<InnerEdge> by_patch(inner_edges_.size());
    for (std::size_t i = 0; i < by_patch.size(); ++i) by_patch[begin[facet_of_inner_edge_[i]]++] = inner_edges_[i];
    return geomesh::are_far_from_delaunay(plc_.points, by_patch, first, most_crossings);
  }

  std::vector<CoplanarPatch> patches() {
    gather_patches();
    edges_.for_each_edge([&](std::span<const EdgeUse> uses) { note_segments(uses); });
    return std::move(patches_);
  }

 private:
  Index find(Index f) {
    while (patch_[f] != f) f = patch_[f] = patch_[patch_[f]];
    return f;
  }
  void unite(Index f, Index g) {
    f = find(f);
    g = find(g);
    patch_[std::max(f, g)] = std::min(f, g);
  }

  void gather_patches() {
    row_.assign(plc_.n_facets(), no_index);
    for (Index f = 0; f < plc_.n_facets(); ++f) {
      const Index first = find(f);
      if (first == f) {
        row_[f] = static_cast<Index>(patches_.size());
        patches_.emplace_back();
      }
      patches_[row_[first]].facets.push_back(f);
    }
  }

  /// Keeps an edge inside a patch as a segment if anything else lies at it.
  void note_segments(std::span<const EdgeUse> uses) {
    if (uses.size() == 2 && is_inside_patch(plc_, provenance_, uses)) return;
    for (std::size_t i = 0; i < uses.size(); ++i)
      for (std::size_t j = i + 1; j < uses.size(); ++j)
        if (uses[j].facet != no_index && find(uses[i].facet) == find(uses[j].facet))
          patches_[row_[find(uses[i].facet)]].segments.push_back({uses[i].a, uses[i].b});
  }

  const PiecewiseLinearComplex& plc_;
  std::span<const Index> provenance_;
  EdgeUses edges_;
  std::vector<Index> patch_;  ///< union-find over facets
  std::vector<Index> row_;    ///< in patches_, by first facet
  std::vector<CoplanarPatch> patches_;
  std::vector<InnerEdge> inner_edges_;      ///< of all patches
  std::vector<Index> facet_of_inner_edge_;  ///< one of the two
};

}  // namespace

std::vector<CoplanarPatch> patches_far_from_delaunay(const PiecewiseLinearComplex& plc,
                                                     std::span<const Index> provenance, double most_crossings) {
  PatchFinder finder(plc, provenance);
  return finder.are_far_from_delaunay(most_crossings) ? finder.patches() : std::vector<CoplanarPatch>{};
}

std::optional<FlatPatch> flat_patch_of(const PiecewiseLinearComplex& plc, std::span<const Index> facets) {
  std::vector<Triangle> triangles;
  for (const Index f : facets) {
    const auto loop = plc.outer_loop(f);
    triangles.push_back({loop[0], loop[1], loop[2]});
  }
  return FlatPatch::of(plc.points, std::move(triangles));
}

}  // namespace geomesh

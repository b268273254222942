// SPDX-License-Identifier: MIT
#include "plc/coplanar_patches.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "geomesh/core/predicates.hpp"

namespace geomesh {

namespace {

/// An item of the complex at an edge; `facet` is no_index unless it is a triangular facet with nothing inside.
struct EdgeUse {
  VertexIndex a, b;  ///< a < b
  Index facet;
  VertexIndex apex;
  /// Returns a sort key of the use of edge a-b by an item: uses with equal a are sorted by b, then by facet.
  std::uint64_t order() const { return std::uint64_t{b} << 32 | facet; }
};

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
    // Sorts the uses of edges by facets by the edge's smaller vertex in one pass, then the few uses of each vertex.
    std::vector<Index> end(plc_.points.size() + 2, 0);
    for_each_use([&](VertexIndex a, VertexIndex b, Index, VertexIndex) { ++end[std::min(a, b) + 2]; });
    std::partial_sum(end.begin(), end.end(), end.begin());
    uses_.resize(end.back());
    for_each_use([&](VertexIndex a, VertexIndex b, Index facet, VertexIndex apex) {
      uses_[end[std::min(a, b) + 1]++] = {std::min(a, b), std::max(a, b), facet, apex};
    });
    for (std::size_t v = 0; v < plc_.points.size(); ++v)
      std::sort(uses_.begin() + end[v], uses_.begin() + end[v + 1],
                [](const EdgeUse& x, const EdgeUse& y) { return x.order() < y.order(); });
  }
  template <class Visit>
  void for_each_use(const Visit& visit) const {
    for (Index f = 0; f < plc_.n_facets(); ++f) {
      const Index facet = is_triangle(f) ? f : no_index;
      for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l) {
        const auto loop = plc_.loop(l);
        VertexIndex a = loop[loop.size() - 2], b = loop.back();
        for (const VertexIndex next : loop) {
          visit(a, b, facet, next);
          a = b;
          b = next;
        }
      }
    }
    for (const auto& s : plc_.segments) visit(s.a, s.b, no_index, no_vertex);
    for (const auto& s : plc_.facet_segments) visit(s.a, s.b, no_index, no_vertex);
  }
  bool is_triangle(Index f) const {
    return plc_.n_loops(f) == 1 && plc_.outer_loop(f).size() == 3 && !has_inner_items_[f];
  }

  const PiecewiseLinearComplex& plc_;
  std::vector<bool> has_inner_items_;
  std::vector<EdgeUse> uses_;  ///< sorted
};

/// Returns whether four points are coplanar. For sides of boxes and horizontal surfaces no determinant is needed.
bool are_coplanar(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a[i] == b[i] && a[i] == c[i] && a[i] == d[i]) return true;
  return orient3d(a, b, c, d) == Sign::zero;
}

/// Returns whether only two coplanar triangles of one surface meet at an edge. `provenance` has an entry per facet.
bool is_inside_patch(const PiecewiseLinearComplex& plc, std::span<const Index> provenance,
                     std::span<const EdgeUse> uses) {
  if (uses.size() != 2 || uses[0].facet == no_index || uses[1].facet == no_index) return false;
  if (provenance[uses[0].facet] != provenance[uses[1].facet]) return false;
  const auto& p = plc.points;
  return are_coplanar(p[uses[0].a], p[uses[0].b], p[uses[0].apex], p[uses[1].apex]);
}

/// Finds patches of coplanar triangles by uniting the two triangles at each edge inside a patch.
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

  /// Returns whether the triangulations of all plane patches, taken together, are far from Delaunay.
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

  /// Makes an edge inside a patch a segment if another facet or segment shares the edge.
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
  std::vector<Index> row_;    ///< for each facet that is the first of its patch, the patch's row in patches_
  std::vector<CoplanarPatch> patches_;
  std::vector<InnerEdge> inner_edges_;      ///< of all patches
  std::vector<Index> facet_of_inner_edge_;  ///< for each of inner_edges_, one of the two facets at the edge
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

// SPDX-License-Identifier: MIT
#include "plc/coplanar_facets.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "geomesh/core/predicates.hpp"
#include "plc/flat_patch.hpp"
#include "plc/patch_crossings.hpp"

namespace geomesh {

namespace {

/// A facet, segment or inner segment at an edge; `facet` is no_index for all that is no plain triangle.
struct Use {
  VertexIndex a, b;  ///< a < b
  Index facet;
  VertexIndex apex;
  friend auto operator<=>(const Use&, const Use&) = default;
};

/// Lists the facets and segments at each edge of a complex.
class EdgeUses {
 public:
  explicit EdgeUses(const PiecewiseLinearComplex& plc) : plc_(plc) { list_uses(); }

  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    for (std::size_t i = 0, j = 0; i < uses_.size(); i = j) {
      while (j < uses_.size() && uses_[j].a == uses_[i].a && uses_[j].b == uses_[i].b) ++j;
      visit(std::span<const Use>(uses_.data() + i, j - i));
    }
  }

 private:
  void list_uses() {
    has_inner_items_.assign(plc_.n_facets(), false);
    for (const auto& s : plc_.facet_segments) has_inner_items_[s.facet] = true;
    for (const auto& p : plc_.facet_points) has_inner_items_[p.facet] = true;
    std::vector<Use> uses;
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
  void sort(const std::vector<Use>& uses) {
    std::vector<Index> begin(plc_.points.size() + 1, 0);
    for (const Use& use : uses) ++begin[use.a + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> end = begin;
    uses_.resize(uses.size());
    for (const Use& use : uses) uses_[end[use.a]++] = use;
    for (std::size_t v = 0; v < plc_.points.size(); ++v)
      std::sort(uses_.begin() + begin[v], uses_.begin() + begin[v + 1]);
  }
  bool is_triangle(Index f) const {
    return plc_.n_loops(f) == 1 && plc_.outer_loop(f).size() == 3 && !has_inner_items_[f];
  }

  const PiecewiseLinearComplex& plc_;
  std::vector<bool> has_inner_items_;
  std::vector<Use> uses_;  ///< sorted
};

class Merger {
 public:
  Merger(const PiecewiseLinearComplex& plc, std::span<const Index> provenance, double most_crossings)
      : plc_(plc), provenance_(provenance), most_crossings_(most_crossings), edges_(plc), patch_(plc.n_facets()) {
    std::iota(patch_.begin(), patch_.end(), Index{0});
  }

  MergedFacets run() {
    edges_.for_each_edge([&](std::span<const Use> uses) {
      if (!is_inside_patch(uses)) return;
      unite(uses[0].facet, uses[1].facet);
      inner_edges_.push_back({uses[0].a, uses[0].b, uses[0].apex, uses[1].apex});
      facet_of_inner_edge_.push_back(uses[0].facet);
    });
    if (!are_far_from_delaunay()) return {};
    gather_patches();
    edges_.for_each_edge([&](std::span<const Use> uses) { note_segments(uses); });
    write();
    return std::move(out_);
  }

 private:
  struct Patch {
    std::vector<Index> facets;
    std::vector<FlatPatch::Edge> segments;
  };

  /// Nothing but two coplanar triangles of one surface lie at the edge.
  bool is_inside_patch(std::span<const Use> uses) const {
    if (uses.size() != 2 || uses[0].facet == no_index || uses[1].facet == no_index) return false;
    if (provenance_[uses[0].facet] != provenance_[uses[1].facet]) return false;
    const auto& p = plc_.points;
    return orient3d(p[uses[0].a], p[uses[0].b], p[uses[0].apex], p[uses[1].apex]) == Sign::zero;
  }

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
  void note_segments(std::span<const Use> uses) {
    if (uses.size() == 2 && is_inside_patch(uses)) return;
    for (std::size_t i = 0; i < uses.size(); ++i)
      for (std::size_t j = i + 1; j < uses.size(); ++j)
        if (uses[j].facet != no_index && find(uses[i].facet) == find(uses[j].facet))
          patches_[row_[find(uses[i].facet)]].segments.push_back({uses[i].a, uses[i].b});
  }

  void write() {
    out_.plc = plc_;
    out_.plc.loop_vertices.clear();
    out_.plc.loop_offsets.assign(1, 0);
    out_.plc.facet_loops.assign(1, 0);
    out_.plc.facet_provenance.clear();
    out_.plc.facet_segments.clear();
    out_.plc.facet_points.clear();
    for (const Patch& patch : patches_) {
      if (patch.facets.size() > 1 && write_polygon(patch)) continue;
      for (const Index f : patch.facets) write_as_is(f);
    }
    copy_inner_items();
  }

  std::optional<FlatPatch> flat(const Patch& patch) const {
    std::vector<Triangle> triangles;
    for (const Index f : patch.facets) {
      const auto loop = plc_.outer_loop(f);
      triangles.push_back({loop[0], loop[1], loop[2]});
    }
    return FlatPatch::of(plc_.points, std::move(triangles));
  }

  /// All patches together decide.
  bool are_far_from_delaunay() {
    std::vector<Index> begin(plc_.n_facets() + 1, 0);
    for (Index& f : facet_of_inner_edge_) ++begin[(f = find(f)) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> first = begin;
    first.erase(std::unique(first.begin(), first.end()), first.end());
    std::vector<InnerEdge> by_patch(inner_edges_.size());
    for (std::size_t i = 0; i < by_patch.size(); ++i) by_patch[begin[facet_of_inner_edge_[i]]++] = inner_edges_[i];
    return geomesh::are_far_from_delaunay(plc_.points, by_patch, first, most_crossings_);
  }

  bool write_polygon(const Patch& patch) {
    const std::optional<FlatPatch> flat_patch = flat(patch);
    if (!flat_patch) return false;
    const FacetPolygon polygon = flat_patch->polygon(patch.segments);
    FacetFault fault;
    const auto draft = triangulate_facet(plc_.points, polygon, fault);
    if (!draft || !draft->exactly_planar) return false;
    const Index m = out_.plc.add_polygon(polygon.loops);
    for (const auto& [a, b] : polygon.segments) out_.plc.facet_segments.push_back({m, a, b});
    for (const VertexIndex v : polygon.inner_points) out_.plc.facet_points.push_back({m, v});
    out_.members.insert(out_.members.end(), patch.facets.begin(), patch.facets.end());
    out_.first.push_back(static_cast<Index>(out_.members.size()));
    return true;
  }

  void write_as_is(Index f) {
    std::vector<std::vector<VertexIndex>> loops;
    for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l)
      loops.emplace_back(plc_.loop(l).begin(), plc_.loop(l).end());
    if (new_row_.empty()) new_row_.assign(plc_.n_facets(), no_index);
    new_row_[f] = out_.plc.add_polygon(loops);
    out_.members.push_back(f);
    out_.first.push_back(static_cast<Index>(out_.members.size()));
  }

  void copy_inner_items() {
    for (const auto& s : plc_.facet_segments) out_.plc.facet_segments.push_back({new_row_[s.facet], s.a, s.b});
    for (const auto& p : plc_.facet_points) out_.plc.facet_points.push_back({new_row_[p.facet], p.v});
  }

  const PiecewiseLinearComplex& plc_;
  std::span<const Index> provenance_;
  double most_crossings_;
  EdgeUses edges_;
  std::vector<Index> patch_;  ///< union-find over facets
  std::vector<Index> row_;    ///< in patches_, by first facet
  std::vector<Patch> patches_;
  std::vector<InnerEdge> inner_edges_;      ///< of all patches
  std::vector<Index> facet_of_inner_edge_;  ///< one of the two
  std::vector<Index> new_row_;              ///< facets that are kept as they are
  MergedFacets out_;
};

}  // namespace

MergedFacets merge_coplanar_facets(const PiecewiseLinearComplex& plc, std::span<const Index> provenance,
                                   double most_crossings) {
  return Merger(plc, provenance, most_crossings).run();
}

}  // namespace geomesh

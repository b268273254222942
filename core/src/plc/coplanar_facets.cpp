// SPDX-License-Identifier: MIT
#include "plc/coplanar_facets.hpp"

#include <algorithm>
#include <optional>

#include "plc/coplanar_patches.hpp"

namespace geomesh {

namespace {

class Merger {
 public:
  Merger(const PiecewiseLinearComplex& plc, std::span<const Index> provenance, double most_crossings)
      : plc_(plc), patches_(patches_far_from_delaunay(plc, provenance, most_crossings)) {}

  MergedFacets run() {
    if (patches_.empty()) return {};
    write();
    return std::move(out_);
  }

 private:
  void write() {
    out_.plc = plc_;
    out_.plc.loop_vertices.clear();
    out_.plc.loop_offsets.assign(1, 0);
    out_.plc.facet_loops.assign(1, 0);
    out_.plc.facet_provenance.clear();
    out_.plc.facet_segments.clear();
    out_.plc.facet_points.clear();
    for (const CoplanarPatch& patch : patches_) {
      if (patch.facets.size() > 1 && write_polygon(patch)) continue;
      for (const Index f : patch.facets) write_as_is(f);
    }
    copy_inner_items();
  }

  bool write_polygon(const CoplanarPatch& patch) {
    const std::optional<FlatPatch> flat_patch = flat_patch_of(plc_, patch.facets);
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
  const std::vector<CoplanarPatch> patches_;
  std::vector<Index> new_row_;  ///< row in the merged complex of each facet that is kept unchanged
  MergedFacets out_;
};

}  // namespace

MergedFacets merge_coplanar_facets(const PiecewiseLinearComplex& plc, std::span<const Index> provenance,
                                   double most_crossings) {
  return Merger(plc, provenance, most_crossings).run();
}

}  // namespace geomesh

// SPDX-License-Identifier: MIT
#include "remesh/driver/keep_there.hpp"

#include <algorithm>

#include "search/closest_point.hpp"

namespace geomesh::remesh {

namespace {

using Item = search::ClosestPointTrees::Item;

/// What does not hold, as boxes.
std::vector<Box3> places_off(const Attempt& attempt, double reach) {
  std::vector<Box3> boxes;
  const Vec3 about{reach, reach, reach};
  for (const Breach& b : attempt.breaches) boxes.push_back({b.place - about, b.place + about});
  for (const TightZone& zone : attempt.crossings) boxes.push_back({zone.box.min - about, zone.box.max + about});
  return boxes;
}

bool overlap(const Box3& a, const Box3& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a.min[i] > b.max[i] || b.min[i] > a.max[i]) return false;
  return true;
}

/// Fans of the facets' outer loops, by facet.
search::ClosestPointTrees facet_triangles(const PiecewiseLinearComplex& plc) {
  std::vector<Item> items;
  for (Index f = 0; f < plc.n_facets(); ++f) {
    const auto loop = plc.outer_loop(f);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      items.push_back({{plc.points[loop[0]], plc.points[loop[i]], plc.points[loop[i + 1]]}, 0, f});
  }
  return {std::move(items), 1};
}

}  // namespace

std::vector<KeptPlace> keep_there(const PiecewiseLinearComplex& plc, const Attempt& attempt, RefineOptions& options) {
  const std::vector<Box3> boxes = places_off(attempt, 2 * options.tolerance);
  const search::ClosestPointTrees facets = facet_triangles(plc);
  std::vector<Index> n_of_patch, near;
  for (const Index p : options.facet_patch) {
    if (p >= n_of_patch.size()) n_of_patch.resize(p + 1, 0);
    ++n_of_patch[p];
  }
  std::vector<KeptPlace> kept;
  for (const Box3& box : boxes)
    facets.for_each_in(box, 0, [&](const Item& item) {
      if (n_of_patch[options.facet_patch[item.id]] < 2) return;
      Box3 of_item;
      for (const Vec3& p : item.corners) of_item.add(p);
      if (!overlap(of_item, box)) return;
      near.push_back(item.id);
      kept.push_back({0.5 * (box.min + box.max), item.id});
    });
  std::stable_sort(kept.begin(), kept.end(), [](const KeptPlace& a, const KeptPlace& b) { return a.facet < b.facet; });
  kept.erase(
      std::unique(kept.begin(), kept.end(), [](const KeptPlace& a, const KeptPlace& b) { return a.facet == b.facet; }),
      kept.end());
  for (const KeptPlace& k : kept) {
    const Index before = options.facet_patch[k.facet], own = static_cast<Index>(n_of_patch.size());
    --n_of_patch[before];
    n_of_patch.push_back(1);
    options.facet_patch[k.facet] = own;
    if (!options.facet_parent.empty()) options.facet_parent[k.facet] = no_index;  // no piece of another
    if (before < options.size.patch_size.size()) {
      options.size.patch_size.resize(own + 1);
      options.size.patch_size[own] = options.size.patch_size[before];
    }
  }
  for (Index s = 0; s < options.segment_curve.size(); ++s) {
    Box3 of_segment;
    of_segment.add(plc.points[plc.segments[s].a]);
    of_segment.add(plc.points[plc.segments[s].b]);
    if (std::any_of(boxes.begin(), boxes.end(), [&](const Box3& box) { return overlap(of_segment, box); }))
      options.segment_curve[s] = no_index;
  }
  return kept;
}

}  // namespace geomesh::remesh

// SPDX-License-Identifier: MIT
#include "remesh/driver/hold_surfaces.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>

#include "remesh/operations/surface_repair.hpp"

namespace geomesh::remesh {

Deviations hold_to_tolerance(Toolbox& tools, const RunContext& context) {
  constexpr unsigned most_rounds = 8;
  VerifiedSurfaces verified;
  Deviations found = tools.guard.deviations(tools.mesh, context.threads, &verified);
  std::size_t n_before = std::numeric_limits<std::size_t>::max();
  for (unsigned round = 0; round < most_rounds && !found.breaches.empty(); ++round) {
    context.check_cancelled();
    // Vertices are moved only as long as the number of places outside the tolerance falls. Otherwise a vertex could
    // alternate between two places that it has to cover.
    const MendBy by = found.breaches.size() < n_before ? MendBy::moves_and_splits : MendBy::splits;
    n_before = found.breaches.size();
    if (mend_surfaces(tools, found.breaches, by) == 0) break;
    found = tools.guard.deviations(tools.mesh, context.threads, &verified);
  }
  return found;
}

namespace {

using Item = search::ClosestPointTrees::Item;

bool overlap(const Box3& a, const Box3& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a.min[i] > b.max[i] || b.min[i] > a.max[i]) return false;
  return true;
}

Box3 grown(const Box3& box, double reach) {
  const Vec3 about{reach, reach, reach};
  return {box.min - about, box.max + about};
}

Vec3 centre(const Box3& box) { return 0.5 * (box.min + box.max); }

template <class Points>
Box3 box_of(const Points& points) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  return box;
}

std::string place_words(const Vec3& p) {
  char text[120];
  std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g)", p.x, p.y, p.z);
  return text;
}

std::string breach_words(const Breach& b) {
  return std::string(b.on_curve ? "a curve" : "a triangle") + (b.of_input ? " of the input" : " of the result") +
         " is not proven to be within the tolerance, " + place_words(b.place);
}

/// Returns a search tree of triangles: the outer loop of each facet, divided into a fan. An item's id is its facet.
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

void tighten(Hold& hold, const Attempt& attempt, double tolerance) {
  constexpr double closer = 0.65, closer_in_zones = 0.25, about_zones = 4;
  if (!attempt.breaches.empty() || hold.run > 1) hold.margin *= closer;
  const std::size_t n_before = hold.zones.size();
  for (TightZone zone : attempt.crossings) {
    zone.tolerance = tolerance;
    for (std::size_t k = 0; k < n_before; ++k)
      if (overlap(hold.zones[k].box, zone.box)) zone.tolerance = std::min(zone.tolerance, hold.zones[k].tolerance);
    hold.zones.push_back({grown(zone.box, about_zones * tolerance), closer_in_zones * zone.tolerance});
  }
  ++hold.run;
}

std::vector<KeptPlace> keep_there(const PiecewiseLinearComplex& plc, const Attempt& attempt, RefineOptions& options) {
  std::vector<Box3> boxes;  // boxes around the places that are not within the tolerance
  for (const Breach& b : attempt.breaches) boxes.push_back(grown({b.place, b.place}, 2 * options.tolerance));
  for (const TightZone& zone : attempt.crossings) boxes.push_back(grown(zone.box, 2 * options.tolerance));
  std::vector<Index> n_of_patch;
  for (const Index p : options.facet_patch) {
    if (p >= n_of_patch.size()) n_of_patch.resize(p + 1, 0);
    ++n_of_patch[p];
  }
  const search::ClosestPointTrees facets = facet_triangles(plc);
  std::vector<KeptPlace> kept;
  for (const Box3& box : boxes)
    facets.for_each_in(box, 0, [&](const Item& item) {
      if (n_of_patch[options.facet_patch[item.id]] > 1 && overlap(box_of(item.corners), box))
        kept.push_back({centre(box), item.id});
    });
  std::ranges::stable_sort(kept, {}, &KeptPlace::facet);
  const auto is_same = [](const KeptPlace& a, const KeptPlace& b) { return a.facet == b.facet; };
  kept.erase(std::unique(kept.begin(), kept.end(), is_same), kept.end());
  for (const KeptPlace& k : kept) {
    const Index before = options.facet_patch[k.facet], own = static_cast<Index>(n_of_patch.size());
    --n_of_patch[before];
    n_of_patch.push_back(1);
    options.facet_patch[k.facet] = own;
    if (!options.facet_parent.empty()) options.facet_parent[k.facet] = no_index;  // the facet is not merged with others
    if (before < options.size.patch_size.size()) {
      options.size.patch_size.resize(own + 1);
      options.size.patch_size[own] = options.size.patch_size[before];
    }
  }
  for (Index s = 0; s < options.segment_curve.size(); ++s) {
    const Box3 segment = box_of(std::array{plc.points[plc.segments[s].a], plc.points[plc.segments[s].b]});
    if (std::ranges::any_of(boxes, [&](const Box3& box) { return overlap(segment, box); }))
      options.segment_curve[s] = no_index;
  }
  return kept;
}

void tell_what_is_off(const Attempt& attempt, const RunContext& context) {
  constexpr std::size_t most = 20;
  context.note(LogLevel::info, "surfaces are not as promised in " +
                                   std::to_string(attempt.breaches.size() + attempt.crossings.size()) +
                                   " places: held more closely and refined again");
  for (std::size_t i = 0; i < std::min(most, attempt.breaches.size()); ++i)
    context.note(LogLevel::debug, breach_words(attempt.breaches[i]));
  for (std::size_t i = 0; i < std::min(most, attempt.crossings.size()); ++i)
    context.note(LogLevel::debug,
                 "surfaces cross through the outside at " + place_words(centre(attempt.crossings[i].box)));
}

}  // namespace geomesh::remesh

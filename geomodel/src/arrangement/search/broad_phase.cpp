// SPDX-License-Identifier: GPL-3.0-or-later
// Finds pairs of facets that may meet, declared in arrangement/model/contacts.hpp.

#include <algorithm>
#include <atomic>
#include <thread>

#include "arrangement/model/contacts.hpp"
#include "arrangement/model/memory_bound.hpp"
#include "arrangement/search/bvh.hpp"
#include "arrangement/search/charts.hpp"
#include "common/parallel.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

Box3 box_of(const Complex& complex, Index facet) {
  Box3 box;
  for (const VertexIndex v : complex.facets[facet]) box.add(complex.points[v]);
  return box;
}
Box3 box_of_segment(const Complex& complex, Index segment) {
  Box3 box;
  box.add(complex.points[complex.segments[segment].a]);
  box.add(complex.points[complex.segments[segment].b]);
  return box;
}

std::vector<Box3> boxes_of(const Complex& complex, const std::vector<Index>& facets) {
  std::vector<Box3> boxes(facets.size());
  parallel_for(facets.size(), [&](std::size_t i) { boxes[i] = box_of(complex, facets[i]); });
  return boxes;
}

/// A complex in which pairs of facets that may meet are sought, the run that may be cancelled, and a memory limit.
struct Limits {
  const Complex& complex;
  const RunContext& context;
  MemoryUse& memory;
};

/// Runs body(i, out) for i in [0, n) in fixed chunks and concatenates the results in the order of the chunks.
template <typename Body>
void collect(std::size_t n, std::size_t chunk, Contacts& all, const Limits& limits, Body&& body) {
  const auto& [complex, context, memory] = limits;
  const auto place_of = [&complex = complex](const Contacts& c) {
    return c.facets.empty() ? Vec3{} : complex.points[complex.facets[c.facets.back().facet][0]];
  };
  const std::size_t n_chunks = (n + chunk - 1) / chunk;
  std::vector<Contacts> found(n_chunks);
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<std::size_t> n_chunks_done{0};
  parallel_for(n_chunks, [&, &context = context, &memory = memory](std::size_t c) {
    if (context.cancel && context.cancel->load(std::memory_order_relaxed)) return;
    const std::size_t done = n_chunks_done.fetch_add(1, std::memory_order_relaxed);
    if (std::this_thread::get_id() == caller) context.report(done * chunk, n);
    for (std::size_t i = c * chunk; i < std::min((c + 1) * chunk, n); ++i) {
      const std::size_t before = found[c].size();
      body(i, found[c]);
      if (found[c].size() > before) memory.take(found[c].size() - before, MemoryUse::per_contact, place_of(found[c]));
    }
  });
  context.check_cancelled();
  for (const Contacts& part : found) all.append(part);
}

/// Returns all dirty facets (to be tested) and those whose boxes meet a dirty one's; all facets if most are dirty.
std::vector<Index> facets_to_test(const Complex& complex) {
  std::vector<Index> dirty, result;
  for (Index f = 0; f < complex.facets.size(); ++f)
    if (complex.dirty_facet[f]) dirty.push_back(f);
  if (dirty.size() == complex.facets.size()) return dirty;
  const BoxTree tree(boxes_of(complex, dirty));
  std::vector<std::uint8_t> near(complex.facets.size(), 0);
  parallel_for(complex.facets.size(), [&](std::size_t f) {
    near[f] = complex.dirty_facet[f];
    if (!near[f]) tree.boxes_meeting(box_of(complex, static_cast<Index>(f)), [&](Index) { near[f] = 1; });
  });
  for (Index f = 0; f < complex.facets.size(); ++f)
    if (near[f]) result.push_back(f);
  return result;
}

void find_facet_contacts(const Limits& limits, Contacts& all) {
  const Complex& complex = limits.complex;
  const std::vector<Index> tested = facets_to_test(complex);
  std::vector<Index> charts;
  if (tested.size() == complex.facets.size()) charts = find_charts(complex);
  const BoxTree tree(boxes_of(complex, tested), charts);
  collect(tree.n_leaves(), 128, all, limits, [&](std::size_t leaf, Contacts& out) {
    tree.pairs_of_leaf(leaf, [&](Index i, Index j) {
      const Index a = std::min(tested[i], tested[j]), b = std::max(tested[i], tested[j]);
      if (!complex.dirty_facet[a] && !complex.dirty_facet[b]) return;
      ++out.n_pairs;
      facet_facet_contact(complex, a, b, out);
    });
  });
}

void find_well_contacts(const Limits& limits, Contacts& all) {
  const Complex& complex = limits.complex;
  if (complex.segments.empty() && complex.isolated_points.empty()) return;
  std::vector<Index> facets(complex.facets.size());
  for (Index f = 0; f < facets.size(); ++f) facets[f] = f;
  const BoxTree facet_tree(boxes_of(complex, facets));
  std::vector<Box3> segment_boxes;
  for (Index s = 0; s < complex.segments.size(); ++s) segment_boxes.push_back(box_of_segment(complex, s));
  const BoxTree segment_tree(segment_boxes);
  collect(complex.segments.size(), 64, all, limits, [&](std::size_t i, Contacts& out) {
    const auto s = static_cast<Index>(i);
    facet_tree.boxes_meeting(segment_boxes[s], [&](Index f) {
      if (complex.dirty_segment[s] || complex.dirty_facet[f]) segment_facet_contact(complex, s, f, out);
    });
    segment_tree.boxes_meeting(segment_boxes[s], [&](Index t) {
      if (s < t && (complex.dirty_segment[s] || complex.dirty_segment[t])) segment_segment_contact(complex, s, t, out);
    });
  });
  collect(complex.isolated_points.size(), 64, all, limits, [&](std::size_t i, Contacts& out) {
    const VertexIndex v = complex.isolated_points[i].v;
    Box3 place;
    place.add(complex.points[v]);
    facet_tree.boxes_meeting(place, [&](Index f) { point_facet_contact(complex, v, f, out); });
    segment_tree.boxes_meeting(place, [&](Index s) { point_segment_contact(complex, v, s, out); });
  });
}

template <typename T>
void sort_unique(std::vector<T>& items) {
  parallel_sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace

Contacts find_contacts(const Complex& complex, const RunContext& context, std::size_t max_bytes) {
  Contacts all;
  MemoryUse memory(max_bytes);
  const Limits limits{complex, context, memory};
  find_facet_contacts(limits, all);
  find_well_contacts(limits, all);
  sort_unique(all.facets);
  sort_unique(all.segments);
  sort_unique(all.overlaps);
  return all;
}

}  // namespace geomesh::geomodel::arrangement

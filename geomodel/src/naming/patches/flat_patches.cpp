// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/patches/flat_patches.hpp"

#include <set>

#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel {

namespace {

bool runs_from(const Triangle& t, VertexIndex a, VertexIndex b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (t[i] == a && t[(i + 1) % 3] == b) return true;
  return false;
}

/// Returns whether all corners of the facets agree exactly in one coordinate.
bool is_axis_aligned(const PolygonSoup& soup, const std::vector<Index>& facets) {
  const Vec3& first = soup.points[soup.facets[facets.front()][0]];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bool same = true;
    for (Index f : facets)
      for (VertexIndex v : soup.facets[f]) same = same && soup.points[v][axis] == first[axis];
    if (same) return true;
  }
  return false;
}

struct Border {
  std::map<VertexIndex, VertexIndex> next;  ///< by border vertex: the next one, with the patch on the left
  bool simple = true;  ///< whether no point of the border occurs twice and all facets have one orientation
  std::vector<std::pair<VertexIndex, VertexIndex>> segments;
};

void add_edge(const PolygonSoup& soup, const std::vector<EdgeUse>& in_patch, bool something_else, Border& border) {
  const VertexIndex a = in_patch[0].a, b = in_patch[0].b;
  const bool forward = runs_from(soup.facets[in_patch[0].facet], a, b);
  if (in_patch.size() == 1) {
    border.simple = border.simple && border.next.emplace(forward ? a : b, forward ? b : a).second;
  } else if (in_patch.size() == 2 && forward != runs_from(soup.facets[in_patch[1].facet], a, b)) {
    if (something_else) border.segments.emplace_back(a, b);
  } else {
    border.simple = false;
  }
}

/// Returns the loops of a patch's border. The first one has the least point (x, y, z): in a plane, the outer loop.
std::vector<std::vector<VertexIndex>> trace_loops(const PolygonSoup& soup, const Border& border) {
  std::vector<std::vector<VertexIndex>> loops;
  std::set<VertexIndex> seen;
  VertexIndex least = border.next.begin()->first;
  for (const auto& [from, to] : border.next)
    if (compare_lexicographic(soup.points[from], soup.points[least]) < 0) least = from;
  std::size_t outer = 0;
  for (const auto& [start, second] : border.next) {
    if (seen.contains(start)) continue;
    loops.emplace_back();
    for (VertexIndex v = start; seen.insert(v).second;) {
      if (v == least) outer = loops.size() - 1;
      loops.back().push_back(v);
      const auto at = border.next.find(v);
      if (at == border.next.end()) return {};
      v = at->second;
    }
  }
  std::swap(loops[0], loops[outer]);
  return loops;
}

std::vector<VertexIndex> inner_points(const PolygonSoup& soup, const std::vector<Index>& facets, const Border& border) {
  std::set<VertexIndex> inner;
  for (Index f : facets) inner.insert(soup.facets[f].begin(), soup.facets[f].end());
  for (const auto& [from, to] : border.next) inner.erase(from);
  for (const auto& [a, b] : border.segments) {
    inner.erase(a);
    inner.erase(b);
  }
  return {inner.begin(), inner.end()};
}

}  // namespace

std::map<Index, FlatPatch> flat_box_patches(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces,
                                            const SurfaceSets& sets, const std::vector<Index>& patch,
                                            const std::vector<EdgeUse>& uses) {
  std::map<Index, FlatPatch> result;
  for (Index f = 0; f < soup.facets.size(); ++f) {
    const std::vector<Index>& set = sets.sets[sets.of_facet[f]];
    if (set.size() == 1 && surfaces[set.front()].kind == SurfaceKind::box) result[patch[f]].facets.push_back(f);
  }
  std::map<Index, Border> borders;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    std::map<Index, std::vector<EdgeUse>> by_patch;
    for (const EdgeUse& use : edge)
      if (result.contains(patch[use.facet])) by_patch[patch[use.facet]].push_back(use);
    for (const auto& [p, in_patch] : by_patch) add_edge(soup, in_patch, in_patch.size() < edge.size(), borders[p]);
  });
  for (auto at = result.begin(); at != result.end();) {
    FlatPatch& flat = at->second;
    const Border& border = borders[at->first];
    if (flat.facets.size() > 1 && border.simple && is_axis_aligned(soup, flat.facets))
      flat.loops = trace_loops(soup, border);
    flat.segments = border.segments;
    if (!flat.loops.empty()) flat.points = inner_points(soup, flat.facets, border);
    at = flat.loops.empty() ? result.erase(at) : std::next(at);
  }
  return result;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: MIT
#include "remesh/start/sampled_crossings.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "common/sort_unique.hpp"
#include "plc/facet_triangulation.hpp"
#include "plc/find_crossing.hpp"

namespace geomesh::remesh {

namespace {

std::vector<FacetPolygon> polygons_of(const PiecewiseLinearComplex& plc) {
  std::vector<FacetPolygon> polygons(plc.n_facets());
  for (Index f = 0; f < plc.n_facets(); ++f)
    for (Index l = plc.facet_loops[f]; l < plc.facet_loops[f + 1]; ++l)
      polygons[f].loops.emplace_back(plc.loop(l).begin(), plc.loop(l).end());
  for (const auto& s : plc.facet_segments) polygons[s.facet].segments.push_back({s.a, s.b});
  for (const auto& p : plc.facet_points) polygons[p.facet].inner_points.push_back(p.v);
  return polygons;
}

}  // namespace

std::vector<Index> facets_that_meet(const PiecewiseLinearComplex& plc, unsigned threads) {
  std::vector<Index> meeting, facet_of_triangle;
  PiecewiseLinearComplex flat;
  flat.points = plc.points;
  flat.segments = plc.segments;
  std::map<Triangle, Index> facet_at;
  const std::vector<FacetPolygon> polygons = polygons_of(plc);
  for (Index f = 0; f < polygons.size(); ++f) {
    FacetFault fault;
    const std::optional<FacetTriangulation> drawn = triangulate_facet(plc.points, polygons[f], fault);
    if (!drawn) {
      meeting.push_back(f);
      continue;
    }
    for (const Triangle& t : drawn->triangles) {
      Triangle key = t;
      std::sort(key.begin(), key.end());
      const auto [at, is_new] = facet_at.try_emplace(key, f);
      if (!is_new) meeting.insert(meeting.end(), {at->second, f});
      flat.add_triangle(t);
      facet_of_triangle.push_back(f);
    }
  }
  for (const PlcCrossing& crossing : find_crossings(flat, threads)) {
    meeting.push_back(facet_of_triangle[crossing.facet]);
    if (crossing.edge_facet != no_index) meeting.push_back(facet_of_triangle[crossing.edge_facet]);
  }
  sort_unique(meeting);
  return meeting;
}

}  // namespace geomesh::remesh

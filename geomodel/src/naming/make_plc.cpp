// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the polygon soup to a piecewise linear complex, declared in geomesh/geomodel/build_model.hpp.
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "common/edge_uses.hpp"
#include "common/union_find.hpp"
#include "geomesh/geomodel/build_model.hpp"
#include "naming/patches/flat_patches.hpp"
#include "naming/patches/surface_curves.hpp"
#include "naming/patches/surface_sets.hpp"

namespace geomesh::geomodel {

namespace {

std::vector<Index> surfaces_at(std::span<const EdgeUse> edge, const SurfaceSets& sets) {
  std::vector<Index> all;
  for (const EdgeUse& use : edge) {
    const std::vector<Index>& set = sets.sets[sets.of_facet[use.facet]];
    all.insert(all.end(), set.begin(), set.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

bool inside_patch(std::span<const EdgeUse> edge, const SurfaceSets& sets) {
  return edge.size() == 2 && sets.of_facet[edge[0].facet] == sets.of_facet[edge[1].facet];
}

/// Returns the curve to which an edge belongs, or nothing inside a patch.
std::optional<SoupCurve> curve_at(std::span<const EdgeUse> edge, const SurfaceSets& sets,
                                  const std::vector<TriangulatedSurface>& surfaces) {
  if (inside_patch(edge, sets)) return std::nullopt;
  return curve_of(surfaces_at(edge, sets), edge.size(), surfaces);
}

/// Segments of the PLC by their end points, with the names of their curves, which have no indices yet.
class SegmentTable {
 public:
  void add_edge(VertexIndex a, VertexIndex b, const SoupCurve& curve) {
    edge_curves_.insert({{curve.kind, curve.name}, 0});
    segments_[{a, b}].edge_curve = std::make_pair(curve.kind, curve.name);
  }
  void add_well(VertexIndex a, VertexIndex b, Index polyline) {
    segments_[{std::min(a, b), std::max(a, b)}].wells.insert(polyline);
    wells_.insert({polyline, 0});
  }
  void write(const std::vector<Polyline>& polylines, ModelPlc& model) {
    for (auto& [key, row] : edge_curves_) {
      row = static_cast<Index>(model.curves.size());
      model.curves.push_back({key.second, key.first});
    }
    for (auto& [polyline, row] : wells_) {
      row = static_cast<Index>(model.curves.size());
      model.curves.push_back({polylines[polyline].name, "well"});
    }
    for (const auto& [ends, names] : segments_) {
      std::vector<Index> rows;
      if (names.edge_curve) rows.push_back(edge_curves_.at(*names.edge_curve));
      for (Index well : names.wells) rows.push_back(wells_.at(well));
      model.plc.segments.push_back({ends.first, ends.second, rows.front()});
      model.segment_curves.push_back(std::move(rows));
    }
  }

 private:
  using CurveKey = std::pair<std::string, std::string>;  // kind, name
  struct Names {
    std::optional<CurveKey> edge_curve;
    std::set<Index> wells;
  };
  std::map<CurveKey, Index> edge_curves_;
  std::map<Index, Index> wells_;
  std::map<std::pair<VertexIndex, VertexIndex>, Names> segments_;
};

/// Numbers the patches of facets from 1 in the order of their first facet.
std::vector<Index> number_patches(UnionFind& joined, std::size_t n_facets) {
  std::vector<Index> patch(n_facets);
  Index n_patches = 0;
  for (Index f = 0; f < n_facets; ++f) patch[f] = joined.find(f) == f ? ++n_patches : patch[joined.find(f)];
  return patch;
}

std::vector<VertexIndex> lone_points(const PolygonSoup& soup) {
  std::vector<bool> used(soup.points.size(), false);
  for (const Triangle& t : soup.facets)
    for (VertexIndex v : t) used[v] = true;
  for (const PolygonSoup::Segment& s : soup.segments) used[s.a] = used[s.b] = true;
  std::vector<VertexIndex> lone;
  for (const PolygonSoup::IsolatedPoint& p : soup.isolated_points) {
    if (!used[p.v]) lone.push_back(p.v);
    used[p.v] = true;
  }
  return lone;
}

}  // namespace

ModelPlc make_plc(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces,
                  const std::vector<Polyline>& polylines, const PlcOptions& options) {
  const SurfaceSets sets = surface_sets(soup);
  const std::vector<EdgeUse> uses = sorted_edge_uses(soup.facets);
  ModelPlc model;
  model.plc.points = soup.points;
  model.plc.provenance_sets = sets.sets;
  UnionFind patches(soup.facets.size());
  SegmentTable segments;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (inside_patch(edge, sets)) patches.unite(edge[0].facet, edge[1].facet);
    if (const auto curve = curve_at(edge, sets, surfaces)) segments.add_edge(edge[0].a, edge[0].b, *curve);
  });
  const std::vector<Index> patch = number_patches(patches, soup.facets.size());
  std::map<Index, FlatPatch> flat;
  if (options.merge_box_sides) flat = flat_box_patches(soup, surfaces, sets, patch, uses);
  for (Index f = 0; f < soup.facets.size(); ++f) {
    const auto at = flat.find(patch[f]);
    if (at == flat.end()) {
      model.plc.add_triangle(soup.facets[f], sets.of_facet[f]);
      model.facet_soup.push_back(f);
    } else if (at->second.facets.front() == f) {
      const Index facet = model.plc.add_polygon(at->second.loops, sets.of_facet[f]);
      for (const auto& [a, b] : at->second.segments) model.plc.facet_segments.push_back({facet, a, b});
      for (VertexIndex v : at->second.points) model.plc.facet_points.push_back({facet, v});
      model.facet_soup.insert(model.facet_soup.end(), at->second.facets.begin(), at->second.facets.end());
    } else {
      continue;
    }
    model.facet_patch.push_back(patch[f]);
    model.facet_soup_offsets.push_back(static_cast<Index>(model.facet_soup.size()));
  }
  for (const PolygonSoup::Segment& s : soup.segments) segments.add_well(s.a, s.b, s.polyline);
  segments.write(polylines, model);
  model.plc.isolated_points = lone_points(soup);
  return model;
}

}  // namespace geomesh::geomodel

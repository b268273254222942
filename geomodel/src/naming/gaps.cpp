// SPDX-License-Identifier: GPL-3.0-or-later
// Finds where horizons have holes, end inside a region or are absent, and the units that are connected there.
#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "common/edge_uses.hpp"
#include "common/union_find.hpp"
#include "naming/name_regions.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {

namespace {

/// Connected free edges of one horizon: the border of one hole, or one stretch of the outer border.
struct FreeBorder {
  bool hole = false;
  double length = 0;
  Vec3 place;              ///< where the border is: the centre of a hole, else the midpoint of the longest edge
  Index facet = no_index;  ///< index of a facet of the polygon soup that has an edge on this border
};

struct HorizonEdges {
  /// Edges at which one facet of the horizon ends freely, without a facet of another surface.
  std::vector<EdgeUse> free;
  std::vector<EdgeUse> within;  ///< edges at which several facets of the horizon meet, once for each of these facets
  std::vector<EdgeUse> ends_on_something;  ///< edges at which one facet of the horizon meets facets of other surfaces
};

std::vector<HorizonEdges> horizon_edges(const PolygonSoup& soup, const std::vector<std::vector<Index>>& rows_of_facet,
                                        std::size_t n_horizons) {
  std::vector<HorizonEdges> result(n_horizons);
  for_each_edge(sorted_edge_uses(soup.facets), [&](std::span<const EdgeUse> edge) {
    std::map<Index, std::vector<EdgeUse>> of;
    for (const EdgeUse& use : edge)
      for (Index h : rows_of_facet[use.facet]) of[h].push_back(use);
    for (const auto& [h, uses] : of) {
      if (uses.size() > 1) {
        result[h].within.insert(result[h].within.end(), uses.begin(), uses.end());
      } else {
        (edge.size() == 1 ? result[h].free : result[h].ends_on_something).push_back(uses.front());
      }
    }
  });
  return result;
}

/// Measures a border of a horizon. The result's `facet` has the longest border edge of all facets that the mesh
/// contains; remeshing may have removed others, if the border is narrow.
FreeBorder measure_border(const PolygonSoup& soup, const std::vector<EdgeUse>& edges,
                          const std::vector<Index>& component_at) {
  FreeBorder border;
  CompensatedSum length;
  std::map<VertexIndex, int> degree;
  Box3 box;
  std::pair<bool, double> longest{false, -1};
  for (const EdgeUse& e : edges) {
    const double l = norm(soup.points[e.b] - soup.points[e.a]);
    length.add(l);
    for (VertexIndex v : {e.a, e.b}) {
      ++degree[v];
      box.add(soup.points[v]);
    }
    const bool is_there = component_at[e.facet] != no_index;
    if (std::pair(is_there, l) > longest) {
      longest = {is_there, l};
      border.place = 0.5 * (soup.points[e.a] + soup.points[e.b]);
      border.facet = e.facet;
    }
  }
  border.length = length.value();
  border.hole = std::all_of(degree.begin(), degree.end(), [](const auto& d) { return d.second % 2 == 0; });
  if (border.hole) border.place = 0.5 * (box.min + box.max);
  return border;
}

/// Splits the free edges of a horizon into connected borders. A closed border is a hole. The exception is the longest
/// closed border of a part of the horizon that ends on no other surface: this is the part's outer border.
std::vector<FreeBorder> find_borders(const PolygonSoup& soup, const HorizonEdges& edges,
                                     const std::vector<Index>& component_at) {
  UnionFind by_vertex(soup.points.size()), sheets(soup.facets.size());
  for (const EdgeUse& e : edges.free) by_vertex.unite(e.a, e.b);
  for (std::size_t i = 1; i < edges.within.size(); ++i)
    if (edges.within[i].a == edges.within[i - 1].a && edges.within[i].b == edges.within[i - 1].b)
      sheets.unite(edges.within[i].facet, edges.within[i - 1].facet);
  std::map<Index, std::vector<EdgeUse>> groups;
  for (const EdgeUse& e : edges.free) groups[by_vertex.find(e.a)].push_back(e);
  std::map<Index, bool> anchored;
  for (const EdgeUse& e : edges.ends_on_something) anchored[sheets.find(e.facet)] = true;
  std::vector<FreeBorder> borders;
  // For each connected part of the horizon that touches no other surface, its longest closed border.
  std::map<Index, std::size_t> outer;
  for (const auto& [vertex, group] : groups) {
    borders.push_back(measure_border(soup, group, component_at));
    const Index sheet = sheets.find(borders.back().facet);
    if (!borders.back().hole || anchored[sheet]) continue;
    const auto [at, is_new] = outer.emplace(sheet, borders.size() - 1);
    if (!is_new && borders[at->second].length < borders.back().length) at->second = borders.size() - 1;
  }
  for (const auto& [sheet, row] : outer) borders[row].hole = false;
  return borders;
}

/// Describes an open border of a horizon by the region around it, and by whether units join there. The caller adds how
/// many borders there are and where.
OpenBorders open_in(Index component, Index horizon, const std::string& name, const NamedRegions& named) {
  OpenBorders open;
  open.horizon = name;
  if (component == no_index) return open;
  const UnitVerdict& verdict = named.verdicts[component];
  open.region = named.regions[static_cast<std::size_t>(named.id_of_component[component] - 1)].name;
  open.joins_units = verdict.kind == UnitVerdict::Kind::joined && verdict.first <= horizon && horizon < verdict.last;
  return open;
}

/// Describes the effect of an open border of a horizon: "tertiary and chalk join" or "it ends inside chalk". `within`
/// is the area of the horizon that has the region on both sides.
std::string consequence(const OpenBorders& open, Index component, double within, const Column& column,
                        const NamedRegions& named) {
  if (open.region.empty()) return "outside of all regions";
  if (!open.joins_units)
    return "it ends there inside region " + open.region +
           (within > 0 ? ", which lies on both sides of it (area " + to_text(within) + ")" : "");
  const UnitVerdict& verdict = named.verdicts[component];
  std::string units;
  for (Index u = verdict.first; u <= verdict.last; ++u)
    units += (u == verdict.first ? "" : u == verdict.last ? " and " : ", ") + column.units[u];
  return units + " join there (region " + open.region +
         "); a larger rules.continue_within, or extend, fill_holes or throw_at of the horizon, can close it";
}

std::string in_words(const OpenBorders& open) {
  const std::string n = std::to_string(open.count);
  const std::string what = open.are_holes ? (open.count == 1 ? "has a hole" : "has " + n + " holes")
                                          : "stops short along " + (open.count == 1 ? "one border" : n + " borders");
  return "horizon " + open.horizon + " " + what + " (border length " + to_text(open.length) + ", " +
         (open.count == 1 ? "near " : "the longest near ") + to_text(open.place) + "): ";
}

/// Combines to one entry all holes, or all other open borders, of a horizon in one component.
OpenBorders together(OpenBorders open, const std::vector<FreeBorder>& borders) {
  const FreeBorder& longest = *std::ranges::max_element(borders, {}, &FreeBorder::length);
  CompensatedSum length;
  for (const FreeBorder& b : borders) length.add(b.length);
  open.are_holes = longest.hole;
  open.count = borders.size();
  open.length = length.value();
  open.place = longest.place;
  return open;
}

}  // namespace

std::vector<OpenBorders> find_gaps(const MeshedModel& model, const Column& column, const NamedRegions& named,
                                   std::vector<std::string>& warnings) {
  std::vector<OpenBorders> found;
  if (!column.given()) return found;
  const auto& [mesh, soup, plc, surfaces, moved] = model;
  std::vector<std::vector<Index>> rows_of_facet(soup.facets.size());
  std::vector<bool> present(column.horizons.size(), false);
  for (Index f = 0; f < soup.facets.size(); ++f)
    for (Index o = soup.origin_offsets[f]; o < soup.origin_offsets[f + 1]; ++o)
      for (Index h = 0; h < column.horizons.size(); ++h)
        if (column.horizons[h] == soup.origins[o].surface && (rows_of_facet[f].empty() || rows_of_facet[f].back() != h))
          rows_of_facet[f].push_back(h);
  std::vector<Index> component_at(soup.facets.size(), no_index);
  std::map<std::pair<Index, Index>, double> within;  // by horizon and component: area with the component on both sides
  for (const auto& face : mesh.faces) {
    const Index below = component_of(mesh, face.tetrahedron_below), above = component_of(mesh, face.tetrahedron_above);
    const Index c = below != no_index ? below : above;
    std::set<Index> horizons;
    for (Index i = plc.facet_soup_offsets[face.facet]; i < plc.facet_soup_offsets[face.facet + 1]; ++i) {
      component_at[plc.facet_soup[i]] = c;
      horizons.insert(rows_of_facet[plc.facet_soup[i]].begin(), rows_of_facet[plc.facet_soup[i]].end());
    }
    for (const Index h : horizons) present[h] = true;
    if (below != above) continue;
    const Vec3 &p = mesh.points[face.vertices[0]], &q = mesh.points[face.vertices[1]],
               &r = mesh.points[face.vertices[2]];
    for (const Index h : horizons) within[{h, c}] += norm(cross(q - p, r - p)) / 2;
  }
  const std::vector<HorizonEdges> edges = horizon_edges(soup, rows_of_facet, column.horizons.size());
  for (Index h = 0; h < column.horizons.size(); ++h) {
    const std::string& name = surfaces[column.horizons[h]].name;
    if (!present[h]) {
      warnings.push_back("horizon " + name + " has no face in the model: " + column.units[h] + " and " +
                         column.units[h + 1] + " are not divided by it");
      continue;
    }
    // Open borders of the horizon: holes first, then by component.
    std::map<std::pair<bool, Index>, std::vector<FreeBorder>> by_kind;
    for (const FreeBorder& border : find_borders(soup, edges[h], component_at))
      by_kind[{!border.hole, component_at[border.facet]}].push_back(border);
    for (const auto& [key, borders] : by_kind) {
      found.push_back(together(open_in(key.second, h, name, named), borders));
      const auto area = within.find({h, key.second});
      warnings.push_back(in_words(found.back()) +
                         consequence(found.back(), key.second, area == within.end() ? 0 : area->second, column, named));
    }
  }
  return found;
}

}  // namespace geomesh::geomodel

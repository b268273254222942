// SPDX-License-Identifier: GPL-3.0-or-later
// Changes components before they are named: air above the topography, seed points, fault blocks, small regions.
#include <algorithm>
#include <map>
#include <numeric>

#include "common/union_find.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "naming/name_regions.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {

namespace {

/// Keeps the components for which `keep` is set, renumbered in their order, and removes points that are no longer used.
ConstrainedTetrahedralization keep_components(const ConstrainedTetrahedralization& mesh,
                                              const std::vector<bool>& keep) {
  ConstrainedTetrahedralization out;
  out.delaunay = mesh.delaunay;
  out.recovery = mesh.recovery;
  out.delaunay_statistics = mesh.delaunay_statistics;
  std::vector<Index> component(keep.size(), no_index), tetrahedron(mesh.tetrahedra.size(), no_index);
  for (std::size_t c = 0; c < keep.size(); ++c) {
    if (!keep[c]) continue;
    component[c] = static_cast<Index>(out.n_components++);
    out.component_seed.push_back(mesh.component_seed[c]);
  }
  std::vector<VertexIndex> row(mesh.points.size(), no_vertex);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    if (keep[mesh.component[t]])
      for (VertexIndex v : mesh.tetrahedra[t]) row[v] = 0;
  for (std::size_t v = 0; v < row.size(); ++v) {
    if (row[v] == no_vertex) continue;
    row[v] = static_cast<VertexIndex>(out.points.size());
    out.points.push_back(mesh.points[v]);
    out.input_vertex.push_back(mesh.input_vertex[v]);
    out.origin.push_back(mesh.origin[v]);
  }
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    if (!keep[mesh.component[t]]) continue;
    tetrahedron[t] = static_cast<Index>(out.tetrahedra.size());
    const Tetrahedron& v = mesh.tetrahedra[t];
    out.tetrahedra.push_back({row[v[0]], row[v[1]], row[v[2]], row[v[3]]});
    out.component.push_back(component[mesh.component[t]]);
  }
  const auto kept = [&](Index t) { return t == no_index ? no_index : tetrahedron[t]; };
  for (const auto& f : mesh.faces) {
    const Index below = kept(f.tetrahedron_below), above = kept(f.tetrahedron_above);
    if (below != no_index || above != no_index)
      out.faces.push_back({{row[f.vertices[0]], row[f.vertices[1]], row[f.vertices[2]]}, f.facet, below, above});
  }
  // A curve edge is kept only if a kept tetrahedron has this edge; it is not enough to keep both of its points.
  std::vector<std::pair<VertexIndex, VertexIndex>> wanted;
  for (const auto& e : mesh.edges) wanted.emplace_back(std::min(e.a, e.b), std::max(e.a, e.b));
  std::sort(wanted.begin(), wanted.end());
  std::vector<bool> present(wanted.size(), false);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    if (!keep[mesh.component[t]]) continue;
    const Tetrahedron& v = mesh.tetrahedra[t];
    for (const auto& [i, j] : edge_vertices) {
      const std::pair key(std::min(v[i], v[j]), std::max(v[i], v[j]));
      const auto at = std::lower_bound(wanted.begin(), wanted.end(), key);
      if (at != wanted.end() && *at == key) present[static_cast<std::size_t>(at - wanted.begin())] = true;
    }
  }
  for (const auto& e : mesh.edges) {
    const std::pair key(std::min(e.a, e.b), std::max(e.a, e.b));
    const auto at = std::lower_bound(wanted.begin(), wanted.end(), key);
    if (present[static_cast<std::size_t>(at - wanted.begin())]) out.edges.push_back({row[e.a], row[e.b], e.segment});
  }
  for (VertexIndex v : mesh.isolated_points)
    if (row[v] != no_vertex) out.isolated_points.push_back(row[v]);
  out.recovery.tetrahedra_final = out.tetrahedra.size();
  return out;
}

bool holds(const ConstrainedTetrahedralization& mesh, const Tetrahedron& t, const Vec3& p) {
  for (const auto& f : face_vertices)
    if (orient3d(mesh.points[t[f[0]]], mesh.points[t[f[1]]], mesh.points[t[f[2]]], p) == Sign::negative) return false;
  return true;
}

/// Returns for each component the area of its faces on horizons other than the topography or base at which the model
/// ends. That surface cuts all other horizons, so components beyond it have no such area.
std::vector<double> area_of_other_horizons(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup,
                                           const ModelPlc& plc, const std::vector<TriangulatedSurface>& surfaces,
                                           const std::string& end) {
  std::vector<double> area(mesh.n_components, 0);
  for (const auto& face : mesh.faces) {
    const auto origins = origins_of(soup, plc, face.facet);
    const auto is_end = [&](const PolygonSoup::Origin& o) { return surfaces[o.surface].name == end; };
    const auto is_horizon = [&](const PolygonSoup::Origin& o) {
      return surfaces[o.surface].kind == SurfaceKind::horizon;
    };
    if (std::any_of(origins.begin(), origins.end(), is_end) || std::none_of(origins.begin(), origins.end(), is_horizon))
      continue;
    const auto& v = face.vertices;
    const double size = triangle_area(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]);
    const Index below = component_of(mesh, face.tetrahedron_below), above = component_of(mesh, face.tetrahedron_above);
    if (below != no_index) area[below] += size;
    if (above != no_index && above != below) area[above] += size;
  }
  return area;
}

/// Returns whether the component continues around the edge of the surface at which the model ends. This is so if it
/// lies on both sides of that surface, and either the area between its two sides exceeds the area that separates it
/// from other components, or other horizons touch it.
bool lies_about(const HorizonContacts& contacts, const ModelEnd& end, double other_horizons) {
  constexpr double least = 0.01;  // areas below this share of the component's area on topography (base) are ignored
  const auto& parting = end.above ? contacts.lies_above : contacts.lies_below;
  const auto area = [](const std::map<Index, double>& at) { return at.contains(0) ? at.at(0) : 0.0; };
  const double both = area(contacts.on_both_sides), one = area(parting), little = least * (both + one);
  return both > one || (both > little && other_horizons > little);
}

}  // namespace

ConstrainedTetrahedralization without_side(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup,
                                           const ModelPlc& plc, const std::vector<TriangulatedSurface>& surfaces,
                                           const ModelEnd& end, std::vector<std::string>& warnings) {
  const Column column = make_column({"above", end.horizon, "below"}, surfaces, warnings);
  const std::vector<HorizonContacts> contacts = horizon_contacts(mesh, soup, plc, column);
  const std::vector<double> other_horizons = area_of_other_horizons(mesh, soup, plc, surfaces, end.horizon);
  const Index left_out = end.above ? 0 : 1;
  const std::string where = (end.above ? "above the topography " : "below the bottom ") + end.horizon;
  std::vector<bool> keep(mesh.n_components, true);
  for (std::size_t c = 0; c < keep.size(); ++c) {
    const UnitVerdict verdict = find_unit(contacts[c], column);
    const bool is_beyond = verdict.kind == UnitVerdict::Kind::unit && verdict.first == left_out;
    const bool goes_round = is_beyond && lies_about(contacts[c], end, other_horizons[c]);
    keep[c] = !is_beyond || goes_round;
    if (verdict.kind == UnitVerdict::Kind::joined || goes_round)
      warnings.push_back(std::string(end.above ? "topography " : "bottom ") + end.horizon +
                         " has a hole or stops short: what lies " + (end.above ? "above" : "below") +
                         " it there joins the model and is kept");
  }
  if (std::find(keep.begin(), keep.end(), true) == keep.end())
    throw Error(ErrorKind::cannot_mesh, "everything lies " + where + ": nothing is left to mesh");
  if (std::find(keep.begin(), keep.end(), false) == keep.end()) {
    warnings.push_back("no region lies " + where + ": nothing is left out");
    return mesh;
  }
  return keep_components(mesh, keep);
}

ConstrainedTetrahedralization within_ends(ConstrainedTetrahedralization mesh, const PolygonSoup& soup,
                                          const ModelPlc& plc, const std::vector<TriangulatedSurface>& surfaces,
                                          const NamingRules& rules, std::vector<std::string>& warnings) {
  if (!rules.topography.empty()) mesh = without_side(mesh, soup, plc, surfaces, {rules.topography, true}, warnings);
  if (!rules.floor.empty()) mesh = without_side(mesh, soup, plc, surfaces, {rules.floor, false}, warnings);
  return mesh;
}

std::vector<Index> seeded(const ConstrainedTetrahedralization& mesh, const std::vector<NamedPoint>& seeds,
                          std::vector<std::string>& warnings) {
  std::vector<Index> result(mesh.n_components, no_index);
  for (Index s = 0; s < seeds.size(); ++s) {
    const auto at = std::find_if(mesh.tetrahedra.begin(), mesh.tetrahedra.end(),
                                 [&](const Tetrahedron& t) { return holds(mesh, t, seeds[s].point); });
    if (at == mesh.tetrahedra.end()) {
      warnings.push_back("the point that names region " + seeds[s].name + ", " + to_text(seeds[s].point) +
                         ", lies outside of all regions");
      continue;
    }
    Index& named = result[mesh.component[static_cast<std::size_t>(at - mesh.tetrahedra.begin())]];
    if (named != no_index) {
      warnings.push_back("the points that name regions " + seeds[named].name + " and " + seeds[s].name +
                         " lie in one region: it is named " + seeds[named].name);
    } else {
      named = s;
    }
  }
  return result;
}

std::vector<Index> fault_blocks(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup, const ModelPlc& plc,
                                const std::vector<ComponentFacts>& facts, const Column& column) {
  UnionFind joined(mesh.n_components);
  for (const auto& face : mesh.faces) {
    const Index below = component_of(mesh, face.tetrahedron_below), above = component_of(mesh, face.tetrahedron_above);
    if (below == no_index || above == no_index) continue;
    const auto origins = origins_of(soup, plc, face.facet);
    const bool horizons_alone = std::all_of(origins.begin(), origins.end(), [&](const PolygonSoup::Origin& o) {
      return std::find(column.horizons.begin(), column.horizons.end(), o.surface) != column.horizons.end();
    });
    if (horizons_alone) joined.unite(below, above);
  }
  std::vector<Vec3> least(mesh.n_components);
  std::vector<Index> roots;
  for (Index c = 0; c < mesh.n_components; ++c) {
    const Index root = joined.find(c);
    if (root == c) {
      roots.push_back(c);
      least[c] = facts[c].min_point;
    } else if (compare_lexicographic(facts[c].min_point, least[root]) < 0) {
      least[root] = facts[c].min_point;
    }
  }
  std::sort(roots.begin(), roots.end(), [&](Index a, Index b) {
    const int order = compare_lexicographic(least[a], least[b]);
    return order != 0 ? order < 0 : a < b;
  });
  std::vector<Index> block_of_root(mesh.n_components, 0), block(mesh.n_components, 0);
  for (Index k = 0; k < roots.size(); ++k) block_of_root[roots[k]] = k;
  for (Index c = 0; c < mesh.n_components; ++c) block[c] = block_of_root[joined.find(c)];
  return block;
}

std::vector<Index> merge_targets(const ConstrainedTetrahedralization& mesh, const std::vector<ComponentFacts>& facts,
                                 double min_volume) {
  std::map<std::pair<Index, Index>, double> shared;
  for (const auto& face : mesh.faces) {
    const Index below = component_of(mesh, face.tetrahedron_below), above = component_of(mesh, face.tetrahedron_above);
    if (below == no_index || above == no_index || below == above) continue;
    const double area =
        triangle_area(mesh.points[face.vertices[0]], mesh.points[face.vertices[1]], mesh.points[face.vertices[2]]);
    shared[{below, above}] += area;
    shared[{above, below}] += area;
  }
  std::vector<Index> order(facts.size()), target(facts.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::iota(target.begin(), target.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return facts[a].volume != facts[b].volume ? facts[a].volume > facts[b].volume : a < b;
  });
  std::vector<Index> rank(facts.size());
  for (Index k = 0; k < order.size(); ++k) rank[order[k]] = k;
  for (Index c : order) {  // each component merges into a larger one, so chains of merges end
    if (facts[c].volume >= min_volume) continue;
    double best = 0;
    for (auto at = shared.lower_bound({c, 0}); at != shared.end() && at->first.first == c; ++at)
      if (rank[at->first.second] < rank[c] && at->second > best) {
        best = at->second;
        target[c] = target[at->first.second];
      }
  }
  return target;
}

std::vector<Index> join_targets(const std::vector<ComponentFacts>& facts, const std::vector<std::string>& names) {
  std::map<std::string, Index> largest;
  for (Index c = 0; c < facts.size(); ++c) {
    const auto [at, is_new] = largest.emplace(names[c], c);
    if (!is_new && facts[c].volume > facts[at->second].volume) at->second = c;
  }
  std::vector<Index> target(facts.size());
  for (Index c = 0; c < facts.size(); ++c) target[c] = names[c].empty() ? c : largest.at(names[c]);
  return target;
}

std::vector<ComponentFacts> joined_facts(std::vector<ComponentFacts> facts, std::span<const Index> target) {
  std::vector<CompensatedSum> sums(facts.size());
  for (std::size_t c = 0; c < facts.size(); ++c) sums[target[c]].add(facts[c].volume);
  for (std::size_t c = 0; c < facts.size(); ++c) facts[c].volume = sums[target[c]].value();
  return facts;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/diagnosis/diagnosis.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "arrangement/diagnosis/edge_buckets.hpp"
#include "arrangement/diagnosis/surface_parts.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/geomodel/model_error.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

using SurfacePair = std::pair<Index, Index>;

bool is_inside(const std::optional<Box3>& box, const Vec3& p) {
  for (std::size_t i = 0; box && i < 3; ++i)
    if (p[i] < box->min[i] || p[i] > box->max[i]) return false;
  return true;
}

/// Returns whether a crossing is unexpected: of a surface with itself, of two horizons, or of a surface of unknown
/// kind.
bool is_suspicious(const SurfaceList& surfaces, const Spot& spot) {
  if (spot.surface_a == spot.surface_b) return true;
  const SurfaceKind a = surfaces[spot.surface_a].kind, b = surfaces[spot.surface_b].kind;
  return (a == SurfaceKind::horizon && b == SurfaceKind::horizon) || a == SurfaceKind::surface ||
         b == SurfaceKind::surface;
}

/// Reports the free borders of surfaces by connected piece, longest first: at most `limit` pieces of each surface and
/// kind as findings (Spot) of their own, the rest as one. A closed piece is a gap, unless it may be the surface's outer
/// border: the longest piece, except for horizons in a box, which should reach the box's sides.
void add_free_borders(const PolygonSoup& soup, const SurfaceList& surfaces, std::vector<Spot>& spots) {
  struct FreeEdge {
    Index surface;
    VertexIndex a, b;
  };
  std::vector<FreeEdge> edges;
  EdgeBuckets(soup).for_each_edge([&](VertexIndex a, VertexIndex b, const std::vector<Index>& facets) {
    if (facets.size() == 1) edges.push_back({soup.origins[soup.origin_offsets[facets.front()]].surface, a, b});
  });
  std::map<std::pair<Index, VertexIndex>, std::pair<Index, VertexIndex>> parent;
  const auto root = [&parent](std::pair<Index, VertexIndex> v) {
    for (auto at = parent.try_emplace(v, v).first; at->second != v; at = parent.find(v))
      v = at->second = parent.at(at->second);
    return v;
  };
  for (const FreeEdge& e : edges) {
    const auto a = root({e.surface, e.a}), b = root({e.surface, e.b});
    parent[std::max(a, b)] = std::min(a, b);
  }
  std::map<std::pair<Index, VertexIndex>, Spot> pieces;
  std::map<std::pair<Index, VertexIndex>, std::size_t> degree;
  for (const FreeEdge& e : edges) {
    ++degree[{e.surface, e.a}];
    ++degree[{e.surface, e.b}];
    Spot& spot = pieces[root({e.surface, e.a})];
    if (spot.count == 0) spot = {"free border", e.surface, no_index, 0, 0, 0.5 * (soup.points[e.a] + soup.points[e.b])};
    ++spot.count;
    spot.measure += length(soup.points[e.a] - soup.points[e.b]);
  }
  std::map<Index, double> longest;
  for (const auto& [key, spot] : pieces) longest[key.first] = std::max(longest[key.first], spot.measure);
  // Pieces of a surface's border that are not closed curves, since they stop at another surface.
  std::set<std::pair<Index, VertexIndex>> open;
  for (const auto& [vertex, n] : degree)
    if (n % 2 != 0) open.insert(root(vertex));
  for (auto& [key, spot] : pieces)
    if (!open.contains(key) && (spot.measure < longest.at(key.first) ||
                                (!surfaces.box_sides.empty() && surfaces[key.first].kind == SurfaceKind::horizon)))
      spot.what = "gap";
  std::vector<Spot> sorted;
  for (const auto& piece : pieces) sorted.push_back(piece.second);
  std::stable_sort(sorted.begin(), sorted.end(), [](const Spot& x, const Spot& y) {
    return std::tuple{x.surface_a, x.what, -x.measure} < std::tuple{y.surface_a, y.what, -y.measure};
  });
  constexpr std::size_t limit = 20;
  std::size_t in_surface = 0;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    in_surface = k > 0 && sorted[k].surface_a == sorted[k - 1].surface_a && sorted[k].what == sorted[k - 1].what
                     ? in_surface + 1
                     : 0;
    if (in_surface < limit) {
      spots.push_back(sorted[k]);
    } else if (in_surface == limit) {
      spots.push_back(sorted[k]);
      if (spots.back().what != "gap") spots.back().what = "free border (other pieces)";
    } else {
      spots.back().count += sorted[k].count;
      spots.back().measure += sorted[k].measure;
      ++spots.back().n_pieces;
    }
  }
}

/// Returns whether two origins (input triangles) are exactly coplanar, so that they overlap already in the input.
bool are_coplanar(const SurfaceList& surfaces, const Origin& a, const Origin& b) {
  const auto corner = [&](const Origin& o, std::size_t k) -> const Vec3& {
    return surfaces[o.surface].points[surfaces[o.surface].triangles[o.triangle][k]];
  };
  for (std::size_t k = 0; k < 3; ++k)
    if (orient3d(corner(a, 0), corner(a, 1), corner(a, 2), corner(b, k)) != Sign::zero) return false;
  return true;
}

/// Adds findings (Spot) of places where surfaces coincide: in the input, or as rounding or the tolerance merged them.
void add_overlaps(const PolygonSoup& soup, const SurfaceList& surfaces, ArrangementResult& result) {
  std::map<std::pair<SurfacePair, bool>, Spot> overlaps;
  for (Index f = 0; f < soup.facets.size(); ++f) {
    const Index begin = soup.origin_offsets[f], end = soup.origin_offsets[f + 1];
    for (Index k = begin + 1; k < end; ++k) {
      const SurfacePair pair{soup.origins[begin].surface, soup.origins[k].surface};
      const bool is_merged = !are_coplanar(surfaces, soup.origins[begin], soup.origins[k]);
      const Triangle& t = soup.facets[f];
      Spot& spot = overlaps[{pair, is_merged}];
      if (spot.count == 0) spot = {is_merged ? "merged" : "overlap", pair.first, pair.second, 0, 0, soup.points[t[0]]};
      ++spot.count;
      spot.measure += area(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
    }
  }
  for (const auto& [key, spot] : overlaps) {
    result.spots.push_back(spot);
    if (surfaces[spot.surface_b].kind == SurfaceKind::box) continue;
    result.warnings.push_back(describe(spot, surfaces.all()));
  }
}

void add_vanished(const std::vector<VanishedFacet>& vanished, ArrangementResult& result) {
  std::map<Index, Spot> spots;
  for (const VanishedFacet& v : vanished) {
    Spot& spot = spots[v.surfaces[0]];
    if (spot.count == 0) spot = {"vanished", v.surfaces[0], no_index, 0, 0, v.corners[0]};
    ++spot.count;
  }
  for (const auto& [surface, spot] : spots) result.spots.push_back(spot);
}

/// Measures how much of either surface lies beyond the other where two surfaces cross that should not. Adds warnings.
void measure_crossings(const SurfaceList& surfaces, ArrangementResult& result) {
  std::optional<SurfaceParts> parts;
  for (Spot& spot : result.spots) {
    if ((spot.what != "crossing" && spot.what != "self-crossing") || !is_suspicious(surfaces, spot)) continue;
    if (spot.what == "crossing") {
      if (!parts) parts.emplace(result.soup, surfaces.size());
      const double a = parts->area_parted(spot.surface_a, spot.surface_b),
                   b = parts->area_parted(spot.surface_b, spot.surface_a);
      spot.area = a == 0 || b == 0 ? std::max(a, b) : std::min(a, b);
    }
    result.warnings.push_back(describe(spot, surfaces.all()));
  }
}

}  // namespace

void diagnose_crossings(const ArrangedContacts& round, const SurfaceList& surfaces, const std::optional<Box3>& box,
                        ArrangementResult& result, std::vector<std::uint8_t>& crosses_itself) {
  const auto& [complex, contacts, arranged] = round;
  struct Seen {
    Index a, b;
    std::size_t contact;
    bool operator<(const Seen& o) const { return std::tie(a, b, contact) < std::tie(o.a, o.b, o.contact); }
  };
  std::vector<Seen> pairs;
  for (std::size_t k = 0; k < contacts.facets.size(); ++k) {
    const FacetContact& c = contacts.facets[k];
    if (c.other != no_index) pairs.push_back({std::min(c.facet, c.other), std::max(c.facet, c.other), k});
  }
  std::sort(pairs.begin(), pairs.end());
  std::map<SurfacePair, Spot> spots;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (k > 0 && pairs[k].a == pairs[k - 1].a && pairs[k].b == pairs[k - 1].b) continue;
    const auto& ends = arranged.contact_ends[pairs[k].contact];
    if (ends[1] != no_index) ++result.n_crossing_pairs;
    const Index a = complex.origins.of(pairs[k].a)[0].surface, b = complex.origins.of(pairs[k].b)[0].surface;
    if (surfaces[a].kind == SurfaceKind::box || surfaces[b].kind == SurfaceKind::box) continue;
    const Vec3 p = arranged.vertices.rounded(ends[0]), q = ends[1] == no_index ? p : arranged.vertices.rounded(ends[1]);
    if (!is_inside(box, 0.5 * (p + q))) continue;
    if (a == b) crosses_itself[a] = 1;
    Spot& spot = spots[{std::min(a, b), std::max(a, b)}];
    if (spot.count == 0)
      spot = {a == b ? "self-crossing" : "crossing", std::min(a, b), std::max(a, b), 0, 0, 0.5 * (p + q)};
    ++spot.count;
    spot.measure += length(p - q);
  }
  for (const Overlap& o : contacts.overlaps) {
    const Index a = complex.origins.of(o.a)[0].surface, b = complex.origins.of(o.b)[0].surface;
    if (a == b && a < crosses_itself.size()) crosses_itself[a] = 1;
  }
  for (const auto& entry : spots) result.spots.push_back(entry.second);
}

void refuse_crossings(const ArrangementResult& result, const SurfaceList& surfaces) {
  std::ostringstream text;
  ErrorContext context;
  ModelItems items;
  for (const Spot& spot : result.spots) {
    if (spot.what != "crossing" && spot.what != "self-crossing") continue;
    for (const Index s : {spot.surface_a, spot.surface_b})
      if (s < surfaces.all().size()) items.add_surface(surfaces.all()[s].name);
    text << (context.places.empty() ? "" : "; ") << describe(spot, surfaces.all());
    context.places.push_back(spot.place);
  }
  if (context.places.empty()) return;
  const std::string message =
      "surfaces cross, and crossings are refused: " + text.str() + ". Mend them, or let crossings be resolved.";
  throw ModelError(ErrorKind::invalid_input, message, std::move(items), std::move(context));
}

void diagnose_soup(const SurfaceList& surfaces, const std::vector<VanishedFacet>& vanished, ArrangementResult& result) {
  measure_crossings(surfaces, result);
  add_overlaps(result.soup, surfaces, result);
  add_vanished(vanished, result);
  add_free_borders(result.soup, surfaces, result.spots);
  for (Index s = 0; s < surfaces.given.size(); ++s) {
    if (result.area_clipped_by_box[s] > 0)
      result.spots.push_back({"clipped by box", s, no_index, 0, result.area_clipped_by_box[s],
                              surfaces[s].points.empty() ? Vec3{} : surfaces[s].points.front()});
  }
}

}  // namespace geomesh::geomodel::arrangement

// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/pockets/close_pockets.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "arrangement/model/surface_ends.hpp"
#include "arrangement/pockets/pocket_walls.hpp"
#include "geomesh/core/surface_distance.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

double volume_of(const Complex& complex, const std::vector<FacetSide>& shell) {
  const Vec3& origin = complex.points[complex.facets[facet_of(shell.front())][0]];
  double sum = 0;
  for (const FacetSide s : shell) {
    const Triangle& t = complex.facets[facet_of(s)];
    const double part =
        dot(complex.points[t[0]] - origin, cross(complex.points[t[1]] - origin, complex.points[t[2]] - origin));
    sum += is_front(s) ? -part : part;
  }
  return sum / 6;
}

std::vector<Triangle> triangles_of(const Complex& complex, const std::vector<FacetSide>& sides) {
  std::vector<Triangle> triangles;
  for (const FacetSide s : sides) triangles.push_back(complex.facets[facet_of(s)]);
  return triangles;
}

/// Returns the corner of one wall of a thin void that is farthest from the other wall, if all of this wall is proven to
/// be within the distance.
std::optional<Displacement> way_between(const Complex& complex, const std::vector<FacetSide>& wall,
                                        const SurfaceDistance& other, double distance) {
  Displacement way;
  for (const FacetSide s : wall) {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = complex.points[complex.facets[facet_of(s)][k]];
      const double d = length(other.closest(corners[k]) - corners[k]);
      if (d > way.largest) way = {d, 0, corners[k], 0};
    }
    if (way.largest > distance || !other.is_within(corners, distance)) return std::nullopt;
  }
  return way;
}

Triangle sorted_corners(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// The vertex indices of an edge, the smaller first, and a surface at the edge.
using SurfaceEdge = std::tuple<VertexIndex, VertexIndex, Index>;

/// For each triangle of the input, the part of its surface to which it belongs.
class Parts {
 public:
  explicit Parts(const std::vector<std::vector<Index>>& of_triangle) : of_triangle_(of_triangle) {}
  bool are_same(const Origin& a, const Origin& b) const {
    return a.surface == b.surface && (a.surface >= of_triangle_.size() || of_triangle_[a.surface].empty() ||
                                      of_triangle_[a.surface][a.triangle] == of_triangle_[b.surface][b.triangle]);
  }

 private:
  const std::vector<std::vector<Index>>& of_triangle_;
};

/// Surfaces that were assigned to facets because the void between them was closed.
struct GivenSurfaces {
  /// Surfaces assigned to each facet when voids were closed; the facet is given by its sorted corners.
  std::map<Triangle, std::set<Index>> of_facet;
  std::set<SurfaceEdge> borders;  ///< edges at which surfaces ended before any void was closed
};

/// Calls `visit` for each edge of the facet with each of the facet's surfaces.
template <class Visit>
void for_each_edge(const Complex& complex, Index f, const Visit& visit) {
  const Triangle& t = complex.facets[f];
  for (const Index surface : surfaces_of(complex.origins.of(f)))
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      visit(SurfaceEdge{a, b, surface});
    }
}

std::map<SurfaceEdge, Index> facets_at_edges(const Complex& complex) {
  std::map<SurfaceEdge, Index> n_at;
  for (Index f = 0; f < complex.facets.size(); ++f) for_each_edge(complex, f, [&](const SurfaceEdge& e) { ++n_at[e]; });
  return n_at;
}

std::set<SurfaceEdge> borders_of(const Complex& complex) {
  std::set<SurfaceEdge> borders;
  for (const SurfaceEnd& end : surface_ends(complex)) borders.insert(borders.end(), {end.a, end.b, end.surface});
  return borders;
}

void take_surface(Complex& complex, const std::map<Index, std::set<Index>>& taken) {
  edit_origins(complex, [&](Index f, std::vector<Origin>& of) {
    if (const auto at = taken.find(f); at != taken.end())
      std::erase_if(of, [&](const Origin& o) { return at->second.contains(o.surface); });
  });
}

/// Takes an assigned surface away from facets at which it ends in the open: a narrow strip between two closed voids may
/// have been assigned a surface that lost its walls on either side of the strip. A facet loses its assigned surface if
/// that now ends at one of its edges and did not end there before. This is repeated until no such facet is left.
void prune_fins(Complex& complex, const GivenSurfaces& given) {
  std::map<SurfaceEdge, Index> n_at = facets_at_edges(complex);
  std::map<SurfaceEdge, std::vector<Index>> given_at;
  std::vector<std::pair<Index, Index>> open;  // facets and surfaces
  for (Index f = 0; f < complex.facets.size(); ++f) {
    const auto own = given.of_facet.find(sorted_corners(complex.facets[f]));
    if (own == given.of_facet.end()) continue;
    for_each_edge(complex, f, [&](const SurfaceEdge& e) {
      if (own->second.contains(std::get<2>(e))) given_at[e].push_back(f);
    });
    for (const Index surface : own->second) open.emplace_back(f, surface);
  }
  std::map<Index, std::set<Index>> taken;
  while (!open.empty()) {
    const Index f = open.back().first, surface = open.back().second;
    open.pop_back();
    bool ends = false;
    for_each_edge(complex, f, [&](const SurfaceEdge& e) {
      ends = ends || (std::get<2>(e) == surface && n_at[e] == 1 && !given.borders.contains(e));
    });
    if (!ends || !taken[f].insert(surface).second) continue;
    for_each_edge(complex, f, [&](const SurfaceEdge& e) {
      if (std::get<2>(e) != surface) return;
      --n_at[e];
      for (const Index g : given_at[e])
        if (g != f) open.emplace_back(g, surface);
    });
  }
  if (!taken.empty()) take_surface(complex, taken);
}

/// One round of closing thin voids; voids that share a facet are closed in different rounds.
class PocketRound {
 public:
  PocketRound(Complex& complex, double distance, Index first_side, const Parts& parts, GivenSurfaces& given)
      : complex_(complex),
        distance_(distance),
        parts_(parts),
        given_(given),
        edges_(edge_facets(complex)),
        walls_(complex, edges_, first_side),
        is_taken_(complex.facets.size(), 0),
        goes_(complex.facets.size(), 0) {}

  bool run(ClosedPockets& done) {
    const std::size_t before = done.n_pockets;
    for (const std::vector<FacetSide>& shell : shells_of(complex_, edges_))
      if (is_thin(shell)) close(shell, done);
    if (done.n_pockets == before) return false;
    if (before == 0) given_.borders = borders_of(complex_);
    remove_walls(done);
    return true;
  }

 private:
  /// Returns whether a shell (facet sides around a space) encloses a space that is thin on average, without dangling
  /// faces.
  bool is_thin(const std::vector<FacetSide>& shell) const {
    if (shell.size() < 4) return false;
    for (std::size_t k = 0; k + 1 < shell.size(); ++k)
      if (facet_of(shell[k]) == facet_of(shell[k + 1])) return false;
    const double volume = volume_of(complex_, shell);
    return volume > 0 && 2 * volume <= distance_ * area_of(complex_, shell);
  }

  void close(const std::vector<FacetSide>& shell, ClosedPockets& done) {
    if (std::any_of(shell.begin(), shell.end(), [&](FacetSide s) { return is_taken_[facet_of(s)]; })) return;
    const std::optional<PocketWalls> walls = walls_.of(shell);
    if (!walls) return;
    const SurfaceDistance goes(complex_.points, triangles_of(complex_, walls->that_goes)),
        stays(complex_.points, triangles_of(complex_, walls->that_stays));
    const auto way = way_between(complex_, walls->that_goes, stays, distance_);
    if (!way || !way_between(complex_, walls->that_stays, goes, distance_)) return;
    for (const FacetSide s : shell) is_taken_[facet_of(s)] = 1;
    for (const FacetSide s : walls->that_goes) goes_[facet_of(s)] = 1;
    for (const FacetSide s : walls->that_stays) give_origins(s, walls->that_goes, goes);
    if (way->largest > done.moved.largest) done.moved = *way;
    ++done.n_pockets;
  }

  /// Adds to a facet of a void's kept wall the surfaces of the removed wall's nearest facet, as if that had moved.
  void give_origins(FacetSide stays, const std::vector<FacetSide>& that_goes, const SurfaceDistance& goes) {
    const Triangle& t = complex_.facets[facet_of(stays)];
    const Vec3 middle = (1.0 / 3) * (complex_.points[t[0]] + complex_.points[t[1]] + complex_.points[t[2]]);
    const FacetSide nearest = that_goes[goes.closest_triangle(middle)];
    const auto own = complex_.origins.of(facet_of(stays));
    for (Origin o : complex_.origins.of(facet_of(nearest))) {
      if (std::any_of(own.begin(), own.end(), [&](const Origin& p) { return parts_.are_same(o, p); })) continue;
      const bool looks_in = is_front(nearest) != o.reversed;
      o.reversed = looks_in == is_front(stays);
      more_origins_[facet_of(stays)].push_back(o);
      if (std::none_of(own.begin(), own.end(), [&](const Origin& p) { return p.surface == o.surface; }))
        given_.of_facet[sorted_corners(complex_.facets[facet_of(stays)])].insert(o.surface);
    }
  }

  void remove_walls(ClosedPockets& done) {
    Complex& c = complex_;
    std::vector<Triangle> facets;
    OriginLists origins;
    std::vector<std::uint8_t> dirty;
    for (Index f = 0; f < c.facets.size(); ++f) {
      if (goes_[f]) {
        ++done.n_facets_removed;
        continue;
      }
      std::vector<Origin> of(c.origins.of(f).begin(), c.origins.of(f).end());
      Triangle t = c.facets[f];
      if (const auto more = more_origins_.find(f); more != more_origins_.end()) {
        of.insert(of.end(), more->second.begin(), more->second.end());
        if (normalise_origins(of)) std::swap(t[1], t[2]);
      }
      facets.push_back(t);
      origins.push(of);
      dirty.push_back(c.dirty_facet[f]);
    }
    c.facets = std::move(facets);
    c.origins = std::move(origins);
    c.dirty_facet = std::move(dirty);
  }

  Complex& complex_;
  double distance_;
  const Parts& parts_;
  GivenSurfaces& given_;
  EdgeFacets edges_;
  WallSearch walls_;
  std::vector<std::uint8_t> is_taken_, goes_;
  std::map<Index, std::vector<Origin>> more_origins_;
};

}  // namespace

ClosedPockets close_pockets(Complex& complex, double distance, Index first_side,
                            const std::vector<std::vector<Index>>& parts) {
  ClosedPockets done;
  GivenSurfaces given;
  while (PocketRound(complex, distance, first_side, Parts(parts), given).run(done)) {
  }
  if (!given.of_facet.empty()) prune_fins(complex, given);
  return done;
}

}  // namespace geomesh::geomodel::arrangement

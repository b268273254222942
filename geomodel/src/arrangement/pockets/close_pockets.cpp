// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/pockets/close_pockets.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

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

/// One round of closing thin voids; voids that share a facet are closed in different rounds.
class PocketRound {
 public:
  PocketRound(Complex& complex, double distance, Index first_side, const Parts& parts)
      : complex_(complex),
        distance_(distance),
        parts_(parts),
        edges_(edge_facets(complex)),
        walls_(complex, edges_, first_side),
        is_taken_(complex.facets.size(), 0),
        goes_(complex.facets.size(), 0) {}

  bool run(ClosedPockets& done) {
    const std::size_t before = done.n_pockets;
    for (const std::vector<FacetSide>& shell : shells_of(complex_, edges_))
      if (is_thin(shell)) close(shell, done);
    if (done.n_pockets == before) return false;
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
  EdgeFacets edges_;
  WallSearch walls_;
  std::vector<std::uint8_t> is_taken_, goes_;
  std::map<Index, std::vector<Origin>> more_origins_;
};

}  // namespace

ClosedPockets close_pockets(Complex& complex, double distance, Index first_side,
                            const std::vector<std::vector<Index>>& parts) {
  ClosedPockets done;
  while (PocketRound(complex, distance, first_side, Parts(parts)).run(done)) {
  }
  return done;
}

}  // namespace geomesh::geomodel::arrangement

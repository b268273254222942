// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/pockets/cut_dangling_faces.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "arrangement/model/surface_ends.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

/// Largest number of facets of a dangling piece: the remains of a needle have few.
constexpr std::size_t most_facets = 64;

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
  return length(p - (a + t * along));
}

/// Most halvings of a facet to prove that it is near the hinge, the edges along which it is attached.
constexpr int most_halvings = 24;

/// Returns whether all of the triangle is within the distance of a set of edges. A triangle with all corners near the
/// same edge is, because the places within the distance of one edge form a convex set.
bool is_within(const std::array<Vec3, 3>& t, const std::vector<std::array<Vec3, 2>>& edges, double distance,
               int halvings = most_halvings) {
  for (const auto& e : edges) {
    std::size_t n = 0;
    for (const Vec3& p : t) n += distance_to_segment(p, e[0], e[1]) <= distance ? 1 : 0;
    if (n == 3) return true;
  }
  const bool corners_near = std::all_of(t.begin(), t.end(), [&](const Vec3& p) {
    return std::any_of(edges.begin(), edges.end(),
                       [&](const auto& e) { return distance_to_segment(p, e[0], e[1]) <= distance; });
  });
  if (!corners_near || halvings == 0) return false;
  std::size_t longest = 0;
  const auto side = [&](std::size_t k) { return length(t[(k + 1) % 3] - t[k]); };
  for (std::size_t k = 1; k < 3; ++k)
    if (side(k) > side(longest)) longest = k;
  if (side(longest) <= distance / 16) return true;  // a triangle this small counts as near if its corners are near
  const Vec3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3], middle = 0.5 * (a + b);
  return is_within({a, middle, c}, edges, distance, halvings - 1) &&
         is_within({middle, b, c}, edges, distance, halvings - 1);
}

struct DanglingPiece {
  std::vector<Index> facets;
  std::vector<EdgeKey> hinge;
  Displacement way;  ///< distance and place of the dangling piece's corner farthest from the edges that attach it
};

/// The facets of one surface, by the edges at which they lie.
class SurfaceFacets {
 public:
  SurfaceFacets(const Complex& complex, const std::vector<Index>& facets) : complex_(complex) {
    for (const Index f : facets)
      for (const EdgeKey& e : edges_of(complex.facets[f])) at_[e].push_back(f);
  }
  /// Removes and returns the dangling pieces of the surface that are within the distance of their hinge (the edges
  /// along which they are attached). If pieces share a hinge, the one with the first free edge, in the order of vertex
  /// indices, comes first.
  std::vector<DanglingPiece> take_dangling_pieces(double distance) {
    std::vector<DanglingPiece> pieces;
    for (std::vector<Index>& facets : pieces_that_end()) {
      DanglingPiece piece{std::move(facets), {}, {}};
      piece.hinge = hinge_of(piece.facets);
      if (piece.hinge.empty()) continue;
      piece.way = way_to(piece.hinge, piece.facets);
      if (piece.way.largest > distance || !lies_along(piece, distance)) continue;
      for (const Index f : piece.facets)
        for (const EdgeKey& e : edges_of(complex_.facets[f])) std::erase(at_[e], f);
      pieces.push_back(std::move(piece));
    }
    return pieces;
  }

 private:
  std::vector<std::vector<Index>> pieces_that_end() const {
    std::vector<std::vector<Index>> pieces;
    std::set<Index> seen;
    for (const auto& [edge, facets] : at_)
      if (facets.size() == 1 && !seen.contains(facets[0])) {
        std::vector<Index> piece = piece_of(facets[0]);
        seen.insert(piece.begin(), piece.end());
        if (piece.size() <= most_facets) pieces.push_back(std::move(piece));
      }
    return pieces;
  }
  /// Returns the piece of the surface connected with `first` through edges with two facets. Stops early if it has more
  /// facets than a dangling piece can have.
  std::vector<Index> piece_of(Index first) const {
    std::vector<Index> piece{first};
    for (std::size_t k = 0; k < piece.size() && piece.size() <= most_facets; ++k)
      for (const EdgeKey& e : edges_of(complex_.facets[piece[k]])) {
        const std::vector<Index>& facets = at_.at(e);
        if (facets.size() != 2) continue;
        const Index other = facets[0] == piece[k] ? facets[1] : facets[0];
        if (std::find(piece.begin(), piece.end(), other) == piece.end()) piece.push_back(other);
      }
    return piece;
  }
  /// Returns the hinge of a piece, its edges at which the surface has three facets or more; empty if there are none, or
  /// if the surface would end at the hinge without the piece.
  std::vector<EdgeKey> hinge_of(const std::vector<Index>& piece) const {
    std::map<EdgeKey, std::size_t> own;
    for (const Index f : piece)
      for (const EdgeKey& e : edges_of(complex_.facets[f])) ++own[e];
    std::vector<EdgeKey> hinge;
    for (const auto& [e, n] : own) {
      const std::size_t all = at_.at(e).size();
      if (all < 3) continue;
      if (all - n < 2) return {};
      hinge.push_back(e);
    }
    return hinge;
  }
  /// Returns whether all of the dangling piece, and not only its corners, is within the distance of its hinge.
  bool lies_along(const DanglingPiece& piece, double distance) const {
    std::vector<std::array<Vec3, 2>> hinge;
    for (const EdgeKey& e : piece.hinge) hinge.push_back({complex_.points[e.first], complex_.points[e.second]});
    return std::all_of(piece.facets.begin(), piece.facets.end(), [&](Index f) {
      const Triangle& t = complex_.facets[f];
      return is_within({complex_.points[t[0]], complex_.points[t[1]], complex_.points[t[2]]}, hinge, distance);
    });
  }
  Displacement way_to(const std::vector<EdgeKey>& hinge, const std::vector<Index>& piece) const {
    Displacement way;
    for (const Index f : piece)
      for (const VertexIndex v : complex_.facets[f]) {
        double least = std::numeric_limits<double>::infinity();
        for (const EdgeKey& e : hinge)
          least = std::min(
              least, distance_to_segment(complex_.points[v], complex_.points[e.first], complex_.points[e.second]));
        if (least > way.largest) {
          way.largest = least;
          way.where = complex_.points[v];
        }
      }
    return way;
  }

  const Complex& complex_;
  std::map<EdgeKey, std::vector<Index>> at_;
};

std::map<Index, std::vector<Index>> facets_of_branching_surfaces(const Complex& complex) {
  std::map<Index, std::vector<Index>> facets_of;
  for (const Index surface : branching_surfaces(complex)) facets_of[surface];
  if (facets_of.empty()) return facets_of;
  for (Index f = 0; f < complex.facets.size(); ++f) {
    Index last = no_index;  // a facet's origins (input triangles) are grouped by surface
    for (const Origin& o : complex.origins.of(f))
      if (o.surface != std::exchange(last, o.surface))
        if (const auto at = facets_of.find(o.surface); at != facets_of.end()) at->second.push_back(f);
  }
  return facets_of;
}

using FacetsAtEdges = std::map<EdgeKey, std::vector<Index>>;

/// Other surfaces that meet a dangling piece, without containing it, at edges other than its hinge.
struct Borne {
  /// Origin (input triangle) of a surface that ends on the dangling piece; `reversed` if their orientations differ.
  std::optional<Origin> ending;
  /// Whether the surface that meets the dangling piece continues beyond it, or several surfaces meet the piece.
  bool by_others = false;
};

/// The surface that a facet loses, and the origin (input triangle) that it receives if it has no other.
struct Change {
  Index surface;
  std::optional<Origin> instead;
};
using Changes = std::map<Index, Change>;  ///< by facet

/// Returns whether a facet of the dangling piece, or one at its edges other than the hinge, already loses a surface.
bool is_beside_a_change(const FacetsAtEdges& at, const Changes& changes, const Complex& complex,
                        const DanglingPiece& piece) {
  for (const Index f : piece.facets)
    for (const EdgeKey& e : edges_of(complex.facets[f])) {
      const std::vector<Index>& facets = at.at(e);
      const bool is_hinge = std::find(piece.hinge.begin(), piece.hinge.end(), e) != piece.hinge.end();
      if (changes.contains(f) || (!is_hinge && std::any_of(facets.begin(), facets.end(),
                                                           [&](Index other) { return changes.contains(other); })))
        return true;
    }
  return false;
}

Borne borne_by(const Complex& complex, const FacetsAtEdges& at, const DanglingPiece& piece) {
  Borne borne;
  for (const Index f : piece.facets) {
    if (complex.origins.of(f).size() > 1) continue;
    for (const EdgeKey& e : edges_of(complex.facets[f])) {
      if (std::find(piece.hinge.begin(), piece.hinge.end(), e) != piece.hinge.end()) continue;
      std::size_t n_beside = 0;
      for (const Index other : at.at(e)) {
        if (std::find(piece.facets.begin(), piece.facets.end(), other) != piece.facets.end()) continue;
        Origin on =
            carried_over(complex.origins.of(other)[0], complex.facets[other], complex.facets[f], e.first, e.second);
        on.reversed = on.reversed != complex.origins.of(f)[0].reversed;
        if (!borne.ending) borne.ending = on;
        if (++n_beside > 1 || complex.origins.of(other).size() > 1 || borne.ending->surface != on.surface ||
            borne.ending->reversed != on.reversed)
          borne.by_others = true;
      }
    }
  }
  return borne;
}

FacetsAtEdges facets_at(const Complex& complex, const std::vector<std::pair<Index, DanglingPiece>>& pieces) {
  FacetsAtEdges at;
  for (const auto& [surface, piece] : pieces)
    for (const Index f : piece.facets)
      for (const EdgeKey& e : edges_of(complex.facets[f])) at[e];
  if (at.empty()) return at;
  for (Index f = 0; f < complex.facets.size(); ++f)
    for (const EdgeKey& e : edges_of(complex.facets[f]))
      if (const auto found = at.find(e); found != at.end()) found->second.push_back(f);
  return at;
}

}  // namespace

CutDanglingFaces cut_dangling_faces(Complex& complex, double distance) {
  std::vector<std::pair<Index, DanglingPiece>> pieces;  // with their surfaces
  for (const auto& [surface, facets] : facets_of_branching_surfaces(complex))
    for (DanglingPiece& piece : SurfaceFacets(complex, facets).take_dangling_pieces(distance))
      pieces.emplace_back(surface, std::move(piece));
  const FacetsAtEdges at = facets_at(complex, pieces);
  CutDanglingFaces done;
  Changes changes;
  for (const auto& [surface, piece] : pieces) {
    const Borne borne = borne_by(complex, at, piece);
    if (borne.by_others || is_beside_a_change(at, changes, complex, piece)) continue;
    for (const Index f : piece.facets) {
      changes.emplace(f, Change{surface, borne.ending});
      const Triangle& t = complex.facets[f];
      done.vanished.push_back({{surface}, {complex.points[t[0]], complex.points[t[1]], complex.points[t[2]]}});
    }
    if (piece.way.largest > done.moved.largest) done.moved = piece.way;
    ++done.n_pieces;
  }
  if (changes.empty()) return done;
  edit_origins(complex, [&](Index f, std::vector<Origin>& of) {
    const auto found = changes.find(f);
    if (found == changes.end()) return;
    const Change& change = found->second;
    const bool was_alone = of.size() == 1, reversed = of[0].reversed;
    std::erase_if(of, [&](const Origin& o) { return o.surface == change.surface; });
    if (!was_alone || !change.instead) return;
    of.push_back(*change.instead);
    of[0].reversed = of[0].reversed != reversed;
  });
  return done;
}

}  // namespace geomesh::geomodel::arrangement

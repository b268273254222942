// SPDX-License-Identifier: MIT
/// @file
/// Determines on which side of the plane of three vertices each of up to 64 vertices lies, as bit masks. The plane of
/// each triple is decided once and exactly, when it is first needed or together with all others.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "predicates/filters.hpp"
#include "recover/model/constrained_mesh.hpp"

namespace geomesh::recover {

/// Index of a vertex among the vertices of one polyhedron, below 64.
using LocalVertex = std::uint8_t;
using LocalTriangle = std::array<LocalVertex, 3>;
using VertexMask = std::uint64_t;

constexpr VertexMask bit(LocalVertex v) { return VertexMask{1} << v; }
constexpr VertexMask mask_of(const LocalTriangle& t) { return bit(t[0]) | bit(t[1]) | bit(t[2]); }

/// Positions of the vertices of a polyhedron, for computing determinants of vectors between them with error bounds.
class LocalPlaces {
 public:
  LocalPlaces(const ConstrainedMesh& mesh, const std::vector<VertexIndex>& vertices) {
    const ExactPlaces& exact = mesh.exact_places();
    for (const VertexIndex v : vertices) {
      if (exact.contains(v)) exact_ |= bit(static_cast<LocalVertex>(near_.size()));
      near_.push_back(mesh.point(v));
      rest_.push_back(exact.rest_of(v));
    }
    if (vertices.empty()) return;
    const ExactPlaces::OffsetError error = mesh.offset_error(vertices[0], vertices);
    // The error bound of determinants is for vectors from the first vertex. Vectors between other vertices are at most
    // twice as long, and products of two of them four times as large.
    error_bound_ = {error.widening, 4 * error.slack};
  }

  std::size_t size() const { return near_.size(); }
  struct From {
    const Vec3 *near, *rest;
    Vec3 of_near, of_rest;
    Vec3 operator()(std::size_t to) const { return (near[to] - of_near) + (rest[to] - of_rest); }
  };
  From offsets_from(std::size_t v) const { return {near_.data(), rest_.data(), near_[v], rest_[v]}; }
  /// Terms of the error bound of a 3 x 3 determinant of vectors between vertices, computed in doubles.
  struct ErrorBound {
    double widening = 1, slack = 0;
    double operator()(const filter::Estimate& estimate) const { return widening * estimate.error + slack; }
  };
  ErrorBound error_bound() const { return error_bound_; }
  /// Returns how many tetrahedra of one triangle and another vertex have a vertex whose coordinates are not doubles.
  std::size_t n_exact_about(VertexMask triangle) const {
    return (triangle & exact_) != 0 ? size() - 3 : static_cast<std::size_t>(std::popcount(exact_));
  }

 private:
  std::vector<Vec3> near_, rest_;  ///< the nearest double of each vertex' place, and the place minus that double
  VertexMask exact_ = 0;           ///< set of vertices whose coordinates are not doubles
  ErrorBound error_bound_;
};

class SideMasks {
 public:
  static constexpr std::size_t max_vertices = 64;
  /// The vertices v for which the cell (t, v) on a triangle t is positive, and those for which it is negative.
  using Masks = std::pair<VertexMask, VertexMask>;

  // Triples i < j < k are numbered by a sum of binomial coefficients (the combinatorial number system).
  static constexpr std::size_t n_triples(std::size_t n) { return n * (n - 1) * (n - 2) / 6; }
  static constexpr std::size_t row_of(std::size_t i, std::size_t j, std::size_t k) {
    return n_triples(k) + j * (j - 1) / 2 + i;
  }
  /// Sorts the vertices in increasing order; returns whether that is an odd permutation.
  static bool sort(LocalTriangle& t) {
    bool odd = false;
    for (const auto& [i, j] : {std::pair{0u, 1u}, std::pair{1u, 2u}, std::pair{0u, 1u}})
      if (t[i] > t[j]) {
        std::swap(t[i], t[j]);
        odd = !odd;
      }
    return odd;
  }

  /// `vertices` are at most max_vertices vertices of the mesh. Their positions in this list are their local numbers.
  SideMasks(const ConstrainedMesh& mesh, const std::vector<VertexIndex>& vertices)
      : mesh_(mesh), vertices_(vertices), places_(mesh, vertices), row_(n_triples(vertices.size()), 0) {}

  /// Decides the sides of all planes of three vertices, for callers that need most: O(n^4 / 24) determinants instead of
  /// O(n^4 / 6), with common parts computed outside the loops.
  void decide_all() {
    const std::size_t n = vertices_.size();
    known_.assign(n_triples(n), {0, 0});
    for (std::size_t row = 0; row < row_.size(); ++row) row_[row] = static_cast<std::uint32_t>(row + 1);
    if (mesh_.has_exact_places()) mesh_.exact_places().count_decided(n_triples(n) * (n - 3) / 4);
    for (std::size_t l = 3; l < n; ++l) {
      offsets_.clear();
      for (std::size_t i = 0; i < l; ++i) offsets_.push_back(places_.offsets_from(l)(i));
      for (std::size_t k = 2; k < l; ++k)
        for (std::size_t j = 1; j < k; ++j) decide_below(j, k, l);
    }
  }

  /// @name Masks of the vertices above and below a plane of three vertices; decide_all() must have been called
  /// @{
  const Masks& of_row(std::size_t row) const { return known_[row]; }
  const Masks& of_sorted(LocalVertex i, LocalVertex j, LocalVertex k) const { return known_[row_of(i, j, k)]; }
  /// Returns masks of the vertices above and below the plane of vertices i, j and k, oriented in this order; i < j.
  Masks of_edge(LocalVertex i, LocalVertex j, LocalVertex k) const {
    if (k < i) return of_sorted(k, i, j);
    if (k > j) return of_sorted(i, j, k);
    const Masks& m = of_sorted(i, k, j);
    return {m.second, m.first};
  }
  /// @}

  Masks sides(const LocalTriangle& t) {
    LocalTriangle s = t;
    const bool odd = sort(s);
    std::uint32_t& row = row_[row_of(s[0], s[1], s[2])];
    if (row == 0) {
      known_.push_back(decide(s));
      row = static_cast<std::uint32_t>(known_.size());
    }
    const Masks& m = known_[row - 1];
    return odd ? Masks{m.second, m.first} : m;
  }
  /// Returns the vertices v above the plane of triangle t, for which the tetrahedron (t, v) is positive.
  VertexMask above(const LocalTriangle& t) { return sides(t).first; }
  /// Returns the vertices v below the plane of triangle t, for which the tetrahedron (t, v) is negative.
  VertexMask below(const LocalTriangle& t) { return sides(t).second; }
  /// Returns the orientation of the tetrahedron (a, b, c, d): 1 if positive, 0 if flat, -1 if negative.
  int sign(LocalVertex a, LocalVertex b, LocalVertex c, LocalVertex d) {
    const auto [above, below] = sides({a, b, c});
    return above & bit(d) ? 1 : below & bit(d) ? -1 : 0;
  }

 private:
  /// Decides on which side of triangle t each vertex lies. Signs in a polyhedron are unpredictable, so all vertices are
  /// estimated without a branch, and uncertain ones are decided afterwards.
  Masks decide(const LocalTriangle& t) const {
    if (mesh_.has_exact_places()) mesh_.exact_places().count_decided(places_.n_exact_about(mask_of(t)));
    const LocalPlaces::From offset_to = places_.offsets_from(t[2]);
    const LocalPlaces::ErrorBound error_of = places_.error_bound();
    const filter::Orient3dOfMany estimate_of(offset_to(t[0]), offset_to(t[1]));
    VertexMask positive = 0, negative = 0;
    for (std::size_t v = 0; v < places_.size(); ++v) {
      const filter::Estimate estimate = estimate_of(offset_to(v));
      const double error = error_of(estimate);
      positive |= VertexMask{estimate.value < -error} << v;
      negative |= VertexMask{estimate.value > error} << v;
    }
    Masks out{positive & ~mask_of(t), negative & ~mask_of(t)};
    for (VertexMask left = all() & ~(positive | negative | mask_of(t)); left != 0; left &= left - 1) {
      const LocalVertex v = static_cast<LocalVertex>(std::countr_zero(left));
      const Sign s = mesh_.orient(vertices_[t[0]], vertices_[t[1]], vertices_[t[2]], vertices_[v]);
      if (s == Sign::positive) out.first |= bit(v);
      if (s == Sign::negative) out.second |= bit(v);
    }
    return out;
  }
  VertexMask all() const {
    return vertices_.size() == max_vertices ? ~VertexMask{0} : (VertexMask{1} << vertices_.size()) - 1;
  }

  /// Finds the orientations of the tetrahedra (i, j, k, l) for all i < j. Signs are estimated without a branch, because
  /// they are unpredictable; uncertain ones are decided exactly afterwards.
  void decide_below(std::size_t j, std::size_t k, std::size_t l) {
    const filter::Orient3dOfMany estimate_of(offsets_[j], offsets_[k]);
    const LocalPlaces::ErrorBound error_of = places_.error_bound();
    Masks *const jk = &known_[row_of(0, j, k)], *const jl = &known_[row_of(0, j, l)],
                 *const kl = &known_[row_of(0, k, l)];
    VertexMask positive = 0, negative = 0;
    for (std::size_t i = 0; i < j; ++i) {
      const filter::Estimate estimate = estimate_of(offsets_[i]);
      const double error = error_of(estimate);
      const VertexMask p = estimate.value > error ? 1 : 0, n = estimate.value < -error ? 1 : 0;
      jk[i].first |= p << l, jk[i].second |= n << l;
      jl[i].first |= n << k, jl[i].second |= p << k;
      kl[i].first |= p << j, kl[i].second |= n << j;
      positive |= p << i, negative |= n << i;
    }
    Masks& of_others = known_[row_of(j, k, l)];
    of_others.first |= negative, of_others.second |= positive;
    for (VertexMask left = ((VertexMask{1} << j) - 1) & ~(positive | negative); left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const Sign s = mesh_.orient(vertices_[i], vertices_[j], vertices_[k], vertices_[l]);
      if (s != Sign::zero) put(i, j, k, l, s);
    }
  }
  /// Stores on which side of each face of the tetrahedron (i, j, k, l) the opposite vertex lies. `sign`: orientation.
  void put(std::size_t i, std::size_t j, std::size_t k, std::size_t l, Sign sign) {
    const auto put_side = [&](std::size_t row, std::size_t v, Sign side) {
      (side == Sign::positive ? known_[row].first : known_[row].second) |= bit(static_cast<LocalVertex>(v));
    };
    put_side(row_of(i, j, k), l, sign);
    put_side(row_of(i, j, l), k, -sign);
    put_side(row_of(i, k, l), j, sign);
    put_side(row_of(j, k, l), i, -sign);
  }

  const ConstrainedMesh& mesh_;
  const std::vector<VertexIndex>& vertices_;
  const LocalPlaces places_;
  std::vector<std::uint32_t> row_;  ///< by triple of vertices: 1 + the row of its masks in known_; 0 if not computed
  std::vector<Masks> known_;
  std::vector<Vec3> offsets_;  ///< vectors from one vertex of the polyhedron to the others
};

}  // namespace geomesh::recover

// SPDX-License-Identifier: MIT
#include "recover/exact/exact_places.hpp"

#include <algorithm>
#include <cmath>

#include "geomesh/core/predicates.hpp"
#include "predicates/two_double.hpp"

namespace geomesh::recover {

using exact::LongExpansion, exact::TwoDouble;

bool ExactPlace::is_safe() const {
  return std::all_of(coordinates.begin(), coordinates.end(), [](const LongExpansion& x) {
    return x.is_zero() || (x.least_term() > 0x1p-240 && std::fabs(x.terms().back()) < 0x1p240);
  });
}

void ExactPlaces::set(VertexIndex v, ExactPlace place) {
  if (first_ == no_vertex) first_ = v;
  if (v < first_) {
    row_of_.insert(row_of_.begin(), first_ - v, no_index);
    first_ = v;
  }
  if (v - first_ >= row_of_.size()) row_of_.resize(v - first_ + 1, no_index);
  Index& row = row_of_[v - first_];
  if (row == no_index) {
    row = static_cast<Index>(rows_.size());
    rows_.emplace_back();
  }
  const Vec3 near = place.nearest();
  for (std::size_t i = 0; i < 3; ++i) rows_[row].rest[i] = (place.coordinates[i] - LongExpansion(near[i])).estimate();
  rows_[row].is_between_ends = place.is_on_line() && place.parameter.sign() == Sign::positive &&
                               (LongExpansion(1) - place.parameter).sign() == Sign::positive;
  rows_[row].place = std::move(place);
}

void ExactPlaces::erase(VertexIndex v) {
  if (!contains(v)) return;
  const Index row = row_of_[v - first_];
  row_of_[v - first_] = no_index;
  if (row + 1u < rows_.size()) {
    rows_[row] = std::move(rows_.back());
    *std::find(row_of_.begin(), row_of_.end(), static_cast<Index>(rows_.size() - 1)) = row;
  }
  rows_.pop_back();
}

LongExpansion ExactPlaces::coordinate(const std::vector<Vec3>& points, VertexIndex v, std::size_t i) const {
  return contains(v) ? of(v).coordinates[i] : LongExpansion(points[v][i]);
}

Vec3 ExactPlaces::offset(const std::vector<Vec3>& points, VertexIndex from, VertexIndex to) const {
  const Vec3 near = points[to] - points[from];
  if (!contains(from) && !contains(to)) return near;
  return near + (rest_of(to) - rest_of(from));
}

LongExpansion ExactPlaces::volume(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const {
  std::array<std::array<LongExpansion, 3>, 3> d;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) d[k][i] = coordinate(points, v[k + 1], i) - coordinate(points, v[0], i);
  const auto minor = [&](std::size_t i, std::size_t j) { return d[1][i] * d[2][j] - d[1][j] * d[2][i]; };
  return d[0][0] * minor(1, 2) + d[0][1] * minor(2, 0) + d[0][2] * minor(0, 1);
}

namespace {

template <class Number>
Number determinant(const std::array<std::array<Number, 3>, 3>& u) {
  const auto minor = [&](std::size_t i, std::size_t j) { return u[0][i] * u[1][j] - u[0][j] * u[1][i]; };
  return u[2][2] * minor(0, 1) + u[2][0] * minor(1, 2) + u[2][1] * minor(2, 0);
}

}  // namespace

/// Returns whether four vertices are known to be coplanar, because one of them was placed exactly in a plane or on a
/// line and the others lie there by declaration.
bool ExactPlaces::are_declared_flat(const std::array<VertexIndex, 4>& v) const {
  for (const VertexIndex x : v) {
    if (!contains(x)) continue;
    const ExactPlace& place = of(x);
    if (place.frame[1] == no_vertex) continue;
    const auto& frame = place.frame;
    const auto in = [&](VertexIndex u) { return u == frame[0] || u == frame[1] || (u == frame[2] && u != no_vertex); };
    const auto is_in_frame = [&](VertexIndex w) {
      if (w == x || in(w)) return true;
      if (!contains(w)) return false;
      const auto& other = of(w).frame;
      return other[1] != no_vertex && in(other[0]) && in(other[1]) && (other[2] == no_vertex || in(other[2]));
    };
    int may_miss = place.is_on_line() ? 1 : 0;  // three collinear points are coplanar with any fourth
    for (const VertexIndex w : v)
      if (!is_in_frame(w) && --may_miss < 0) break;
    if (may_miss >= 0) return true;
  }
  return false;
}

/// Returns whether four points lie in a plane perpendicular to an axis, because they have equal coordinates there that
/// are exact in doubles.
bool ExactPlaces::are_in_plane_across_axis(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const {
  for (std::size_t i = 0; i < 3; ++i)
    if (std::all_of(v.begin(), v.end(),
                    [&](VertexIndex w) { return points[w][i] == points[v[0]][i] && rest_of(w)[i] == 0; }))
      return true;
  return false;
}

// Error bounds. The nearest double and the rounded rest give a coordinate with a relative error of 2^-105. The
// difference of two coordinates therefore has two errors: 4 units of itself, and 2^-103 of the greater coordinate. The
// bound of the first filter is that of filters.hpp, trebled for the first error, plus six products with one factor that
// has the second error. The second filter works with a precision of about 2^-104; its bound, 2^-96 of the greatest
// product, leaves room for 256 roundings.
namespace {

constexpr double widening_of_rests = 3;

/// Returns the error bound of a 3 x 3 determinant whose columns have entries up to `reach` with errors up to `wrong`.
double error_by_rests(const Vec3& reach, const Vec3& wrong) {
  return 8 *
         (wrong.x * (reach.y + wrong.y) * (reach.z + wrong.z) + (reach.x + wrong.x) * wrong.y * (reach.z + wrong.z) +
          (reach.x + wrong.x) * (reach.y + wrong.y) * wrong.z);
}

Vec3 larger(const Vec3& a, const Vec3& b) {
  return {std::max(a.x, std::fabs(b.x)), std::max(a.y, std::fabs(b.y)), std::max(a.z, std::fabs(b.z))};
}

}  // namespace

ExactPlaces::OffsetError ExactPlaces::offset_error(const std::vector<Vec3>& points, VertexIndex from,
                                                   std::span<const VertexIndex> to) const {
  if (empty()) return {};
  Vec3 largest = larger({}, points[from]), reach;
  for (const VertexIndex v : to) {
    largest = larger(largest, points[v]);
    reach = larger(reach, offset(points, from, v));
  }
  return {widening_of_rests, error_by_rests(reach, 0x1p-102 * largest)};
}

ExactPlaces::Rough ExactPlaces::rough(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const {
  Vec3 largest = larger({}, points[v[3]]), reach;
  std::array<std::array<double, 3>, 3> u;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 d = offset(points, v[3], v[k]);
    u[k] = {d.x, d.y, d.z};
    largest = larger(largest, points[v[k]]);
    reach = larger(reach, d);
  }
  const double product = reach.x * reach.y * reach.z, by_rests = error_by_rests(reach, 0x1p-102 * largest);
  return {{-determinant(u), widening_of_rests * filter::orient3d_factor * product + by_rests}, product, by_rests};
}

filter::Estimate ExactPlaces::sharp(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v,
                                    const Rough& of) const {
  std::array<std::array<TwoDouble, 3>, 3> w;
  const Vec3 rest = rest_of(v[3]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 own = rest_of(v[k]);
    for (std::size_t i = 0; i < 3; ++i)
      w[k][i] = TwoDouble::difference(points[v[k]][i], points[v[3]][i]) + TwoDouble::difference(own[i], rest[i]);
  }
  return {-determinant(w).hi, 0x1p-96 * of.product + of.by_rests};
}

/// Computes the orientation determinant of the points rounded to doubles, and its error bound. Rounding changes each
/// coordinate by at most an ulp, and an offset from d by at most 2^-51 (|d| + |offset|).
filter::Estimate ExactPlaces::of_nearest(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const {
  const Vec3& d = points[v[3]];
  const Vec3 a = points[v[0]] - d, b = points[v[1]] - d, c = points[v[2]] - d;
  const auto reach_along = [&](std::size_t i) {
    return filter::max3(std::fabs(a[i]), std::fabs(b[i]), std::fabs(c[i]));
  };
  const Vec3 reach{reach_along(0), reach_along(1), reach_along(2)};
  const Vec3 wrong = 0x1p-51 * Vec3{std::fabs(d.x) + reach.x, std::fabs(d.y) + reach.y, std::fabs(d.z) + reach.z};
  const double det = a.z * (b.x * c.y - b.y * c.x) + b.z * (c.x * a.y - c.y * a.x) + c.z * (a.x * b.y - a.y * b.x);
  return {-det, filter::orient3d_factor * reach.x * reach.y * reach.z + error_by_rests(reach, wrong)};
}

Sign ExactPlaces::side_of_end(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const {
  if (std::none_of(v.begin(), v.end(), [&](VertexIndex w) { return contains(w); }))
    return orient3d(points[v[0]], points[v[1]], points[v[2]], points[v[3]]);
  return decide(points, v);
}

/// Finds the orientation of four vertices if one of them was placed between the ends of a line whose ends lie on one
/// side of the plane of the other three, or one of them in it: then the vertex is on that side, too.
std::optional<Sign> ExactPlaces::side_of_line(const std::vector<Vec3>& points,
                                              const std::array<VertexIndex, 4>& v) const {
  for (std::size_t k = 0; k < 4; ++k) {
    if (!contains(v[k]) || !rows_[row_of_[v[k] - first_]].is_between_ends) continue;
    const auto& frame = of(v[k]).frame;
    if (frame[0] >= first_ || frame[1] >= first_) continue;
    std::array<Sign, 2> sides;
    for (std::size_t end = 0; end < 2; ++end) {
      std::array<VertexIndex, 4> w = v;
      w[k] = frame[end];
      sides[end] = std::count(w.begin(), w.end(), frame[end]) > 1 ? Sign::zero : side_of_end(points, w);
    }
    if (sides[0] != -sides[1] || sides[0] == Sign::zero) return sides[0] == Sign::zero ? sides[1] : sides[0];
  }
  return std::nullopt;
}

Sign ExactPlaces::orient(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const {
  count_decided(1);
  return decide(points, v);
}

Sign ExactPlaces::decide(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const {
  const filter::Estimate first = of_nearest(points, v);
  if (first.certain()) return first.sign();
  if (are_declared_flat(v) || are_in_plane_across_axis(points, v)) return Sign::zero;
  if (const std::optional<Sign> side = side_of_line(points, v)) return *side;
  const Rough near = rough(points, v);
  if (near.plain.certain()) return near.plain.sign();
  const filter::Estimate nearer = sharp(points, v, near);
  return nearer.certain() ? nearer.sign() : volume(points, v).sign();
}

double ExactPlaces::rough_volume(const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) const {
  constexpr double most_part = 0x1p20;
  const auto is_good = [](const filter::Estimate& e) { return std::fabs(e.value) > most_part * e.error; };
  const Rough near = rough(points, v);
  if (is_good(near.plain)) return near.plain.value;
  const filter::Estimate nearer = sharp(points, v, near);
  return is_good(nearer) ? nearer.value : volume(points, v).estimate();
}

Sign ExactPlaces::orient_flat(const std::vector<Vec3>& points, const std::array<VertexIndex, 3>& v, std::size_t i,
                              std::size_t j) const {
  if (!contains(v[0]) && !contains(v[1]) && !contains(v[2]))
    return orient2d({points[v[0]][i], points[v[0]][j]}, {points[v[1]][i], points[v[1]][j]},
                    {points[v[2]][i], points[v[2]][j]});
  const auto difference = [&](VertexIndex w, std::size_t k) {
    return coordinate(points, w, k) - coordinate(points, v[0], k);
  };
  return (difference(v[1], i) * difference(v[2], j) - difference(v[1], j) * difference(v[2], i)).sign();
}

}  // namespace geomesh::recover

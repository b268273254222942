// SPDX-License-Identifier: MIT
#include "recover/rounding/wide_polyhedron.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "recover/model/recovery_budget.hpp"

namespace geomesh::recover {

using exact::TwoDouble;

namespace {

using Row = std::array<double, 3>;
using Steps = std::array<std::int64_t, 3>;  ///< coordinates of a lattice point as multiples of the spacing

constexpr double too_many_steps = 0x1p60;  ///< limit on lattice coordinates, so that sums of a few fit into 64 bits

TwoDouble dot(const WidePoint& a, const WidePoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double dot(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

WidePoint scaled(double factor, const WidePoint& a) {
  return {TwoDouble{factor} * a[0], TwoDouble{factor} * a[1], TwoDouble{factor} * a[2]};
}
WidePoint sum(const WidePoint& a, const WidePoint& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

/// QR decomposition: replaces a matrix of three columns by one with orthonormal columns; stores the triangular factor.
struct Triangular {
  std::array<Row, 3> at{};  ///< upper triangular factor of a QR decomposition, by row and column

  explicit Triangular(std::vector<Row>& rows) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (int twice = 0; twice < 2; ++twice)
        for (std::size_t j = 0; j < k; ++j) {
          double along = 0;
          for (const Row& r : rows) along += r[j] * r[k];
          for (Row& r : rows) r[k] -= along * r[j];
          at[j][k] += along;
        }
      double square = 0;
      for (const Row& r : rows) square += r[k] * r[k];
      at[k][k] = std::sqrt(square);
      for (Row& r : rows) r[k] /= at[k][k];
    }
  }
  /// Returns whether the first `n` columns of the decomposed matrix are independent, as far as doubles show.
  bool is_regular(std::size_t n = 3) const {
    for (std::size_t k = 0; k < n; ++k)
      if (!(at[k][k] > 0) || !std::isfinite(at[0][k] + at[1][k] + at[2][k])) return false;
    return true;
  }
  /// Solves R x = b with the triangular factor R of the QR decomposition, and returns x.
  Row solve(const Row& b) const {
    Row x{};
    x[2] = b[2] / at[2][2];
    x[1] = (b[1] - at[1][2] * x[2]) / at[1][1];
    x[0] = (b[0] - at[0][1] * x[1] - at[0][2] * x[2]) / at[0][0];
    return x;
  }
};

/// The analytic centre: the point with the greatest product of the heights over all planes. An ellipsoid around it lies
/// inside the polyhedron, which lies inside the same ellipsoid scaled by the number of planes.
class AnalyticCentre {
 public:
  explicit AnalyticCentre(const WidePolyhedron& polyhedron) : planes_(polyhedron.planes), place_(polyhedron.inside) {
    for (std::size_t k = 0; k < 3; ++k) frame_[k][k] = TwoDouble{1};
    heights_ = heights_at(place_);
  }

  /// Finds the analytic centre by Newton's method. Returns false if rounding prevents progress.
  bool find() {
    for (unsigned i = 0; i < recovery_budget.analytic_steps; ++i) {
      const auto rows = rows_in_round_frame();
      if (!rows) return false;
      Row step{};
      for (const Row& r : *rows)
        for (std::size_t k = 0; k < 3; ++k) step[k] += r[k];
      const double decrement = std::sqrt(dot(step, step));
      if (decrement < near_enough) return true;
      if (!go(step, length_along(*rows, step))) return false;
    }
    return true;
  }

  const WidePoint& place() const { return place_; }
  const std::vector<double>& heights() const { return heights_; }

 private:
  /// Newton's method ends if a step is shorter than this share of the inner ellipsoid's radius in its direction.
  static constexpr double near_enough = 0.1;

  std::vector<double> heights_at(const WidePoint& p) const {
    std::vector<double> out;
    for (const WidePlane& plane : planes_) out.push_back((plane.at + dot(plane.normal, p)).hi);
    return out;
  }
  /// Returns each plane's normal divided by its height, in a frame in which the inner ellipsoid is a ball. The frame is
  /// found in rounds of a QR decomposition in doubles. It is stored in twice that precision, so that each round gains
  /// the digits of a double.
  std::optional<std::vector<Row>> rows_in_round_frame() {
    constexpr unsigned most_rounds = 8;
    constexpr double nearly = 1e-3;
    for (unsigned round = 0; round < most_rounds; ++round) {
      std::vector<Row> rows;
      for (std::size_t i = 0; i < planes_.size(); ++i) {
        Row& r = rows.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) r[k] = dot(planes_[i].normal, frame_[k]).hi / heights_[i];
      }
      const Triangular triangle(rows);
      if (!triangle.is_regular()) return std::nullopt;
      turn_frame(triangle);
      double off = 0;
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) off = std::max(off, std::fabs(triangle.at[j][k] - (j == k)));
      if (off < nearly) return rows;
    }
    return std::nullopt;
  }
  void turn_frame(const Triangular& triangle) {
    const auto& r = triangle.at;
    frame_[0] = scaled(1 / r[0][0], frame_[0]);
    frame_[1] = scaled(1 / r[1][1], sum(frame_[1], scaled(-r[0][1], frame_[0])));
    frame_[2] = scaled(1 / r[2][2], sum(frame_[2], sum(scaled(-r[0][2], frame_[0]), scaled(-r[1][2], frame_[1]))));
  }
  /// Returns the multiple of `step` at which the product of a point's heights over the polyhedron's planes is greatest.
  static double length_along(const std::vector<Row>& rows, const Row& step) {
    constexpr unsigned halvings = 40;
    constexpr double most = 0x1p20;
    double low = 0, high = most;
    for (const Row& r : rows)
      if (const double rate = dot(r, step); rate < 0) high = std::min(high, -1 / rate);
    for (unsigned i = 0; i < halvings; ++i) {
      const double middle = (low + high) / 2;
      double slope = 0;
      for (const Row& r : rows) slope += dot(r, step) / (1 + middle * dot(r, step));
      (slope > 0 ? low : high) = middle;
    }
    return low;
  }
  bool go(const Row& step, double length) {
    WidePoint way{};
    for (std::size_t k = 0; k < 3; ++k) way = sum(way, scaled(step[k], frame_[k]));
    for (; length > 0x1p-30; length /= 2) {
      const WidePoint there = sum(place_, scaled(length, way));
      std::vector<double> heights = heights_at(there);
      if (!std::all_of(heights.begin(), heights.end(), [](double h) { return h > 0; })) continue;
      place_ = there;
      heights_ = std::move(heights);
      return true;
    }
    return false;
  }

  const std::vector<WidePlane>& planes_;
  WidePoint place_;
  std::array<WidePoint, 3> frame_{};
  std::vector<double> heights_;
};

/// The lattice of points with double coordinates. A lattice vector is described by how much it changes the height over
/// each plane of the polyhedron, relative to the height of the polyhedron's centre.
class ShapedLattice {
 public:
  ShapedLattice(const WidePolyhedron& polyhedron, const AnalyticCentre& centre)
      : polyhedron_(polyhedron), heights_(centre.heights()), centre_(centre.place()) {
    for (std::size_t k = 0; k < 3; ++k) basis_[k][k] = 1;
  }

  /// Reduces the lattice basis (Lenstra, Lenstra and Lovasz 1982) and moves to a lattice point near the polyhedron's
  /// centre. Returns false if numbers exceed the range of doubles.
  bool prepare() { return reduce() && go_near_centre(); }

  /// Returns how much a step along each vector of the lattice basis changes the relative height over each plane.
  const std::vector<Row>& rows() const { return rows_; }
  /// Returns the heights of the lattice point near the centre over all planes, relative to those of the centre.
  std::vector<double> rows_near_centre() const {
    std::vector<double> out;
    const WidePoint y = place_of(near_);
    for (std::size_t i = 0; i < heights_.size(); ++i) {
      const WidePlane& plane = polyhedron_.planes[i];
      out.push_back((plane.at + dot(plane.normal, y)).hi / heights_[i]);
    }
    return out;
  }
  /// Returns the distance between adjacent layers of lattice points that are parallel to the first two basis vectors.
  double third_height() const { return third_height_; }

  /// Returns the lattice point that is `steps` basis vectors from the one near the centre; the origin if it is too far.
  Vec3 point(const Row& steps) const {
    Steps there = near_;
    for (std::size_t j = 0; j < 3; ++j)
      if (!add(there, steps[j], basis_[j])) return polyhedron_.origin;
    Vec3 out;
    for (std::size_t i = 0; i < 3; ++i)
      out[i] = polyhedron_.origin[i] + static_cast<double>(there[i]) * polyhedron_.spacing[i];
    return out;
  }

 private:
  /// Returns the exact place of a lattice point. Vectors of the basis may be longer than the polyhedron, and a double
  /// has too few digits for them.
  WidePoint place_of(const Steps& steps) const {
    WidePoint out;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto most = static_cast<double>(steps[i]);
      const auto rest = static_cast<double>(steps[i] - static_cast<std::int64_t>(most));
      out[i] = {most * polyhedron_.spacing[i], rest * polyhedron_.spacing[i]};
    }
    return out;
  }
  void find_rows() {
    rows_.assign(heights_.size(), {});
    for (std::size_t k = 0; k < 3; ++k) {
      const WidePoint step = place_of(basis_[k]);
      for (std::size_t i = 0; i < heights_.size(); ++i)
        rows_[i][k] = dot(polyhedron_.planes[i].normal, step).hi / heights_[i];
    }
  }
  /// Adds factor * vector to the lattice coordinates `steps`; returns false if one of them becomes too large.
  static bool add(Steps& steps, double factor, const Steps& vector) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double product = factor * static_cast<double>(vector[i]);
      if (!(std::fabs(product) < too_many_steps)) return false;
      steps[i] += static_cast<std::int64_t>(factor) * vector[i];
      if (!(std::fabs(static_cast<double>(steps[i])) < too_many_steps)) return false;
    }
    return true;
  }
  bool reduce() {
    constexpr double lovasz = 0.99;
    std::size_t k = 1;
    for (unsigned i = 0; i < recovery_budget.lattice_steps; ++i) {
      find_rows();
      std::vector<Row> scratch = rows_;
      const Triangular r(scratch);
      if (!r.is_regular(k)) return false;  // later basis vectors are not reduced yet and may seem linearly dependent
      third_height_ = r.at[2][2];
      if (k == 3) return true;
      bool changed = false;
      for (std::size_t j = k; j-- > 0 && !changed;) {
        const double q = std::round(r.at[j][k] / r.at[j][j]);
        if (q == 0) continue;
        if (!(std::fabs(q) < too_many_steps) || !add(basis_[k], -q, basis_[j])) return false;
        changed = true;
      }
      if (changed) continue;
      const double across = r.at[k][k], along = r.at[k - 1][k], before = r.at[k - 1][k - 1];
      if (across * across + along * along < lovasz * before * before) {
        std::swap(basis_[k], basis_[k - 1]);
        k = std::max<std::size_t>(1, k - 1);
      } else {
        ++k;
      }
    }
    return false;
  }
  bool go_near_centre() {
    constexpr unsigned most_rounds = 40;
    std::vector<Row> orthonormal = rows_;
    const Triangular r(orthonormal);
    for (unsigned round = 0; round < most_rounds; ++round) {
      const WidePoint at = place_of(near_);
      Row off{};
      for (std::size_t i = 0; i < heights_.size(); ++i) {
        const WidePoint to_centre{centre_[0] - at[0], centre_[1] - at[1], centre_[2] - at[2]};
        const double row = dot(polyhedron_.planes[i].normal, to_centre).hi / heights_[i];
        for (std::size_t k = 0; k < 3; ++k) off[k] += orthonormal[i][k] * row;
      }
      const Row steps = r.solve(off);
      bool arrived = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const double q = std::round(steps[k]);
        if (q == 0) continue;
        arrived = false;
        if (!(std::fabs(q) < too_many_steps) || !add(near_, q, basis_[k])) return false;
      }
      if (arrived) return true;
    }
    return true;
  }

  const WidePolyhedron& polyhedron_;
  const std::vector<double>& heights_;
  const WidePoint centre_;
  std::array<Steps, 3> basis_{};
  Steps near_{};
  std::vector<Row> rows_;
  double third_height_ = 0;
};

/// The interval of the numbers x that satisfy all inequalities at + slope x > 0 passed to cut().
struct Interval {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  void cut(double at, double slope) {
    if (slope > 0) low = std::max(low, -at / slope);
    if (slope < 0) high = std::min(high, -at / slope);
    if (slope == 0 && !(at > 0)) high = -std::numeric_limits<double>::infinity();
  }
  bool is_bounded() const { return std::isfinite(low) && std::isfinite(high) && low < high; }
  /// Returns the integers in this interval from its middle outwards, at most the given number of them.
  std::vector<double> integers(std::size_t most) const {
    std::vector<double> out;
    if (!is_bounded()) return out;
    const double middle = std::round((low + high) / 2);
    if (!(std::fabs(middle) < too_many_steps)) return out;
    for (std::size_t k = 0; out.size() < most && static_cast<double>(k) <= high - low + 1; ++k)
      for (const double x : {middle + static_cast<double>(k), middle - static_cast<double>(k)})
        if (x > low && x < high && (out.empty() || x != out.back())) out.push_back(x);
    return out;
  }
};

}  // namespace

bool find_double_inside(const WidePolyhedron& polyhedron, const std::function<bool(const Vec3&)>& accept) {
  AnalyticCentre centre(polyhedron);
  if (!centre.find()) return false;
  ShapedLattice lattice(polyhedron, centre);
  if (!lattice.prepare()) return false;
  const std::vector<Row>& slopes = lattice.rows();
  const std::vector<double> near = lattice.rows_near_centre();
  const std::size_t n = slopes.size();
  const double reach = static_cast<double>(n) / lattice.third_height();
  const Interval layers{-std::min(reach, recovery_budget.lattice_layers) - 1,
                        std::min(reach, recovery_budget.lattice_layers) + 1};
  for (const double z : layers.integers(std::numeric_limits<std::size_t>::max())) {
    std::vector<double> at(n);
    for (std::size_t i = 0; i < n; ++i) at[i] = near[i] + z * slopes[i][2];
    Interval lines;  // range of the indices of lattice lines in layer z that meet the polyhedron
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const double p = slopes[i][0], q = slopes[j][0];
        if (i == j && p == 0) lines.cut(at[i], slopes[i][1]);
        if (p > 0 && q < 0) lines.cut(p * at[j] - q * at[i], p * slopes[j][1] - q * slopes[i][1]);
      }
    for (const double y : lines.integers(recovery_budget.lattice_lines)) {
      Interval points;
      for (std::size_t i = 0; i < n; ++i) points.cut(at[i] + y * slopes[i][1], slopes[i][0]);
      for (const double x : points.integers(recovery_budget.lattice_points))
        if (accept(lattice.point({x, y, z}))) return true;
    }
  }
  return false;
}

}  // namespace geomesh::recover

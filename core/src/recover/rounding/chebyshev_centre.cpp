// SPDX-License-Identifier: MIT
#include "recover/rounding/chebyshev_centre.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace geomesh::recover {

namespace {

/// The unknowns of the linear program: a displacement and, last, the least height over the planes.
using Unknowns = std::array<double, 4>;

constexpr double no_length = 1e-12;  ///< a unit vector whose projection is shorter than this counts as perpendicular

double dot(const Unknowns& u, const Unknowns& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2] + u[3] * v[3]; }

Unknowns plus(const Unknowns& u, double factor, const Unknowns& v) {
  return {u[0] + factor * v[0], u[1] + factor * v[1], u[2] + factor * v[2], u[3] + factor * v[3]};
}

/// Solves the linear program: maximises the least height subject to at + slope . displacement >= least height.
class ActiveSetWalk {
 public:
  ActiveSetWalk(std::span<const LinearHeight> heights, unsigned n_directions)
      : heights_(heights), n_directions_(n_directions) {
    place_[3] = least_height(heights, {});
  }

  std::array<double, 3> end(unsigned most_steps) {
    for (unsigned i = 0; i < most_steps && step(); ++i) {
    }
    return {place_[0], place_[1], place_[2]};
  }

 private:
  /// Makes one step of the linear program, which increases the least height over planes. Returns false at the optimum.
  bool step() {
    find_orthonormal_base();
    Unknowns way = upwards;
    for (const Unknowns& q : base_) way = plus(way, -dot(way, q), q);
    if (dot(way, way) > no_length * no_length) return go(way);
    return drop_what_holds_back();
  }
  /// Moves the displacement in the direction `way` until the height over another plane becomes the least height.
  bool go(const Unknowns& way) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t blocking = heights_.size();
    for (std::size_t i = 0; i < heights_.size(); ++i) {
      if (std::find(active_.begin(), active_.end(), i) != active_.end()) continue;
      const Unknowns row = row_of(i);
      const double fall = -dot(row, way);
      if (!(fall > no_length)) continue;
      const double reach = std::max(0.0, heights_[i].at + dot(row, place_)) / fall;
      if (reach < nearest) nearest = reach, blocking = i;
    }
    if (blocking == heights_.size()) return false;
    place_ = plus(place_, nearest, way);
    active_.push_back(blocking);
    return true;
  }
  /// Removes from the active constraints of the linear program one that keeps the least height from growing, found by
  /// the sign of its multiplier. Returns false at the optimum, which has no such constraint.
  bool drop_what_holds_back() {
    std::vector<double> factors(active_.size());
    Unknowns rest = upwards;
    // back substitution, because active constraint k lies in the span of the first k + 1 base vectors
    for (std::size_t k = active_.size(); k-- > 0;) {
      const double across = dot(row_of(active_[k]), base_[k]);
      factors[k] = dot(rest, base_[k]) / across;
      rest = plus(rest, -factors[k], row_of(active_[k]));
    }
    const auto worst = std::max_element(factors.begin(), factors.end());
    if (worst == factors.end() || !(*worst > no_length)) return false;
    active_.erase(active_.begin() + (worst - factors.begin()));
    return true;
  }
  void find_orthonormal_base() {
    base_.clear();
    for (const std::size_t i : active_) {
      Unknowns q = row_of(i);
      for (int twice = 0; twice < 2; ++twice)
        for (const Unknowns& b : base_) q = plus(q, -dot(q, b), b);
      const double length = std::sqrt(dot(q, q));
      base_.push_back({q[0] / length, q[1] / length, q[2] / length, q[3] / length});
    }
  }
  Unknowns row_of(std::size_t i) const {
    Unknowns out{0, 0, 0, -1};
    for (unsigned k = 0; k < n_directions_; ++k) out[k] = heights_[i].slope[k];
    return out;
  }

  static constexpr Unknowns upwards{0, 0, 0, 1};
  std::span<const LinearHeight> heights_;
  unsigned n_directions_;
  Unknowns place_{};
  std::vector<std::size_t> active_;  ///< active constraints of the linear program, linearly independent
  std::vector<Unknowns> base_;       ///< orthonormal basis of the span of the active constraints' coefficients
};

}  // namespace

double least_height(std::span<const LinearHeight> heights, const std::array<double, 3>& displacement) {
  double out = std::numeric_limits<double>::infinity();
  for (const LinearHeight& h : heights)
    out = std::min(out,
                   h.at + h.slope[0] * displacement[0] + h.slope[1] * displacement[1] + h.slope[2] * displacement[2]);
  return out;
}

std::array<double, 3> chebyshev_centre(std::span<const LinearHeight> heights, unsigned n_directions,
                                       unsigned most_steps) {
  return ActiveSetWalk(heights, n_directions).end(most_steps);
}

}  // namespace geomesh::recover

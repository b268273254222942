// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/mesh/edge_roots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace geomesh::geomodel {
namespace {

/// Share of a segment's length, and of the field's values, below which a root is as exact as rounding allows.
constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
/// Number of secant steps after which the interval is halved instead; it then needs at most 53 more steps.
constexpr int most_secant_steps = 12;
constexpr int most_steps = most_secant_steps + 54;

/// Interval [low, high], in fractions of a segment, in which the sign of f, the field minus the isovalue, changes.
struct Search {
  std::size_t row;
  double low = 0, high = 1, f_low, f_high;
  double least_f;      ///< values of f (field minus isovalue) closer to zero are due to rounding
  int last_moved = 0;  ///< end of the root's search interval that the last step moved: -1 for low, 1 for high
  bool is_exact = false;

  bool is_done() const { return is_exact || high - low <= rounding; }
  double next(int step) const {
    const double middle = 0.5 * (low + high);
    if (step >= most_secant_steps) return middle;
    const double t = low - f_low * (high - low) / (f_high - f_low);
    return t > low && t < high ? t : middle;
  }
  void take(double t, double f) {
    if (std::abs(f) <= least_f) {
      high = t;
      is_exact = true;
    } else if (f < 0) {
      low = t;
      f_low = f;
      if (last_moved < 0) f_high *= 0.5;
      last_moved = -1;
    } else {
      high = t;
      f_high = f;
      if (last_moved > 0) f_low *= 0.5;
      last_moved = 1;
    }
  }
};

/// Returns a point of a segment. Coordinates that are equal at both ends are kept without rounding, so that a root on a
/// side of the box lies exactly on that side.
Vec3 place_at(const Bracket& bracket, double t) {
  Vec3 p;
  for (std::size_t a = 0; a < 3; ++a) {
    const double from = bracket.below[a], to = bracket.above[a];
    p[a] = from == to || t <= 0 ? from : t >= 1 ? to : from + t * (to - from);
  }
  return p;
}

}  // namespace

std::vector<Vec3> find_roots(const ScalarField& field, std::vector<Bracket> brackets) {
  std::vector<Vec3> roots(brackets.size());
  std::vector<Search> open;
  for (std::size_t row = 0; row < brackets.size(); ++row) {
    const Bracket& b = brackets[row];
    const double least_f = rounding * std::max({std::abs(b.value_below), std::abs(b.value_above), std::abs(b.value)});
    open.push_back({row, 0, 1, b.value_below - b.value, b.value_above - b.value, least_f});
  }
  const auto settle = [&](const Search& s) {
    if (!s.is_done()) return false;
    roots[s.row] = place_at(brackets[s.row], s.high);
    return true;
  };
  std::vector<Vec3> places;
  std::vector<double> values, shares;
  for (int step = 0; step < most_steps; ++step) {
    std::erase_if(open, settle);
    if (open.empty()) return roots;
    places.clear();
    shares.clear();
    for (const Search& s : open) {
      shares.push_back(s.next(step));
      places.push_back(place_at(brackets[s.row], shares.back()));
    }
    values.resize(places.size());
    field.values(places, values);
    for (std::size_t i = 0; i < open.size(); ++i) {
      const Bracket& b = brackets[open[i].row];
      open[i].take(shares[i], values[i] - (b.value + b.shift_below + shares[i] * (b.shift_above - b.shift_below)));
    }
  }
  for (const Search& s : open) roots[s.row] = place_at(brackets[s.row], s.high);
  return roots;
}

std::vector<Vec3> linear_roots(const std::vector<Bracket>& brackets) {
  std::vector<Vec3> roots;
  for (const Bracket& b : brackets)
    roots.push_back(place_at(b, (b.value - b.value_below) / (b.value_above - b.value_below)));
  return roots;
}

}  // namespace geomesh::geomodel

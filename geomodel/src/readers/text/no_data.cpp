// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/text/no_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

namespace geomesh::geomodel {
namespace {

/// No height in any unit of length reaches this value; no-data values of many programs do (1e30, 1.70141e38, 3.4e38).
constexpr double beyond_all_lengths = 1e20;
/// Least distance of a known no-data value from all other values, as a share of the range of these: if the value occurs
/// several times, and if it occurs once.
constexpr double marker_gap = 0.1, single_marker_gap = 2;
/// Distance of a value from all other values, as a share of the range of these, from which the value is reported as
/// unusual. A faulted or folded horizon has values through most of its range; ten times the range is geologically
/// impossible.
constexpr double odd_gap = 10;
constexpr std::size_t most_odd = 8;
constexpr std::size_t least_heights = 8;  // fewest heights among which one can be considered unusual

/// Values that common programs write for "no value": Petrel, SKUA, ZMAP+, Surfer, Irap, LAS, GIS.
constexpr std::array written_for_no_data{-9999.0,    9999.0,    -99999.0, 99999.0, -999999.0,     999999.0,
                                         -9999999.0, -999.0,    -999.25,  -999.9,  -9999.25,      999.25,
                                         9999900.0,  9999999.0, -32768.0, 32767.0, -2147483648.0, 2147483647.0};

bool is_written_for_no_data(double v) {
  return std::find(written_for_no_data.begin(), written_for_no_data.end(), v) != written_for_no_data.end();
}

/// The two lowest and the two highest distinct heights, among those that have not been found to be unusual yet.
struct Extremes {
  double low[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  double high[2] = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  std::size_t n_low = 0, n_high = 0, first_low = 0, first_high = 0, n = 0;

  void add(double v, std::size_t row) {
    ++n;
    if (v == low[0]) {
      ++n_low;
    } else if (v < low[0]) {
      low[1] = low[0], low[0] = v, n_low = 1, first_low = row;
    } else {
      low[1] = std::min(low[1], v);
    }
    if (v == high[0]) {
      ++n_high;
    } else if (v > high[0]) {
      high[1] = high[0], high[0] = v, n_high = 1, first_high = row;
    } else {
      high[1] = std::max(high[1], v);
    }
  }
};

struct Outermost {
  double value, gap, range;
  std::size_t count, first;
  double share() const { return range > 0 ? gap / range : gap > 0 ? std::numeric_limits<double>::infinity() : 0; }
};

std::optional<OddHeight> judge(const Outermost& v) {
  using Kind = OddHeight::Kind;
  const auto as = [&](Kind kind) { return OddHeight{kind, v.value, v.count, v.first}; };
  if (is_written_for_no_data(v.value) && v.share() > (v.count > 1 ? marker_gap : single_marker_gap))
    return as(Kind::no_data);
  if (!(v.range > 0) || v.share() <= odd_gap) return std::nullopt;
  return as(v.count > 1 ? Kind::repeated : Kind::spike);
}

/// Returns the heights that certainly mean "no value": those larger than any length, and those that the user named.
std::vector<OddHeight> certain_ones(std::span<const double> heights, const ReadOptions& options) {
  std::vector<OddHeight> odd;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double v = heights[i];
    const bool beyond = !options.keep_all_heights && std::abs(v) >= beyond_all_lengths;
    if (!(beyond || (options.no_data && v == *options.no_data))) continue;
    const auto known = std::find_if(odd.begin(), odd.end(), [&](const OddHeight& o) { return o.value == v; });
    if (known != odd.end()) {
      ++known->count;
    } else if (odd.size() < most_odd) {
      odd.push_back({OddHeight::Kind::no_data, v, 1, i});
    }
  }
  return odd;
}

std::string number_words(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", v);
  return text;
}

}  // namespace

std::vector<OddHeight> find_odd_heights(std::span<const double> heights, const ReadOptions& options) {
  std::vector<OddHeight> odd = certain_ones(heights, options);
  if (options.keep_all_heights) return odd;
  const auto known = [&](double v) {
    return std::abs(v) >= beyond_all_lengths ||
           std::any_of(odd.begin(), odd.end(), [&](const OddHeight& o) { return o.value == v; });
  };
  while (odd.size() < most_odd) {
    Extremes e;
    for (std::size_t i = 0; i < heights.size(); ++i)
      if (!std::isnan(heights[i]) && !known(heights[i])) e.add(heights[i], i);
    if (e.n < least_heights || !(e.low[0] < e.high[0])) break;
    Outermost ends[2] = {{e.low[0], e.low[1] - e.low[0], e.high[0] - e.low[1], e.n_low, e.first_low},
                         {e.high[0], e.high[0] - e.high[1], e.high[1] - e.low[0], e.n_high, e.first_high}};
    if (ends[1].gap > ends[0].gap) std::swap(ends[0], ends[1]);
    auto found = judge(ends[0]);
    if (!found) found = judge(ends[1]);
    if (!found) break;
    odd.push_back(*found);
  }
  return odd;
}

bool is_left_out(double height, std::span<const OddHeight> odd) {
  return std::any_of(odd.begin(), odd.end(), [&](const OddHeight& o) {
    return o.kind == OddHeight::Kind::no_data &&
           (o.value == height || (std::abs(o.value) >= beyond_all_lengths && std::abs(height) >= beyond_all_lengths));
  });
}

std::string map_place_words(const Vec3& p) { return "(" + number_words(p.x) + ", " + number_words(p.y) + ")"; }

std::vector<std::string> describe_odd_heights(std::span<const OddHeight> odd, const std::string& name, const char* what,
                                              const std::function<std::string(std::size_t)>& place) {
  std::vector<std::string> said;
  for (const OddHeight& o : odd) {
    const std::string at = (o.count == 1 ? "one of the " : std::to_string(o.count) + " ") + std::string(what) +
                           " of '" + name + "' ha" + (o.count == 1 ? "s" : "ve") + " the height " +
                           number_words(o.value) + (o.count == 1 ? ", near " : ", the first near ") + place(o.first);
    if (o.kind == OddHeight::Kind::no_data) {
      said.push_back(at + ": taken for 'no value' and left out (no_data: none in the entry keeps such heights)");
    } else {
      said.push_back(at + ", far outside the range of all others: " +
                     (o.kind == OddHeight::Kind::spike ? "is it a wrong value? no_data: "
                                                       : "does it stand for 'no value'? no_data: ") +
                     number_words(o.value) + " in the entry leaves it out");
    }
  }
  return said;
}

}  // namespace geomesh::geomodel

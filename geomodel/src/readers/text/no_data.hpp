// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds values that mean "no height here" although no header says so, by their distance from the others.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/read_options.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

/// A number that means "no value" among heights, or that is implausible as a height.
struct OddHeight {
  enum class Kind {
    no_data,   ///< a value that programs write for "no data"; such heights are left out
    repeated,  ///< a height that repeats exactly and lies far from all others; it is reported and kept
    spike,     ///< a height that occurs once and lies far from all others; it is reported and kept
  };
  Kind kind = Kind::no_data;
  double value = 0;
  std::size_t count = 0;
  std::size_t first = 0;  ///< index of the first point with this unusual height
};

/// Returns the unusual values among the heights; NaN is ignored. Values that mean "no data" are those that no length on
/// earth reaches (1e20 and more), those that the user named, and values that programs write for this purpose (-9999,
/// -99999, -999.25, limits of types) if they are the lowest or highest of all heights and separated from the rest by a
/// tenth of the range of the rest, or by twice that range if they occur once. Any other lowest or highest value is
/// unusual if it is separated from the rest by ten times the range of the rest. O(n), and at most `most_odd` values are
/// found.
std::vector<OddHeight> find_odd_heights(std::span<const double> heights, const ReadOptions& options);

/// Returns true if a height is one of the values in `odd` that are left out. Values above 1e20 are compared up to the
/// rounding of single precision.
bool is_left_out(double height, std::span<const OddHeight> odd);

/// "(432500, 5801200)".
std::string map_place_words(const Vec3& p);

/// Returns the messages on the unusual heights of a surface or point set: "12 nodes of 'top' have the height -9999
/// ...". `what` is "nodes", "points" or "vertices"; `place` returns the text for the place of a row.
std::vector<std::string> describe_odd_heights(std::span<const OddHeight> odd, const std::string& name, const char* what,
                                              const std::function<std::string(std::size_t)>& place);

}  // namespace geomesh::geomodel

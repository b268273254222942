// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Values that stand for "no height here" although no header says so, found by how they lie among the others.
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

/// One value that is no height, or hardly one.
struct OddHeight {
  enum class Kind {
    no_data,   ///< a value that programs write where they have none: left out
    repeated,  ///< repeats exactly and lies far outside the rest: reported, and kept
    spike,     ///< stands once and lies far outside the rest: reported, and kept
  };
  Kind kind = Kind::no_data;
  double value = 0;
  std::size_t count = 0;
  std::size_t first = 0;  ///< row of the first one
};

/// The odd values among the heights; NaN has no height and is passed over.
///
/// No data is what no length on earth reaches (1e20 and more), and what the user named. So are values that programs
/// write for it (-9999, -99999, -999.25, limits of types) where they are the lowest or highest of all. They must be
/// separated from the rest by a tenth of the range of the rest; if they stand once, by twice that range. Any other
/// lowest or highest value is odd where it is separated from the rest by ten times the range of the rest. O(n), and at
/// most `most_odd` values are found.
std::vector<OddHeight> find_odd_heights(std::span<const double> heights, const ReadOptions& options);

/// True where a height of `odd` is left out; equality up to the rounding of single precision where 1e20 is passed.
bool is_left_out(double height, std::span<const OddHeight> odd);

/// "(432500, 5801200)".
std::string map_place_words(const Vec3& p);

/// What is said of the odd heights of `name`: "12 nodes of 'top' have the height -9999 ...". `what` is "nodes",
/// "points" or "vertices"; `place` gives the words for the place of a row.
std::vector<std::string> describe_odd_heights(std::span<const OddHeight> odd, const std::string& name, const char* what,
                                              const std::function<std::string(std::size_t)>& place);

}  // namespace geomesh::geomodel

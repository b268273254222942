// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// All measures of quality, for tests that hold for each.
#pragma once

#include <array>

#include "geomesh/core/quality_measure.hpp"

namespace geomesh::test {

inline constexpr auto all_measures = [] {
  std::array<QualityMeasure, n_quality_measures> all{};
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<QualityMeasure>(k);
  return all;
}();

}  // namespace geomesh::test

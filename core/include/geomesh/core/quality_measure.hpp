// SPDX-License-Identifier: MIT
/// @file
/// The measures of a tetrahedron's shape that improvement can maximise.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace geomesh {

/// Each is 0 for a flat tetrahedron and largest for the regular one.
enum class QualityMeasure : std::uint8_t {
  dihedral,  ///< least sine of the six dihedral angles, obtuse ones weighted down; 0.943 for the regular tetrahedron
  radius_ratio,  ///< 3 * inscribed radius / circumscribed radius; 1 for the regular tetrahedron
  mean_ratio,  ///< mean ratio to the power 3/2: volume over cubed root mean square of the edges; 1 for the regular one
};

/// Name of each measure in project files, on the command line and in reports, in the order of the enumeration.
inline constexpr std::array<std::string_view, 3> quality_measure_names{"dihedral", "radius_ratio", "mean_ratio"};
inline constexpr std::size_t n_quality_measures = quality_measure_names.size();

constexpr std::string_view name_of(QualityMeasure measure) {
  return quality_measure_names[static_cast<std::size_t>(measure)];
}

/// The measure of that name; nothing where there is none.
constexpr std::optional<QualityMeasure> quality_measure_of(std::string_view name) {
  for (std::size_t k = 0; k < n_quality_measures; ++k)
    if (quality_measure_names[k] == name) return static_cast<QualityMeasure>(k);
  return std::nullopt;
}

}  // namespace geomesh

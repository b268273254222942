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

/// Each measure is 0 for a flat tetrahedron and largest for the regular one.
enum class QualityMeasure : std::uint8_t {
  /// Least sine of the six dihedral angles, with obtuse ones weighted down; 0.943 for the regular tetrahedron.
  dihedral,
  radius_ratio,  ///< 3 * inscribed radius / circumscribed radius; 1 for the regular tetrahedron
  /// Mean ratio to the power 3/2: volume / cubed root mean square of the edges; 1 for the regular tetrahedron.
  mean_ratio,
};

/// Name of each measure in project files, on the command line and in reports, in the order of the enumeration.
inline constexpr std::array<std::string_view, 3> quality_measure_names{"dihedral", "radius_ratio", "mean_ratio"};
inline constexpr std::size_t n_quality_measures = quality_measure_names.size();

constexpr std::string_view name_of(QualityMeasure measure) {
  return quality_measure_names[static_cast<std::size_t>(measure)];
}

/// Returns the measure of the given name, or nothing if no measure has this name.
constexpr std::optional<QualityMeasure> quality_measure_of(std::string_view name) {
  for (std::size_t k = 0; k < n_quality_measures; ++k)
    if (quality_measure_names[k] == name) return static_cast<QualityMeasure>(k);
  return std::nullopt;
}

}  // namespace geomesh

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Colours of regions and surfaces in files that are looked at.
#pragma once

#include <array>
#include <cstddef>

namespace geomesh::geomodel {

using Colour = std::array<double, 3>;  ///< red, green, blue from 0 to 1

/// Calm colours that can be told apart side by side, those of `geomesh picture`; more than these repeat.
inline constexpr std::array<Colour, 12> colours{{{0.93, 0.79, 0.45},
                                                 {0.45, 0.66, 0.80},
                                                 {0.62, 0.77, 0.49},
                                                 {0.84, 0.53, 0.42},
                                                 {0.66, 0.58, 0.78},
                                                 {0.90, 0.64, 0.72},
                                                 {0.55, 0.76, 0.74},
                                                 {0.75, 0.68, 0.56},
                                                 {0.96, 0.88, 0.64},
                                                 {0.42, 0.53, 0.66},
                                                 {0.78, 0.84, 0.52},
                                                 {0.72, 0.44, 0.50}}};

inline const Colour& colour_of(std::size_t i) { return colours[i % colours.size()]; }

}  // namespace geomesh::geomodel

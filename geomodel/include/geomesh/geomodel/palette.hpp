// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Colours and heights of pictures: the page and `geomesh picture` draw a model alike.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Red, green and blue from 0 to 1.
using Colour = std::array<double, 3>;

/// Of "#rrggbb", "#rgb" or a common name ("orange"); nothing where the text is none of these.
std::optional<Colour> colour_from(std::string_view text);

/// "#rrggbb".
std::string to_hex(const Colour& colour);

/// Names with the colours that a project gives them (key `colours`).
using GivenColours = std::map<std::string, Colour>;

/// The object `input.colours` of a report; empty where the text has none or is no report.
GivenColours colours_of_report(std::string_view json);

/// The unit that "sand__2" or "sand__B2" is a part of: the name itself where it has no suffix.
std::string unit_of_part(const std::string& name);

/// Gives out colours in the order of the names it is asked for, so that the same list has the same colours everywhere.
class Palette {
 public:
  enum class Of { units, surfaces };  ///< surfaces have deeper colours than the units beside them
  explicit Palette(Of of, GivenColours given = {});

  /// A colour given to the name or to its unit wins. The parts of a unit have shades of its colour.
  Colour colour_of(const std::string& name);

 private:
  Of of_;
  GivenColours given_;
  struct Unit {
    Colour colour;
    std::size_t n_parts;
  };
  std::map<std::string, Unit> units_;
};

/// The sides of the box in every picture.
inline constexpr Colour colour_of_box_sides{0.62, 0.63, 0.65};

/// From the worst to the best: equal steps of the least dihedral angle from 0 to that of the regular tetrahedron.
inline constexpr double best_angle = 70.53;
inline constexpr std::array<Colour, 7> angle_colours{{{0.70, 0.09, 0.17},
                                                      {0.94, 0.54, 0.38},
                                                      {0.99, 0.86, 0.72},
                                                      {0.88, 0.92, 0.95},
                                                      {0.65, 0.82, 0.90},
                                                      {0.40, 0.66, 0.81},
                                                      {0.13, 0.40, 0.67}}};

/// How often heights are drawn, so that the layers of a flat model can be told apart: 1 where the model is at least
/// 0.3 times as high as it is wide, else the least of 2, 5, 10, 20 ... that makes it so.
double vertical_exaggeration(const Box3& bounds);

}  // namespace geomesh::geomodel

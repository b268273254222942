// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Colours and vertical exaggeration of pictures, shared by the report page and `geomesh picture` so that both draw a
/// model alike.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Red, green and blue components from 0 to 1.
using Colour = std::array<double, 3>;

/// Parses a colour: "#rrggbb", "#rgb" or a common name ("orange"). Returns nothing if the text is none of these.
std::optional<Colour> colour_from(std::string_view text);

/// "#rrggbb".
std::string to_hex(const Colour& colour);

/// Colours that a project assigns to names (key `colours`).
using GivenColours = std::map<std::string, Colour>;

/// Returns the colours in `input.colours` of a report in JSON; empty if there are none or the text is no report.
GivenColours colours_of_report(std::string_view json);

/// Returns the unit to which a part such as "sand__2" or "sand__B2" belongs, here "sand"; other names are returned
/// unchanged.
std::string unit_of_part(const std::string& name);

/// Assigns colours to names in the order in which they are requested, so that a list of names always gets the same
/// colours.
class Palette {
 public:
  /// Kind of the object that gets a colour: surfaces are darker than the units beside them.
  enum class Of { units, surfaces };
  explicit Palette(Of of, GivenColours given = {});

  /// Returns the colour of a name. A colour that the project assigns to the name or to its unit takes precedence. Parts
  /// of a unit get shades of the unit's colour.
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

/// Colour of the sides of the box in every picture.
inline constexpr Colour colour_of_box_sides{0.62, 0.63, 0.65};

/// Colours for element quality from worst to best, in equal steps of the least dihedral angle from 0 to that of the
/// regular tetrahedron (degrees).
inline constexpr double best_angle = 70.53;
inline constexpr std::array<Colour, 7> angle_colours{{{0.70, 0.09, 0.17},
                                                      {0.94, 0.54, 0.38},
                                                      {0.99, 0.86, 0.72},
                                                      {0.88, 0.92, 0.95},
                                                      {0.65, 0.82, 0.90},
                                                      {0.40, 0.66, 0.81},
                                                      {0.13, 0.40, 0.67}}};

/// Returns the vertical exaggeration that makes the layers of a flat model visible: 1 if the model is at least 0.3
/// times as high as it is wide, else the smallest of 2, 5, 10, 20 ... that reaches this ratio.
double vertical_exaggeration(const Box3& bounds);

}  // namespace geomesh::geomodel

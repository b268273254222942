// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Draws pictures of the HTML report as SVG text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geomesh/geomodel/palette.hpp"
#include "report_html/model/section.hpp"

namespace geomesh::geomodel::page {

/// Escapes `&`, `<`, `>` and quotes.
std::string escape(std::string_view text);

/// Formats a number for a person: four significant digits, separated thousands, and no exponent from 1e-4 to 1e15.
std::string number(double value);

/// Formats a coordinate with all its digits and no exponent, rounded to a millionth of `range`.
std::string coordinate(double value, double range);

std::string pixels(double value);

/// Draws a section of the mesh as SVG with axes: units filled in their colours (indexed by region id - 1), mesh edges
/// as thin lines, surfaces as dark lines. `bounds` are the model's.
std::string draw_section(const Section& section, const Box3& bounds, const std::vector<Colour>& colours);

/// Draws a bar chart; bar k counts values from k * width to (k + 1) * width.
std::string draw_histogram(const std::vector<std::size_t>& counts, double width, std::string_view quantity);

}  // namespace geomesh::geomodel::page

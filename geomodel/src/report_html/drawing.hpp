// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Pictures of the page as SVG text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "report_html/section.hpp"

namespace geomesh::geomodel::page {

/// `&`, `<`, `>` and quotes made harmless.
std::string escape(std::string_view text);

/// A number as a person reads it: four significant digits.
std::string number(double value);

/// The colour of a region or surface by its place in the list, "#rrggbb". Neighbours in the list differ clearly.
std::string colour(std::size_t row);

/// How much z is stretched in vertical sections of a model with these extents, so that layers can be told apart: 1, 2,
/// 5, 10, 20 ...
double vertical_exaggeration(const Box3& bounds);

/// A section as a picture with axes: units filled in their colours, mesh edges thin, surfaces dark. `bounds` are the
/// model's.
std::string draw_section(const Section& section, const Box3& bounds);

/// A bar chart; bar k counts values from k * width to (k + 1) * width.
std::string draw_histogram(const std::vector<std::size_t>& counts, double width, std::string_view quantity);

}  // namespace geomesh::geomodel::page

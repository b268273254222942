// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_html/stack_section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "report/words.hpp"
#include "report_html/drawing.hpp"

namespace geomesh::geomodel::page {
namespace {

constexpr double picture_width = 300;
constexpr std::size_t n_shades = 12;

/// Returns the colours of thickness maps from pale to dark. Number 0 marks places where the unit is absent.
std::string shade(std::size_t row) {
  const double t = static_cast<double>(row) / static_cast<double>(n_shades);
  const auto mix = [t](double from, double to) { return static_cast<int>(from + t * (to - from)); };
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", mix(235, 20), mix(240, 70), mix(235, 110));
  return text.data();
}

std::size_t shade_of(double thickness, double largest) {
  if (!(thickness > 0) || !(largest > 0)) return 0;
  return 1 + std::min(n_shades - 1, static_cast<std::size_t>(thickness / largest * static_cast<double>(n_shades)));
}

/// Draws the cells of a thickness map. Consecutive cells of one shade in a row become one rectangle.
std::string draw_cells(const ThicknessMaps& maps, const std::vector<double>& values, double largest, double scale) {
  std::string out;
  for (std::size_t j = 0; j < maps.n_rows; ++j)
    for (std::size_t i = 0; i < maps.n_columns;) {
      const double value = values[j * maps.n_columns + i];
      const std::size_t s = shade_of(value, largest);
      std::size_t end = i + 1;
      while (end < maps.n_columns && shade_of(values[j * maps.n_columns + end], largest) == s) ++end;
      if (s > 0)
        out += "<rect x=\"" + pixels(static_cast<double>(i) * scale) + "\" y=\"" +
               pixels(static_cast<double>(maps.n_rows - 1 - j) * scale) + "\" width=\"" +
               pixels(static_cast<double>(end - i) * scale + 0.3) + "\" height=\"" + pixels(scale + 0.3) +
               "\" fill=\"" + shade(s) + "\"/>";
      i = end;
    }
  return out;
}

std::string draw_map(const ThicknessMaps& maps, const SettledUnit& unit, const std::vector<double>& values) {
  const double scale = picture_width / static_cast<double>(maps.n_columns);
  const double height = scale * static_cast<double>(maps.n_rows);
  std::string out = "<svg width=\"" + pixels(picture_width) + "\" height=\"" + pixels(height) + "\" viewBox=\"0 0 " +
                    pixels(picture_width) + " " + pixels(height) + "\" role=\"img\" aria-label=\"Thickness of " +
                    escape(unit.name) + "\">" + draw_cells(maps, values, unit.largest_thickness, scale);
  const double left = maps.origin.x - 0.5 * maps.step, low = maps.origin.y - 0.5 * maps.step;
  for (const std::vector<Vec2>& line : unit.pinch_outs) {
    out += "<polyline class=\"trace\" points=\"";
    for (const Vec2& p : line)
      out += pixels((p.x - left) / maps.step * scale) + "," + pixels(height - (p.y - low) / maps.step * scale) + " ";
    out += "\"/>";
  }
  return out + "<rect class=\"frame\" width=\"" + pixels(picture_width) + "\" height=\"" + pixels(height) +
         "\"/></svg>";
}

std::string cell(const std::string& text) { return "<td class=\"n\">" + text + "</td>"; }

std::string horizons_table(const SettledStack& stack, const std::string& unit) {
  std::string out = "<div class=\"wide\" tabindex=\"0\"><table><tr><th>horizon</th>";
  for (const std::string& head :
       {std::string("triangles given"), std::string("triangles now"), "shared with a neighbour, " + unit + "2",
        "cut above the topography, " + unit + "2", "moved, " + unit + "2", "mean move, " + unit,
        "largest move, " + unit, "off elsewhere, " + unit, "made anew at faults, " + unit + "2",
        "largest move there, " + unit})
    out += "<th class=\"n\">" + head + "</th>";
  out += "</tr>\n";
  for (const SettledHorizon& h : stack.horizons)
    out += "<tr><td>" + escape(h.name) + "</td>" + cell(grouped_words(h.n_triangles_given)) +
           cell(grouped_words(h.n_triangles)) + cell(number(h.area_merged)) + cell(number(h.area_above_topography)) +
           cell(number(h.area_moved)) + cell(number(h.mean_move)) + cell(number(h.largest_move)) +
           cell(number(h.largest_off)) + cell(number(h.area_at_faults)) + cell(number(h.largest_move_at_faults)) +
           "</tr>\n";
  return out + "</table></div>\n";
}

}  // namespace

std::string stack_section(const SettledStack& stack, const std::string& unit) {
  std::string out =
      "<h2>The stack as it was settled</h2>\n<p>Horizons lie in the order of the column. Where a unit is thinner "
      "than " +
      number(stack.min_thickness) + " " + unit +
      " its two horizons share one surface: there its map is white, and a dark line is where it pinches "
      "out.</p>\n<div class=\"row\">";
  for (std::size_t k = 0; k < stack.units.size() && k < stack.maps.values.size(); ++k) {
    const SettledUnit& u = stack.units[k];
    out += "<div><h3>" + escape(u.name) + ": " + number(u.mean_thickness) + " " + unit +
           " thick in the mean, at most " + number(u.largest_thickness) + " " + unit + "</h3>" +
           draw_map(stack.maps, u, stack.maps.values[k]) + "</div>\n";
  }
  return out + "</div>\n" + horizons_table(stack, unit);
}

}  // namespace geomesh::geomodel::page

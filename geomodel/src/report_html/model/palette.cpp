// SPDX-License-Identifier: GPL-3.0-or-later
#include "geomesh/geomodel/palette.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

namespace geomesh::geomodel {
namespace {

using Colours = std::array<Colour, 12>;

constexpr Colours unit_colours{{{0.93, 0.79, 0.45},
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

constexpr Colours surface_colours{{{0.16, 0.42, 0.62},
                                   {0.70, 0.24, 0.20},
                                   {0.25, 0.52, 0.27},
                                   {0.50, 0.33, 0.64},
                                   {0.80, 0.49, 0.10},
                                   {0.08, 0.52, 0.52},
                                   {0.70, 0.27, 0.50},
                                   {0.40, 0.41, 0.46},
                                   {0.53, 0.53, 0.14},
                                   {0.24, 0.32, 0.76},
                                   {0.84, 0.36, 0.15},
                                   {0.46, 0.31, 0.22}}};

/// Factors on the brightness of a unit's colour: for regions of one unit, and for units after all colours of the list
/// were used once. The first factor is 1.
constexpr std::array<double, 4> part_brightness{1.0, 0.86, 1.12, 0.93};
constexpr std::array<double, 3> round_brightness{1.0, 0.8, 1.15};

constexpr std::array<std::pair<std::string_view, std::string_view>, 24> colour_names{
    {{"black", "#000000"}, {"white", "#ffffff"},  {"gray", "#808080"},   {"grey", "#808080"},   {"silver", "#c0c0c0"},
     {"red", "#e03131"},   {"maroon", "#800000"}, {"orange", "#f08c00"}, {"gold", "#ffd43b"},   {"yellow", "#ffe066"},
     {"olive", "#808000"}, {"lime", "#94d82d"},   {"green", "#2f9e44"},  {"teal", "#0c8599"},   {"cyan", "#66d9e8"},
     {"blue", "#1c7ed6"},  {"navy", "#0b3a75"},   {"purple", "#862e9c"}, {"violet", "#9775fa"}, {"magenta", "#d6336c"},
     {"pink", "#fcc2d7"},  {"brown", "#8d5524"},  {"tan", "#d2b48c"},    {"beige", "#f5f0dc"}}};

Colour with_brightness(Colour colour, double brightness) {
  for (double& channel : colour) channel = std::min(1.0, channel * brightness);
  return colour;
}

std::optional<Colour> colour_from_hex(std::string_view digits) {
  if (digits.size() != 3 && digits.size() != 6) return {};
  const std::size_t each = digits.size() / 3;
  Colour colour{};
  for (std::size_t k = 0; k < 3; ++k) {
    int value = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const char c = digits[k * each + (each == 2 ? i : 0)];
      const bool is_digit = c >= '0' && c <= '9', is_lower = c >= 'a' && c <= 'f', is_upper = c >= 'A' && c <= 'F';
      if (!is_digit && !is_lower && !is_upper) return {};
      value = 16 * value + (is_digit ? c - '0' : is_lower ? c - 'a' + 10 : c - 'A' + 10);
    }
    colour[k] = value / 255.0;
  }
  return colour;
}

}  // namespace

std::optional<Colour> colour_from(std::string_view text) {
  if (!text.empty() && text.front() == '#') return colour_from_hex(text.substr(1));
  for (const auto& [name, hex] : colour_names)
    if (text == name) return colour_from_hex(hex.substr(1));
  return {};
}

std::string to_hex(const Colour& colour) {
  std::string text = "#";
  for (const double channel : colour) {
    char digits[8];
    std::snprintf(digits, sizeof digits, "%02x",
                  static_cast<unsigned>(std::lround(255 * std::clamp(channel, 0.0, 1.0))));
    text += digits;
  }
  return text;
}

GivenColours colours_of_report(std::string_view json) {
  GivenColours colours;
  const auto report = nlohmann::json::parse(json, nullptr, false);
  if (!report.is_object() || !report.contains("input") || !report["input"].is_object()) return colours;
  const auto& input = report["input"];
  if (!input.contains("colours") || !input["colours"].is_object()) return colours;
  for (const auto& [name, text] : input["colours"].items())
    if (text.is_string())
      if (const auto colour = colour_from(text.get<std::string>())) colours[name] = *colour;
  return colours;
}

std::string unit_of_part(const std::string& name) {
  const std::size_t at = name.rfind("__");
  return at == std::string::npos || at == 0 ? name : name.substr(0, at);
}

Palette::Palette(Of of, GivenColours given) : of_(of), given_(std::move(given)) {}

Colour Palette::colour_of(const std::string& name) {
  const std::string unit = of_ == Of::units ? unit_of_part(name) : name;
  auto at = units_.find(unit);
  if (at == units_.end()) {
    const Colours& colours = of_ == Of::units ? unit_colours : surface_colours;
    const std::size_t n = units_.size(), round = n / colours.size();
    const auto own = given_.find(unit);
    const Colour next = with_brightness(colours[n % colours.size()], round_brightness[round % round_brightness.size()]);
    at = units_.emplace(unit, Unit{own == given_.end() ? next : own->second, 0}).first;
  }
  const double brightness = part_brightness[at->second.n_parts++ % part_brightness.size()];
  const auto own = given_.find(name);
  if (own != given_.end() && name != unit) return own->second;
  return with_brightness(at->second.colour, of_ == Of::units ? brightness : 1);
}

double vertical_exaggeration(const Box3& bounds) {
  constexpr double wanted = 0.3;  // height over width
  const double across = std::max(bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y),
               high = bounds.max.z - bounds.min.z;
  if (!(high > 0) || high >= wanted * across) return 1;
  for (double power = 1; power < 1e9; power *= 10)
    for (double factor : {2.0, 5.0, 10.0})
      if (high * power * factor >= wanted * across) return power * factor;
  return 1e9;
}

}  // namespace geomesh::geomodel

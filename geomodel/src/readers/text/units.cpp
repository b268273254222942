// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/text/units.hpp"

#include <algorithm>
#include <array>

namespace geomesh::geomodel {
namespace {

struct UnitName {
  std::string_view name;
  double metres;
};
constexpr double foot = 0.3048, survey_foot = 1200.0 / 3937.0;
constexpr std::array<UnitName, 27> length_units{{
    {"m", 1},
    {"metre", 1},
    {"meter", 1},
    {"metres", 1},
    {"meters", 1},
    {"none", 1},
    {"unknown", 1},
    {"unitless", 1},
    {"", 1},
    {"km", 1000},
    {"kilometre", 1e3},
    {"kilometer", 1e3},
    {"cm", 0.01},
    {"mm", 0.001},
    {"ft", foot},
    {"feet", foot},
    {"foot", foot},
    {"ift", foot},
    {"kft", 1000 * foot},
    {"ftus", survey_foot},
    {"usft", survey_foot},
    {"ft-us", survey_foot},
    {"ft_us", survey_foot},
    {"us-ft", survey_foot},
    {"us_survey_foot", survey_foot},
    {"in", 0.0254},
    {"yd", 0.9144},
}};
constexpr std::array<std::string_view, 10> time_units{"ms",   "s",           "sec",          "second", "seconds",
                                                      "msec", "millisecond", "milliseconds", "us",     "twt"};

}  // namespace

std::optional<double> length_unit_in_metres(std::string_view unit) {
  for (const UnitName& u : length_units)
    if (equals_ignoring_case(unit, u.name)) return u.metres;
  return std::nullopt;
}

bool is_time_unit(std::string_view unit) {
  return std::any_of(time_units.begin(), time_units.end(),
                     [&](std::string_view t) { return equals_ignoring_case(unit, t); });
}

double length_unit_in_metres(const LineReader& at, std::string_view unit) {
  if (const auto metres = length_unit_in_metres(unit)) return *metres;
  if (is_time_unit(unit)) {
    at.fail("the unit is " + in_quotes(unit) +
            ": a surface in time cannot be meshed with others in length; convert it to depth first");
  }
  at.fail("the unit " + in_quotes(unit) + " is not known; m, km, cm, mm, ft, ftUS, in or yd were expected");
}

}  // namespace geomesh::geomodel

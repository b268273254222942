// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/read_coordinates.hpp"

#include "coordinates/crs.hpp"
#include "project/read_reading.hpp"
#include "readers/text/units.hpp"

namespace geomesh::geomodel {
namespace {

const char* const time_words =
    "a surface in time (ms, s) cannot be meshed with others in length; convert it to depth with a velocity model first";

void read_unit(const YamlValue& value, std::string& unit) {
  if (is_time_unit(value.scalar())) return value.problem(time_words);
  if (const auto word = value.choice({"m", "km", "cm", "mm", "ft", "ftUS", "us-ft", "in", "yd"})) unit = *word;
}

std::optional<bool> read_direction(const YamlValue& value) {
  if (value.scalar() == "time" || value.scalar() == "twt") {
    value.problem(time_words);
    return std::nullopt;
  }
  const auto word = value.choice({"elevation", "depth"});
  return word ? std::optional(*word == "depth") : std::nullopt;
}

/// Reads a coordinate system. Text that cannot be interpreted at all is reported as a problem; a system of which only
/// the name is known is accepted.
void read_system(const YamlValue& value, std::string& text) {
  const auto word = value.text();
  if (!word) return;
  if (const std::string complaint = complaint_about_crs(*word); !complaint.empty()) return value.problem(complaint);
  text = *word;
}

}  // namespace

void read_crs(const YamlValue& value, CrsSpec& crs) {
  const YamlMap map(value, {"horizontal", "z", "unit", "z_datum", "z_scale"});
  if (const auto v = map.find("horizontal")) read_system(*v, crs.horizontal);
  if (const auto v = map.find("z")) crs.depth = read_direction(*v).value_or(false);
  if (const auto v = map.find("unit")) {
    if (is_time_unit(v->scalar())) {
      v->problem(time_words);
    } else if (const auto unit = v->choice({"m", "km", "ft", "ftUS"})) {
      crs.unit = *unit;
    }
  }
  if (const auto v = map.find("z_datum")) crs.z_datum = v->text().value_or("");
  if (const auto v = map.find("z_scale")) {
    const auto scale = v->number();
    if (!scale) return;
    if (!(*scale >= 1e-6 && *scale <= 1e6)) return v->problem("a number between 1e-6 and 1e6 was expected");
    crs.z_scale = *scale;
  }
}

void read_source(const YamlMap& map, SourceSpec& source) {
  if (const auto v = map.find("object")) source.object = v->text().value_or("");
  if (const auto v = map.find("crs")) read_system(*v, source.crs);
  if (const auto v = map.find("unit")) read_unit(*v, source.unit);
  if (const auto v = map.find("z_unit")) read_unit(*v, source.z_unit);
  if (const auto v = map.find("z")) source.depth = read_direction(*v);
  if (const auto v = map.find("z_datum")) source.z_datum = v->number().value_or(0);
  read_reading(map, source.reading);
}

}  // namespace geomesh::geomodel

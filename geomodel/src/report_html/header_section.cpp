// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_html/header_section.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "report/words.hpp"
#include "report_html/drawing.hpp"

namespace geomesh::geomodel::page {
namespace {

using Json = nlohmann::json;

std::string date_words() {
  static constexpr std::array<const char*, 12> months{"January",   "February", "March",    "April",
                                                      "May",       "June",     "July",     "August",
                                                      "September", "October",  "November", "December"};
  namespace chrono = std::chrono;
  auto now = chrono::floor<chrono::seconds>(chrono::system_clock::now());
  if (const char* const epoch = std::getenv("SOURCE_DATE_EPOCH"); epoch && *epoch)
    now = chrono::sys_seconds(chrono::seconds(std::strtoll(epoch, nullptr, 10)));
  const auto day = chrono::floor<chrono::days>(now);
  const chrono::year_month_day date(day);
  const chrono::hh_mm_ss time(now - day);
  if (!date.ok()) return {};
  char clock[16];
  std::snprintf(clock, sizeof clock, "%02d:%02d UTC", static_cast<int>(time.hours().count()),
                static_cast<int>(time.minutes().count()));
  return std::to_string(unsigned{date.day()}) + " " + months[unsigned{date.month()} - 1] + " " +
         std::to_string(int{date.year()}) + ", " + clock;
}

std::string box_words(const Box3& bounds, const std::string& unit) {
  static constexpr std::array<const char*, 3> names{"x", "y", "z"};
  std::string out;
  for (std::size_t k = 0; k < 3; ++k) {
    const double range = bounds.max[k] - bounds.min[k];
    out += std::string(k == 0 ? "" : ", ") + names[k] + " " + coordinate(bounds.min[k], range) + " to " +
           coordinate(bounds.max[k], range);
  }
  out += " (";
  for (std::size_t k = 0; k < 3; ++k) out += (k == 0 ? "" : " x ") + number(bounds.max[k] - bounds.min[k]);
  return out + " " + unit + ")";
}

std::string text_at(const Json& object, const char* key) {
  return object.is_object() && object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : "";
}

double number_at(const Json& object, const char* key) {
  return object.is_object() && object.contains(key) && object[key].is_number() ? object[key].get<double>() : 0;
}

Json part(const Json& object, const char* key) {
  return object.is_object() && object.contains(key) ? object[key] : Json{};
}

std::string system_words(const Json& crs, const Vec3& origin) {
  std::string out = text_at(crs, "mesh");
  if (out.empty()) out = text_at(crs, "horizontal");
  if (!(origin == Vec3{})) {
    out += std::string(out.empty() ? "" : "; ") + "less the origin";
    for (std::size_t k = 0; k < 3; ++k) out += (k == 0 ? " " : ", ") + coordinate(origin[k], 1);
  }
  return out;
}

std::string size_words(const Report& report, const Json& asked) {
  std::string out;
  const std::string& unit = report.mesh->unit;
  if (const double size = number_at(asked, "size"); size > 0) out = "requested: " + number(size) + " " + unit + "; ";
  if (!report.quality) return out;
  const auto& edges = report.quality->measured.whole.edge_length;
  out += "edges are " + number(edges.mean) + " " + unit + " long in the mean, " + number(edges.min) + " " + unit +
         " at least";
  if (report.tolerance && report.tolerance->requested() > 0)
    out += "; surfaces are within " + number(report.tolerance->requested()) + " " + unit + " of the input";
  return out;
}

std::string fact(const char* name, const std::string& text) {
  return text.empty() ? "" : std::string("<div><dt>") + name + "</dt><dd>" + escape(text) + "</dd></div>\n";
}

}  // namespace

std::string header_section(const Report& report, const Box3& bounds) {
  const Json input = Json::parse(report.input_json, nullptr, false);
  std::string out = "<header><h1>" + escape(report.name) + "</h1>\n";
  if (report.mesh)
    out += "<p class=\"lead\">" + grouped_words(report.mesh->tetrahedra.size()) + " tetrahedra, " +
           grouped_words(report.mesh->points.size()) + " points, " + units_words(*report.mesh) + "</p>\n";
  out += "<dl class=\"facts\">\n" + fact("Project", text_at(input, "project")) + fact("Made", date_words()) +
         fact("By", "geomesh " GEOMESH_VERSION);
  if (report.mesh)
    out += fact("Box", box_words(bounds, report.mesh->unit)) +
           fact("Coordinates", system_words(part(input, "crs"), report.mesh->origin)) +
           fact("Size", size_words(report, part(input, "mesh")));
  if (report.solver) out += fact("Elements", to_lines(*report.solver).front());
  out += fact("Model", report.model_verdict);
  return out + "</dl></header>\n";
}

}  // namespace geomesh::geomodel::page

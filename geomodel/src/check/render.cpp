// SPDX-License-Identifier: GPL-3.0-or-later
// Formats the verdict as text and as JSON, declared in geomesh/geomodel/check.hpp.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "geomesh/geomodel/check.hpp"

namespace geomesh::geomodel {
namespace {

std::string place_words(const Vec3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g)", p.x, p.y, p.z);
  return text;
}

}  // namespace

std::string to_text(const CheckResult& result) {
  char line[320];
  std::snprintf(line, sizeof line, "%zu tetrahedra, %zu points, volume %.15g\n", result.n_tetrahedra, result.n_points,
                result.volume);
  std::string text = line;
  for (const auto& region : result.regions) {
    std::snprintf(line, sizeof line, "  region %d  %-28s %10zu tetrahedra  volume %.15g\n", region.id,
                  region.name.c_str(), region.n_tetrahedra, region.volume);
    text += line;
  }
  text += "checked:\n";
  for (const std::string& check : result.checks_done) text += "  - " + check + '\n';
  if (result.solver)
    for (const std::string& line : to_lines(*result.solver)) text += line + '\n';
  for (const CheckFault& fault : result.faults) {
    text += "FAULT " + fault.id + ": " + fault.what;
    if (!fault.examples.empty()) text += "; first at " + place_words(fault.place) + "; items";
    for (const std::size_t example : fault.examples) text += ' ' + std::to_string(example);
    text += '\n';
  }
  text += result.faults.empty()
              ? "The mesh passes.\n"
              : "The mesh does not pass: " + std::to_string(result.faults.size()) + " kinds of fault.\n";
  return text;
}

std::string to_json(const CheckResult& result) {
  nlohmann::ordered_json json;
  json["command"] = "check";
  json["passes"] = result.faults.empty();
  json["points"] = result.n_points;
  json["tetrahedra"] = result.n_tetrahedra;
  json["volume"] = result.volume;
  json["regions"] = nlohmann::json::array();
  for (const auto& r : result.regions)
    json["regions"].push_back({{"id", r.id}, {"name", r.name}, {"tetrahedra", r.n_tetrahedra}, {"volume", r.volume}});
  if (result.solver) json["solver"] = nlohmann::ordered_json::parse(to_json(*result.solver));
  json["checks_done"] = result.checks_done;
  json["faults"] = nlohmann::json::array();
  for (const CheckFault& f : result.faults)
    json["faults"].push_back({{"id", f.id},
                              {"what", f.what},
                              {"count", f.count},
                              {"examples", f.examples},
                              {"place", {f.place.x, f.place.y, f.place.z}}});
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace geomesh::geomodel

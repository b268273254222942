// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/words.hpp"

#include <cstdio>
#include <set>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

std::string volume_words(double volume, const std::string& unit) {
  char text[64];
  if (volume >= 1e8 && unit == "m") {
    std::snprintf(text, sizeof text, "%.4g km3", volume / 1e9);
  } else {
    std::snprintf(text, sizeof text, "%.4g %s3", volume, unit.c_str());
  }
  return text;
}

std::string grouped_words(std::size_t n) {
  std::string text = std::to_string(n);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ',');
  return text;
}

std::string units_words(const ModelMesh& mesh) {
  std::set<std::string> units;
  for (const Region& region : mesh.regions) units.insert(region.unit.empty() ? region.name : region.unit);
  const std::string text = grouped_words(units.size()) + (units.size() == 1 ? " unit" : " units");
  if (units.size() == mesh.regions.size()) return text;
  return text + " in " + grouped_words(mesh.regions.size()) + " regions";
}

}  // namespace geomesh::geomodel

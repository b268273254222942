// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/stack_members.hpp"

#include <algorithm>

namespace geomesh::geomodel {
namespace {

Stack named_stack(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules) {
  Stack stack;
  std::vector<std::string> names, units;
  for (std::size_t i = 1; i < rules.column.size(); i += 2) names.push_back(rules.column[i]);
  for (std::size_t i = 2; i + 1 < rules.column.size(); i += 2) units.push_back(rules.column[i]);
  const auto stands = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (!rules.topography.empty() && !stands(rules.topography)) {
    if (!names.empty()) units.insert(units.begin(), rules.column.front());
    names.insert(names.begin(), rules.topography);
  }
  if (!rules.floor.empty() && !stands(rules.floor)) {
    if (!names.empty() && !rules.column.empty()) units.push_back(rules.column.back());
    names.push_back(rules.floor);
  }
  for (const std::string& name : names)
    for (Index s = 0; s < surfaces.size(); ++s)
      if (surfaces[s].name == name) stack.rows.push_back(s);
  stack.units = std::move(units);
  return stack;
}

}  // namespace

Stack find_stack(const BuiltSurfaces& built, const ModelRules& rules) {
  Stack stack = named_stack(built.surfaces, rules);
  stack.keepers = keepers_of(rules, stack.rows, built.surfaces);
  return stack;
}

}  // namespace geomesh::geomodel

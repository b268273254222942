// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the arrays of groups and attributes of regions, declared in check/arrays/check_arrays.hpp.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "check/arrays/check_arrays.hpp"
#include "check/mesh/faults.hpp"
#include "check/names/name_parts.hpp"

namespace geomesh::geomodel::checking {
namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Returns the unit and name of each region. An attribute of the region's name takes precedence over one of its unit.
std::map<std::int32_t, std::array<std::string, 2>> unit_and_name(const CheckedFaces& checked) {
  const std::set<std::string> known = names_of_specification(checked.specification());
  std::map<std::int32_t, std::array<std::string, 2>> names;
  for (const auto& [id, name] : checked.mesh().file.region_names) names[id] = {parts_of(name, known).base, name};
  return names;
}

}  // namespace

void check_unit_arrays(const CheckedFaces& checked, CheckResult& result) {
  const MeshFile& file = checked.mesh().file;
  const SpecifiedNames& asked = checked.specification().names;
  const auto names = unit_and_name(checked);
  FaultCollector wrong_group("wrong_groups"), wrong_value("wrong_attributes");
  std::size_t row = 0;
  for (const auto& [group, members] : asked.groups) {
    std::vector<std::int32_t> due;
    for (const auto& [id, two] : names)
      if (std::any_of(members.begin(), members.end(),
                      [&two = two](const auto& m) { return m == two[0] || m == two[1]; }))
        due.push_back(id);
    const auto given = file.region_groups.find(group);
    if (given == file.region_groups.end() || given->second != due) wrong_group.add(row, {});
    ++row;
  }
  if (file.region_groups.size() > asked.groups.size()) wrong_group.add(row, {});
  std::set<std::string> attributes;
  for (const auto& [unit, list] : asked.attributes)
    for (const auto& [attribute, value] : list) attributes.insert(attribute);
  for (const std::string& attribute : attributes) {
    std::map<std::int32_t, double> due;
    for (const auto& [id, two] : names) {
      due[id] = std::numeric_limits<double>::quiet_NaN();
      for (const std::string& name : two)
        if (const auto unit = asked.attributes.find(name); unit != asked.attributes.end())
          if (const auto value = unit->second.find(attribute); value != unit->second.end()) due[id] = value->second;
    }
    const auto given = file.cell_values.find(attribute);
    if (given == file.cell_values.end()) {
      wrong_value.add(0, {});
      continue;
    }
    for (std::size_t c = 0; c < file.region.size(); ++c)
      if (!due.contains(file.region[c]) || !same(given->second[c], due[file.region[c]]))
        wrong_value.add(file.cell[c], centroid(checked.mesh(), checked.mesh().cells[c]));
  }
  wrong_group.report(result, "groups do not hold the regions that the project puts in them");
  wrong_value.report(result, "cells or arrays do not have the attributes that the project gives their unit");
}

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/model_verdict.hpp"

#include <algorithm>

#include "report/words.hpp"

namespace geomesh::geomodel {
namespace {

const std::string& unit_of(const Region& region) { return region.unit.empty() ? region.name : region.unit; }

bool has_faces(const ModelMesh& mesh, const std::string& surface) {
  return std::any_of(mesh.surfaces.begin(), mesh.surfaces.end(),
                     [&](const NamedSurface& s) { return s.name == surface && s.area > 0; });
}

/// Returns whether the name of joined units, such as "a+b", contains the given unit.
bool is_part(const std::string& joined, const std::string& unit) {
  for (std::size_t begin = 0; begin <= joined.size();) {
    const std::size_t end = std::min(joined.find('+', begin), joined.size());
    if (joined.compare(begin, end - begin, unit) == 0) return true;
    begin = end + 1;
  }
  return false;
}

std::string reason_of(const std::vector<std::string>& column, std::size_t i, const ModelMesh& mesh) {
  for (const Region& region : mesh.regions)
    if (const std::string& name = unit_of(region); name.find('+') != std::string::npos && is_part(name, column[i]))
      return "in one region, " + name;
  std::string absent;
  for (const std::size_t k : {i - 1, i + 1})  // horizons above and below unit i; i - 1 wraps around for i = 0
    if (k < column.size() && !has_faces(mesh, column[k])) absent += (absent.empty() ? "" : ", ") + column[k];
  if (!absent.empty()) return absent + " not in the model";
  return "no room left between its horizons in the box";
}

std::string counted(std::size_t n) {
  return n == 0 ? "no warnings" : grouped_words(n) + (n == 1 ? " warning" : " warnings");
}

}  // namespace

std::vector<MissingUnit> missing_units(const std::vector<std::string>& column, const ModelMesh& mesh) {
  std::vector<MissingUnit> missing;
  for (std::size_t i = 0; i < column.size(); i += 2) {
    const bool found = std::any_of(mesh.regions.begin(), mesh.regions.end(),
                                   [&](const Region& region) { return unit_of(region) == column[i]; });
    if (!found) missing.push_back({column[i], reason_of(column, i, mesh)});
  }
  return missing;
}

std::string describe_missing(const std::vector<MissingUnit>& missing, std::size_t n_units) {
  if (missing.empty()) return "";
  std::string text = grouped_words(missing.size()) + " of " + grouped_words(n_units) + " units of the column ha" +
                     (missing.size() == 1 ? "s" : "ve") + " no region of its own: ";
  if (missing.size() > 1) text.replace(text.find("its own"), 7, "their own");
  for (std::size_t i = 0; i < missing.size(); ++i)
    text += (i > 0 ? ", " : "") + missing[i].name + " (" + missing[i].reason + ")";
  return text;
}

std::string model_verdict(const std::vector<MissingUnit>& missing, const std::vector<std::string>& column,
                          std::size_t n_warnings) {
  const std::string about = counted(n_warnings) + " about the model";
  const std::size_t n = (column.size() + 1) / 2;
  if (column.empty()) return about + "; no column names its units";
  if (missing.empty())
    return (n == 1 ? "the unit of the column has a region; "
                   : "all " + grouped_words(n) + " units of the column have regions; ") +
           about;
  std::string names;
  for (const MissingUnit& unit : missing) names += (names.empty() ? "" : ", ") + unit.name;
  return grouped_words(n - missing.size()) + " of " + grouped_words(n) + " units of the column have regions, not " +
         names + "; " + about;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/names/name_parts.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Removes `mark` and the number after it from the end of the text and returns the number; returns 0 and changes
/// nothing if the text has no such ending.
std::size_t take_number(std::string& text, const std::string& mark) {
  const std::size_t at = text.rfind(mark);
  if (at == std::string::npos) return 0;
  const std::string digits = text.substr(at + mark.size());
  if (digits.empty() || digits[0] == '0' || digits.size() > 9 ||
      digits.find_first_not_of("0123456789") != std::string::npos)
    return 0;
  text.resize(at);
  return std::stoul(digits);
}

}  // namespace

NameParts parts_of(const std::string& name, const std::set<std::string>& known) {
  NameParts parts{name};
  if (known.contains(name)) return parts;
  parts.number = take_number(parts.base, "__");
  if (known.contains(parts.base)) return parts;
  parts.block = take_number(parts.base, "__B");
  if (known.contains(parts.base)) return parts;
  parts = {name};
  parts.number = take_number(parts.base, "__");
  return parts;
}

std::set<std::string> names_of_specification(const Specification& specification) {
  std::set<std::string> known;
  const auto& column = specification.names.column;
  for (std::size_t i = 0; i < column.size(); i += 2) {
    std::string joined = column[i];
    known.insert(joined);
    for (std::size_t j = i + 2; j < column.size(); j += 2) known.insert(joined += "+" + column[j]);
  }
  for (const TriangulatedSurface& s : specification.surfaces)
    if (s.kind == SurfaceKind::body) known.insert(s.name);
  for (const NamedPoint& seed : specification.names.seeds) known.insert(seed.name);
  return known;
}

}  // namespace geomesh::geomodel::checking

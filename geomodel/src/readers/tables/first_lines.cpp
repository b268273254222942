// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/tables/first_lines.hpp"

namespace geomesh::geomodel {

FirstLines first_lines(LineReader& lines) {
  FirstLines found;
  while (found.second.empty() && lines.next()) {
    const std::string_view line = trim(lines.line());
    if (line.empty() || line.front() == '>') continue;  // a line with > begins a new polyline
    if (line.front() == '#' || line.front() == '!') {
      if (found.first.empty()) found.comment = trim(line.substr(1));
    } else {
      (found.first.empty() ? found.first : found.second) = lines.line();
    }
  }
  return found;
}

std::vector<std::string_view> fields_of_line(std::string_view line, const Separation& separation) {
  std::vector<std::string_view> fields = separation.split(line);
  while (fields.size() > 1 && fields.back().empty()) fields.pop_back();
  return fields;
}

std::vector<std::string> header_names(std::string_view line, const Separation& separation) {
  std::vector<std::string> names;
  for (const std::string_view field : fields_of_line(line, separation)) {
    const bool is_unit = separation.delimiter == ' ' && (field.starts_with('[') || field.starts_with('('));
    if (is_unit && !names.empty()) {
      names.back() += " " + std::string(field);
    } else {
      names.emplace_back(field);
    }
  }
  return names;
}

std::size_t count_numbers(std::string_view line) {
  if (trim(line).empty()) return 0;
  const Separation s = sniff_separation(line);
  std::size_t n = 0;
  for (const std::string_view field : s.split(line)) n += s.number(field).has_value();
  return n;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// XYZ and CSV points: separation, decimal comma and header are told from the first lines. Nothing is guessed about
// columns: a header either names x, y and z in a way that is known, or has three columns.
#include "readers/formats.hpp"
#include "readers/tables/table.hpp"
#include "readers/text/frame.hpp"

namespace geomesh::geomodel {
namespace {

/// The first two lines that are neither blank nor comment, as they were read.
struct FirstLines {
  std::string first, second;
};
FirstLines first_lines(LineReader& lines) {
  FirstLines found;
  while (found.second.empty() && lines.next()) {
    const std::string_view line = trim(lines.line());
    if (line.empty() || line.front() == '#' || line.front() == '!') continue;
    (found.first.empty() ? found.first : found.second) = lines.line();
  }
  return found;
}

std::size_t count_numbers(std::string_view line) {
  if (trim(line).empty()) return 0;
  const Separation s = sniff_separation(line);
  std::size_t n = 0;
  for (const std::string_view field : s.split(line)) n += s.number(field).has_value();
  return n;
}

bool begins_with_three_numbers(std::string_view line) {
  if (trim(line).empty()) return false;
  const Separation s = sniff_separation(line);
  const auto fields = s.split(line);
  return fields.size() >= 3 && s.number(fields[0]) && s.number(fields[1]) && s.number(fields[2]);
}

void expect_known_columns(const LineReader& lines, const std::vector<std::string>& names, bool known) {
  if (known || names.size() == 3) return;
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  lines.fail("the header names the columns " + all +
             "; columns x, y and z (or easting, northing, elevation or depth; longitude, latitude) were expected");
}

}  // namespace

bool is_xyz(const InputFile& file) {
  if (looks_binary(file)) return false;
  LineReader lines(file);
  const FirstLines found = first_lines(lines);
  return begins_with_three_numbers(found.first) || count_numbers(found.second) >= 3;
}

FileContents read_xyz(const InputFile& file) {
  LineReader lines(file);
  FirstLines found;
  {
    LineReader ahead(file);
    found = first_lines(ahead);
  }
  const bool has_header = !begins_with_three_numbers(found.first);
  const Separation separation = sniff_separation(has_header ? found.second : found.first);
  FileContents contents;
  contents.format = separation.delimiter == ' ' ? "XYZ points" : "CSV points";
  Columns columns;
  if (has_header) {
    while (lines.next() && lines.line() != found.first) {
    }
    std::vector<std::string> names;
    for (const std::string_view name : separation.split(found.first)) names.emplace_back(name);
    const auto known = columns_by_name(lines, names);
    expect_known_columns(lines, names, known.has_value());
    columns = known.value_or(Columns{});
    if (!known) contents.notes.push_back("the names of the three columns are not known: they are taken for x, y and z");
    choose_group(lines, separation, names, columns);
  }
  add_table(file, read_table(lines, separation, columns), contents);
  convert_by_frame(file, contents);
  return contents;
}

}  // namespace geomesh::geomodel

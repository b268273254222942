// SPDX-License-Identifier: GPL-3.0-or-later
// Reads XYZ and CSV points: separator, decimal comma and header are determined from the first lines. Columns are never
// guessed: the project defines them, or a header names x, y and z in a known way, or there are exactly three.
#include <algorithm>
#include <cmath>

#include "readers/formats.hpp"
#include "readers/tables/first_lines.hpp"
#include "readers/tables/table.hpp"
#include "readers/text/frame.hpp"

namespace geomesh::geomodel {
namespace {

std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

constexpr const char* how_to_name_columns =
    "; say which columns they are, by their names in the header or their numbers: columns: {x: 2, y: 3, z: 4} in the "
    "entry of the project (z may be depth)";

/// A table without a header has the columns x, y, z, or these three followed by text.
Columns columns_without_header(const LineReader& lines, std::string_view first, const Separation& separation) {
  const auto fields = fields_of_line(first, separation);
  std::size_t n_numbers = 0;
  for (const std::string_view field : fields) n_numbers += separation.number(field).has_value();
  const bool first_three = fields.size() >= 3 && std::all_of(fields.begin(), fields.begin() + 3, [&](auto field) {
                             return separation.number(field).has_value();
                           });
  if (n_numbers == 3 && first_three) return {};
  lines.fail("no header names the " + std::to_string(fields.size()) + " columns of " + in_quotes(first) + ", " +
             std::to_string(n_numbers) + " of which are numbers, and which of them are x, y and z is not guessed" +
             how_to_name_columns);
}

Columns columns_of_header(const LineReader& lines, const std::vector<std::string>& names, FileContents& contents) {
  if (const auto known = columns_by_name(lines, names)) return *known;
  if (names.size() != 3)
    lines.fail("the header names the columns " + listed(names) +
               "; columns x, y and z (or easting, northing, elevation or depth; longitude, latitude) were expected" +
               how_to_name_columns);
  contents.notes.push_back("the names of the three columns (" + listed(names) +
                           ") are not known: they are taken for x, y and z");
  return {};
}

/// Throws an error if the first line of a table of points holds the numbers of rows and columns instead of a point.
void refuse_counts(const InputFile& file, std::size_t line, const std::vector<TableRow>& rows) {
  if (rows.size() < 4) return;
  const Vec3& first = rows.front().point;
  const auto is_count = [](double v) { return v >= 0 && v < 1e9 && v == std::floor(v); };
  if (!is_count(first.x) || !is_count(first.y) || !is_count(first.z)) return;
  const auto n = static_cast<double>(rows.size() - 1);
  const bool is_size = first.x * first.y == n || (first.z > 0 && first.x * first.y * first.z == n);
  Box3 rest;
  for (std::size_t i = 1; i < rows.size(); ++i) rest.add(rows[i].point);
  bool is_beside = false, is_far = true;
  for (std::size_t k = 0; k < 2; ++k) {
    const double range = rest.max[k] - rest.min[k];
    is_beside = is_beside || first[k] < rest.min[k] || first[k] > rest.max[k];
    is_far = is_far && (first[k] < rest.min[k] - range || first[k] > rest.max[k] + range);
  }
  if ((is_size && is_beside) || is_far)
    file.fail(line,
              "this first line is far from all points that follow, or gives their number: it looks like counts "
              "and no point; take it out, or begin it with '#'");
}

/// Returns the columns of a table as the project file defines them; throws if x, y or z is not among them.
Columns asked_columns(const LineReader& lines, const InputFile& file, const std::vector<std::string>& header,
                      std::size_t n_columns, std::vector<std::string>& names) {
  names = names_of_columns(lines, file.options.columns, header, n_columns);
  if (const auto columns = columns_by_name(lines, names)) return *columns;
  lines.fail("'columns' names " + listed([&] {
               std::vector<std::string> meanings;
               for (const ReadOptions::Column& c : file.options.columns) meanings.push_back(c.meaning);
               return meanings;
             }()) +
             "; x, y and z (or easting, northing, elevation or depth; longitude, latitude) were expected among them");
}

}  // namespace

bool is_xyz(const InputFile& file) {
  if (looks_binary(file)) return false;
  LineReader lines(file);
  const FirstLines found = first_lines(lines);
  return count_numbers(found.first) >= 3 || count_numbers(found.second) >= 3;
}

FileContents read_xyz(const InputFile& file) {
  LineReader lines(file);
  FirstLines found;
  {
    LineReader ahead(file);
    found = first_lines(ahead);
  }
  const std::size_t n_numbers = count_numbers(found.first);
  const bool has_header = n_numbers == 0;
  const Separation separation = sniff_separation(has_header ? found.second : found.first);
  FileContents contents;
  contents.format = separation.delimiter == ' ' ? "XYZ points" : "CSV points";
  while (lines.next() && lines.line() != found.first) {
  }
  const std::size_t first_line = lines.number();
  if (!has_header && n_numbers < 3)
    lines.fail("this first line holds " + std::to_string(n_numbers) + " number(s), the next " +
               std::to_string(count_numbers(found.second)) +
               ": if it is a count, take it out or begin it with '#'; points x y z were expected");
  std::vector<std::string> names;
  if (has_header) {
    names = header_names(found.first, separation);
  } else if (!found.comment.empty()) {  // a comment such as "# x y z" above the data names the columns
    names = header_names(found.comment, sniff_separation(found.comment));
    if (names.size() != fields_of_line(found.first, separation).size() || !columns_by_name(lines, names)) names.clear();
  }
  Columns columns;
  if (!file.options.columns.empty()) {
    const std::size_t n =
        std::max(names.size(), fields_of_line(has_header ? found.second : found.first, separation).size());
    columns = asked_columns(lines, file, std::vector<std::string>(names), n, names);
  } else if (!names.empty()) {
    columns = columns_of_header(lines, names, contents);
  } else {
    columns = columns_without_header(lines, found.first, separation);
  }
  if (!has_header) lines.step_back();
  if (!names.empty()) choose_group(lines, separation, names, columns);
  const Table table = read_table(lines, separation, columns);
  if (!has_header) refuse_counts(file, first_line, table.rows);
  add_table(file, table, contents);
  convert_by_frame(file, contents);
  return contents;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/tables/table.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "readers/text/frame.hpp"
#include "readers/text/no_data.hpp"
#include "readers/text/units.hpp"

namespace geomesh::geomodel {
namespace {

std::string_view without_quotes(std::string_view field) {
  field = trim(field);
  if (field.size() >= 2 && (field.front() == '"' || field.front() == '\'') && field.back() == field.front())
    field = trim(field.substr(1, field.size() - 2));
  return field;
}

/// Returns the end of the first field of a line; delimiters inside quotes do not end it.
std::size_t end_of_field(std::string_view rest, char delimiter) {
  bool quoted = false;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (rest[i] == '"') quoted = !quoted;
    const bool ends = delimiter == ' ' ? rest[i] == ' ' || rest[i] == '\t' : rest[i] == delimiter;
    if (ends && !quoted) return i;
  }
  return rest.size();
}

bool one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}
bool is_longitude(std::string_view n) { return one_of(n, {"lon", "long", "longitude", "lng"}); }
bool is_latitude(std::string_view n) { return one_of(n, {"lat", "latitude"}); }
bool is_x(std::string_view n) {
  return is_longitude(n) || one_of(n, {"x", "easting", "east", "e", "x_coord", "xcoord", "coord_x", "x_utm", "utm_x",
                                       "utmx", "xx", "x_easting", "rechtswert", "ostwert", "este", "x-coordinate"});
}
bool is_y(std::string_view n) {
  return is_latitude(n) || one_of(n, {"y", "northing", "north", "n", "y_coord", "ycoord", "coord_y", "y_utm", "utm_y",
                                      "utmy", "yy", "y_northing", "hochwert", "nordwert", "norte", "y-coordinate"});
}
/// Returns the priority, from 1, with which a column of this name divides points into sets; 0 if it does not.
std::size_t group_rank(std::string_view n) {
  static constexpr std::string_view words[] = {"formation", "surface", "horizon", "layer",  "unit", "feature_name",
                                               "feature",   "fault",   "name",    "object", "id",   "val"};
  const auto* it = std::find(std::begin(words), std::end(words), n);
  return it == std::end(words) ? 0 : static_cast<std::size_t>(it - std::begin(words)) + 1;
}

bool is_stick(std::string_view n) {
  return one_of(n, {"stick", "stick_id", "stickid", "stick_no", "stick_nr", "stick_number", "stick number", "sticks",
                    "fault_stick", "segment", "segment_id", "polyline", "polyline_id"});
}

}  // namespace

std::pair<std::string, std::string> column_name_and_unit(std::string_view text) {
  std::string name = to_lower(without_quotes(text)), unit;
  const std::size_t open = name.find_first_of("[(");
  if (open != std::string::npos) {
    const std::size_t close = name.find_first_of("])", open);
    unit = trim(std::string_view(name).substr(open + 1, close == std::string::npos ? close : close - open - 1));
    name = trim(std::string_view(name).substr(0, open));
  } else if (const std::size_t bar = name.rfind('_'); bar != std::string::npos && bar + 1 < name.size()) {
    const std::string tail = name.substr(bar + 1);
    if (tail != "s" && (length_unit_in_metres(tail) || is_time_unit(tail))) {
      unit = tail;
      name.resize(bar);
    }
  }
  return {name, unit};
}

std::vector<std::string_view> Separation::split(std::string_view line) const {
  std::vector<std::string_view> fields;
  if (delimiter == ' ') line = trim(line);
  while (true) {
    if (delimiter == ' ') line = trim(line);
    const std::size_t end = end_of_field(line, delimiter);
    fields.push_back(without_quotes(line.substr(0, end)));
    if (end == line.size()) return fields;
    line.remove_prefix(end + 1);
  }
}

namespace {

/// Returns whether thousands are grouped by a separator as in "432,500.25" or "1,234,500": groups of three digits after
/// a first group of one to three.
bool has_groups_of_thousands(std::string_view text, char group) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t first = text.find(group);
  if (first == std::string_view::npos || first == 0 || first > 3) return false;
  for (std::size_t at = first; at < text.size() && text[at] == group; at += 4) {
    const std::string_view digits = text.substr(at + 1, 3);
    if (digits.size() < 3 || digits.find_first_not_of("0123456789") != std::string_view::npos) return false;
    if (at + 4 < text.size() && text[at + 4] >= '0' && text[at + 4] <= '9') return false;
  }
  return true;
}

std::string without(std::string_view text, char c) {
  std::string copy(text);
  std::erase(copy, c);
  return copy;
}

/// Reads a number with a decimal comma, which may have points or apostrophes between thousands.
std::optional<double> number_with_decimal_comma(std::string_view field) {
  const bool grouped = has_groups_of_thousands(field, '.') &&
                       (field.find(',') != std::string_view::npos || std::count(field.begin(), field.end(), '.') > 1);
  std::string copy = grouped ? without(field, '.') : std::string(field);
  std::erase(copy, '\'');
  if (std::count(copy.begin(), copy.end(), ',') > 1) return std::nullopt;
  std::replace(copy.begin(), copy.end(), ',', '.');
  return to_double(copy);
}

}  // namespace

std::optional<double> Separation::number(std::string_view field) const {
  if (const auto plain = to_double(field)) return plain;
  if (field.empty() || field.find_first_not_of("0123456789+-.,'eEdD") != std::string_view::npos) return std::nullopt;
  if (!decimal_comma && has_groups_of_thousands(field, ',')) return to_double(without(field, ','));
  return number_with_decimal_comma(field);
}

Separation sniff_separation(std::string_view line) {
  const auto all_numbers_have_points = [&](const std::vector<std::string_view>& fields) {
    return std::any_of(fields.begin(), fields.end(), [](std::string_view f) {
      return has_groups_of_thousands(f, ',') && f.find('.') != std::string_view::npos;
    });
  };
  const bool has_comma = line.find(',') != std::string_view::npos;
  for (const char delimiter : {';', '\t'})
    if (line.find(delimiter) != std::string_view::npos) {
      const Separation separation{delimiter, false};
      const auto fields = separation.split(line);
      if (delimiter == '\t' && fields.size() < 3) continue;  // with fewer than three fields, tabs only pad the line
      return {delimiter, has_comma && !all_numbers_have_points(fields)};
    }
  if (!has_comma) return {};
  const Separation blanks{' ', true};
  const auto fields = blanks.split(line);
  const bool commas_within = fields.size() >= 3 && std::all_of(fields.begin(), fields.end(), [&](std::string_view f) {
                               return f.back() != ',' && f.front() != ',' &&
                                      (std::count(f.begin(), f.end(), ',') <= 1 || has_groups_of_thousands(f, ','));
                             });
  if (commas_within) return {' ', !all_numbers_have_points(fields)};
  return Separation{',', false};
}

std::vector<std::string> names_of_columns(const LineReader& at, const std::vector<ReadOptions::Column>& asked,
                                          const std::vector<std::string>& header, std::size_t n_columns) {
  std::vector<std::string> names(n_columns);
  std::string known;
  for (const std::string& name : header) known += (known.empty() ? "" : ", ") + name;
  for (const ReadOptions::Column& c : asked) {
    const auto named = std::find_if(header.begin(), header.end(),
                                    [&](const std::string& name) { return equals_ignoring_case(name, c.column); });
    const auto number = to_integer(c.column);
    if (named != header.end()) {
      names[static_cast<std::size_t>(named - header.begin())] = c.meaning;
    } else if (number && *number >= 1 && static_cast<std::size_t>(*number) <= n_columns) {
      names[static_cast<std::size_t>(*number) - 1] = c.meaning;
    } else {
      at.fail("'columns' takes " + c.meaning + " from the column " + in_quotes(c.column) + ", but the table has " +
              std::to_string(n_columns) + " columns" + (known.empty() ? "" : ": " + known));
    }
  }
  return names;
}

std::optional<Columns> columns_by_name(const LineReader& at, const std::vector<std::string>& names) {
  Columns columns;
  bool has_x = false, has_y = false, has_z = false;
  std::string time_column;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto [name, unit] = column_name_and_unit(as_utf8(names[i]));
    const HeightColumn height = height_column(name);
    if (is_x(name) && !has_x) {
      columns.x = i;
      has_x = true;
      columns.geographic = is_longitude(name);
    } else if (is_y(name) && !has_y) {
      columns.y = i;
      has_y = true;
    } else if (height.is_height && (height.time || is_time_unit(unit))) {
      if (time_column.empty()) time_column = names[i];
    } else if (height.is_height && !has_z) {
      columns.z = i;
      has_z = true;
      columns.depth = height.depth;
      columns.z_unit = unit;
    } else if (is_stick(name) && !columns.stick) {
      columns.stick = i;
    } else if (name == "column") {
      columns.column = i;
    } else if (name == "row") {
      columns.row = i;
    }
  }
  if (has_x && has_y && !has_z && !time_column.empty()) {
    at.fail("the heights are in the column " + in_quotes(time_column) +
            ", which is a time: a surface in time cannot be meshed with others in length; convert it to depth first");
  }
  return has_x && has_y && has_z ? std::optional(columns) : std::nullopt;
}

Table read_table(LineReader& lines, const Separation& separation, Columns columns, double null) {
  Table table;
  const std::size_t n_needed = std::max({columns.x, columns.y, columns.z}) + 1;
  std::size_t n_segments = 0;
  while (lines.next()) {
    const std::string_view line = trim(lines.line());
    if (line.empty() || line.front() == '#' || line.front() == '!') continue;
    if (line.front() == '>') {
      ++n_segments;
      continue;
    }
    const std::vector<std::string_view> fields = separation.split(lines.line());
    if (fields.size() < n_needed)
      lines.fail("expected at least " + std::to_string(n_needed) + " columns, found " + std::to_string(fields.size()) +
                 ": " + in_quotes(line));
    TableRow row;
    bool present = true;
    const std::size_t column_of[3] = {columns.x, columns.y, columns.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string_view field = fields[column_of[k]];
      const std::string lower = to_lower(field);
      if (field.empty() || lower == "nan" || lower == "null" || lower == "na" || lower == "n/a") {
        present = false;
        continue;
      }
      const auto value = separation.number(field);
      if (!value)
        lines.fail(std::string("expected a number for ") + "xyz"[k] + " in column " + std::to_string(column_of[k] + 1) +
                   ", found " + in_quotes(field));
      if (!std::isfinite(*value))
        lines.fail(std::string("coordinate ") + "xyz"[k] + " is not finite: " + in_quotes(field));
      row.point[k] = *value;
    }
    if (!present || !(std::abs(row.point.z) < null)) {
      ++table.n_skipped;
      continue;
    }
    if (columns.group && *columns.group < fields.size()) row.group = fields[*columns.group];
    if (n_segments > 0) row.stick = std::to_string(n_segments);
    if (columns.stick && *columns.stick < fields.size()) row.stick = fields[*columns.stick];
    const auto whole = [&](std::optional<std::size_t> c, std::size_t& out) {
      if (!c) return;
      const auto n = *c < fields.size() ? to_integer(fields[*c]) : std::nullopt;
      if (!n || *n < 1)
        lines.fail("expected a column or row of the grid, counted from 1, in column " + std::to_string(*c + 1));
      out = static_cast<std::size_t>(*n) - 1;
    };
    whole(columns.column, row.column);
    whole(columns.row, row.row);
    table.rows.push_back(std::move(row));
  }
  table.has_lines = columns.stick || n_segments > 0;
  table.columns = std::move(columns);
  return table;
}

void choose_group(LineReader lines, const Separation& separation, const std::vector<std::string>& names,
                  Columns& columns) {
  struct Candidate {
    std::size_t rank, column;
    std::set<std::string, std::less<>> values;
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const std::size_t rank = group_rank(column_name_and_unit(names[i]).first); rank > 0)
      candidates.push_back({rank, i, {}});
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.rank, a.column) < std::tie(b.rank, b.column);
  });
  if (candidates.empty()) return;
  std::size_t n_rows = 0;
  while (lines.next()) {
    if (const auto line = trim(lines.line()); line.empty() || line.front() == '>') continue;
    ++n_rows;
    const auto fields = separation.split(lines.line());
    for (Candidate& c : candidates)
      if (c.column < fields.size() && !c.values.contains(fields[c.column])) c.values.emplace(fields[c.column]);
  }
  for (const Candidate& c : candidates) {
    if (c.values.size() < 2 || 3 * c.values.size() > n_rows) continue;
    columns.group = c.column;
    columns.group_name = names[c.column];
    return;
  }
}

namespace {

struct DuplicateCounts {
  std::size_t equal = 0, same_place = 0;
};
DuplicateCounts count_duplicates(std::vector<Vec3> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
  DuplicateCounts n;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].x != points[i - 1].x || points[i].y != points[i - 1].y) continue;
    ++(points[i].z == points[i - 1].z ? n.equal : n.same_place);
  }
  return n;
}

void drop_no_data(const InputFile& file, const std::string& name, std::vector<Vec3>& points, FileContents& contents) {
  std::vector<double> heights;
  heights.reserve(points.size());
  for (const Vec3& p : points) heights.push_back(p.z);
  const std::vector<OddHeight> odd = find_odd_heights(heights, file.options);
  if (odd.empty()) return;
  for (std::string& text :
       describe_odd_heights(odd, name, "points", [&](std::size_t row) { return map_place_words(points[row]); }))
    contents.warnings.push_back(std::move(text));
  std::erase_if(points, [&](const Vec3& p) { return is_left_out(p.z, odd); });
  if (points.empty()) file.fail("no point of '" + name + "' has a height");
}

void add_set(const InputFile& file, const std::string& name, std::vector<Vec3> points, FileContents& contents) {
  drop_no_data(file, name, points, contents);
  const DuplicateCounts twice = count_duplicates(points);
  if (twice.equal > 0)
    contents.warnings.push_back(std::to_string(twice.equal) + " points of '" + name + "' repeat another");
  if (twice.same_place > 0)
    contents.warnings.push_back(std::to_string(twice.same_place) + " points of '" + name +
                                "' stand at the x and y of another with a different z");
  if (const auto lattice = twice.same_place == 0 ? lattice_of_points(points) : std::nullopt) {
    const std::vector<Vec3>& nodes = lattice->nodes;
    const Vec3 &first = nodes.front(), &right = nodes[1], &up = nodes[lattice->n_columns];
    add_checked_lattice(file, name, *lattice,
                        {name, 0, 0, 0, {first.x, first.y}, {right.x - first.x, up.y - first.y}, 0, false}, contents);
    contents.notes.push_back("the points of '" + name + "' are the nodes of a regular grid of " +
                             std::to_string(lattice->n_columns) + " by " + std::to_string(lattice->n_rows));
    return;
  }
  contents.point_sets.push_back({name, file.shown(), std::move(points)});
}

void add_lines(const InputFile& file, const std::string& name, const std::vector<const TableRow*>& rows,
               FileContents& contents) {
  std::vector<Vec3> points;
  for (const TableRow* row : rows) points.push_back(row->point);
  std::vector<double> heights;
  for (const Vec3& p : points) heights.push_back(p.z);
  const std::vector<OddHeight> odd = find_odd_heights(heights, file.options);
  for (std::string& text :
       describe_odd_heights(odd, name, "points", [&](std::size_t row) { return map_place_words(points[row]); }))
    contents.warnings.push_back(std::move(text));
  std::map<std::string, std::size_t> line_of;
  std::vector<std::vector<Vec3>> lines;
  for (const TableRow* row : rows) {
    if (is_left_out(row->point.z, odd)) continue;
    const auto [it, is_new] = line_of.try_emplace(row->stick, lines.size());
    if (is_new) lines.emplace_back();
    lines[it->second].push_back(row->point);
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    contents.polylines.push_back(
        {lines.size() == 1 ? name : name + "__" + std::to_string(i + 1), file.shown(), std::move(lines[i])});
}

}  // namespace

void add_table(const InputFile& file, const Table& table, FileContents& contents) {
  if (table.rows.empty()) file.fail("the file holds no point with x, y and z");
  contents.frame.depth = contents.frame.z_named = table.columns.depth;
  contents.frame.geographic = table.columns.geographic;
  contents.frame.z_unit = table.columns.z_unit;
  if (table.columns.geographic)
    contents.notes.push_back("x and y are longitude and latitude by the names of their columns");
  if (table.n_skipped > 0)
    contents.warnings.push_back(std::to_string(table.n_skipped) + " rows without a value of x, y or z are left out");
  std::vector<std::string> order;
  std::map<std::string, std::vector<const TableRow*>> sets;
  for (const TableRow& row : table.rows) {
    const auto [it, fresh] = sets.try_emplace(row.group);
    if (fresh) order.push_back(row.group);
    it->second.push_back(&row);
  }
  if (order.size() > 1)
    contents.notes.push_back("the points are parted by the column '" + table.columns.group_name + "'");
  for (const std::string& group : order) {
    std::string name = order.size() == 1 ? file.path.stem().string() : group;
    if (name.empty()) name = "(none)";
    if (table.has_lines) {
      add_lines(file, name, sets[group], contents);
      continue;
    }
    std::vector<Vec3> points;
    for (const TableRow* row : sets[group]) points.push_back(row->point);
    add_set(file, name, std::move(points), contents);
  }
}

}  // namespace geomesh::geomodel

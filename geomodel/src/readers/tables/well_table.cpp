// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/tables/well_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "readers/formats.hpp"
#include "readers/tables/first_lines.hpp"
#include "readers/tables/table.hpp"
#include "readers/text/frame.hpp"
#include "readers/text/units.hpp"

namespace geomesh::geomodel {
namespace {

enum Role { md, inclination, azimuth, dx, dy, tvd, well, n_roles };

Role role_of(std::string_view name) {
  if (name.ends_with("_deg")) name.remove_suffix(4);
  struct Words {
    Role role;
    std::vector<std::string_view> names;
  };
  static const std::array words{
      Words{md, {"md", "measured_depth", "measured depth", "depth_md", "mdepth", "md_depth"}},
      Words{inclination, {"inc", "incl", "inclination", "deviation", "dev", "neigung", "hole_inclination"}},
      Words{azimuth, {"az", "azi", "azim", "azimuth", "hazi", "azimut", "azim_gn", "azimuth_gn", "hole_azimuth"}},
      Words{dx, {"dx", "x_offset", "xoffset", "ew", "east_offset", "departure"}},
      Words{dy, {"dy", "y_offset", "yoffset", "ns", "north_offset"}},
      Words{tvd, {"tvd", "true_vertical_depth", "true vertical depth"}},
      Words{well,
            {"well", "well_name", "wellname", "well name", "uwi", "borehole", "hole", "hole_id", "holeid", "bhid",
             "bohrung", "name"}}};
  for (const Words& w : words)
    if (std::find(w.names.begin(), w.names.end(), name) != w.names.end()) return w.role;
  return n_roles;
}

struct WellColumns {
  std::optional<std::size_t> of[n_roles];
  std::optional<Columns> xyz;
  std::string md_unit;

  bool has(std::initializer_list<Role> roles) const {
    return std::all_of(roles.begin(), roles.end(), [&](Role r) { return of[r].has_value(); });
  }
};

WellColumns columns_of(const LineReader& lines, const std::vector<std::string>& names) {
  WellColumns columns;
  std::vector<std::string> others = names;  // in a table of wells, "tvd" is the depth below the well head, not z
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto [name, unit] = column_name_and_unit(as_utf8(names[i]));
    Role role = role_of(name);
    if (role == n_roles) role = role_of(to_lower(as_utf8(names[i])));
    if (role == n_roles || columns.of[role]) continue;
    columns.of[role] = i;
    if (role == md || role == tvd) columns.md_unit = unit;
    others[i].clear();
  }
  columns.xyz = columns_by_name(lines, others);
  return columns;
}

struct Row {
  std::string well;
  double values[n_roles] = {};
  Vec3 point;
  std::size_t line = 0;
};

std::vector<SurveyStation> stations_of(const InputFile& file, const std::vector<Row>& rows) {
  std::vector<SurveyStation> stations;
  for (const Row& row : rows) {
    const SurveyStation station{row.values[md], row.values[inclination], row.values[azimuth]};
    if (station.md < 0 || (!stations.empty() && station.md < stations.back().md))
      file.fail(row.line, "measured depths are zero or more and do not decrease along the well");
    if (station.inclination < 0 || station.inclination > 180)
      file.fail(row.line, "an inclination of 0 (down) to 180 degrees was expected");
    if (!stations.empty() && station.md == stations.back().md) stations.pop_back();
    stations.push_back(station);
  }
  return stations;
}

/// Returns the start of a well path: as the project gives it, else from the comments in Petrel's well traces.
Vec3 head_of_path(const InputFile& file, const WellReading& reading) {
  if (reading.head) return *reading.head;
  std::optional<double> found[3];
  LineReader lines(file);
  while (lines.next()) {
    const std::string_view line = trim(lines.line());
    if (!line.starts_with('#')) continue;
    const std::string lower = to_lower(line);
    const std::size_t colon = lower.rfind(':');
    if (colon == std::string::npos) continue;
    const auto value = to_double(Tokens(std::string_view(lower).substr(colon + 1)).next());
    if (lower.find("head x") != std::string::npos) found[0] = value;
    if (lower.find("head y") != std::string::npos) found[1] = value;
    if (lower.find("well kb") != std::string::npos || lower.find("well datum") != std::string::npos) found[2] = value;
  }
  if (!found[0] || !found[1] || !found[2])
    file.fail(
        "a deviation survey holds directions alone: say where its measured depth is zero, with head: [x, y, z] "
        "in the entry of the well (z: elevation of the rotary table or of the ground)");
  return {*found[0], *found[1], reading.head_is_depth ? -*found[2] : *found[2]};
}

class WellTableReader {
 public:
  WellTableReader(const InputFile& file, const WellReading& reading) : file_(file), reading_(reading), lines_(file) {}

  FileContents read() {
    find_columns();
    read_rows();
    FileContents contents;
    contents.format = "table of wells";
    if (columns_.xyz) {
      contents.frame.depth = contents.frame.z_named = columns_.xyz->depth;
      contents.frame.geographic = columns_.xyz->geographic;
      contents.frame.z_unit = columns_.xyz->z_unit;
    }
    for (const std::string& name : order_) {
      std::vector<Vec3> points = path(by_well_.at(name), contents);
      if (points.size() < 2) file_.fail("the well " + in_quotes(name) + " has one point; its path needs two or more");
      contents.polylines.push_back({name, file_.shown(), std::move(points)});
    }
    convert_by_frame(file_, contents);
    return contents;
  }

 private:
  void find_columns() {
    const FirstLines found = [&] {
      LineReader ahead(file_);
      return first_lines(ahead);
    }();
    has_header_ = count_numbers(found.first) == 0;
    separation_ = sniff_separation(has_header_ ? found.second : found.first);
    while (lines_.next() && lines_.line() != found.first) {
    }
    const std::string& data = has_header_ ? found.second : found.first;
    std::vector<std::string> names;
    if (has_header_) names = header_names(found.first, separation_);
    const std::size_t n = std::max(names.size(), fields_of_line(data, separation_).size());
    if (!file_.options.columns.empty()) names = names_of_columns(lines_, file_.options.columns, names, n);
    if (names.empty()) {
      if (n != 3) refuse_columns("no header names its " + std::to_string(n) + " columns");
      names = reading_.head ? std::vector<std::string>{"md", "inclination", "azimuth"}
                            : std::vector<std::string>{"x", "y", "z"};
      is_guessed_ = true;
    }
    columns_ = columns_of(lines_, names);
    if (!columns_.xyz && !is_survey() && !is_offsets()) {
      std::string all;
      for (const std::string& name : names) all += (all.empty() ? "" : ", ") + (name.empty() ? "-" : name);
      refuse_columns("its columns are " + all);
    }
    if (!has_header_) lines_.step_back();
  }

  [[noreturn]] void refuse_columns(const std::string& what) const {
    lines_.fail(what +
                "; the path of a well has the columns x, y, z (or depth), or is a deviation survey with md, "
                "inclination, azimuth: say which they are in the entry, by names or numbers: columns: {md: 1, "
                "inclination: 2, azimuth: 3}, and where the survey begins: head: [x, y, z]");
  }

  bool is_survey() const { return !columns_.xyz && columns_.has({md, inclination, azimuth}); }
  bool is_offsets() const { return !columns_.xyz && !is_survey() && columns_.has({dx, dy, tvd}); }

  void read_rows() {
    while (lines_.next()) {
      const std::string_view line = trim(lines_.line());
      if (line.empty() || line.front() == '#' || line.front() == '!') continue;
      const auto fields = separation_.split(lines_.line());
      Row row;
      row.line = lines_.number();
      const auto number = [&](std::size_t column, const char* what) {
        if (column >= fields.size()) lines_.fail(std::string("the line ends before its ") + what);
        const auto value = separation_.number(fields[column]);
        if (!value || !std::isfinite(*value))
          lines_.fail(std::string("a number was expected for ") + what + ", found " + in_quotes(fields[column]));
        return *value;
      };
      static constexpr const char* names[n_roles] = {"md", "inclination", "azimuth", "dx", "dy", "tvd", "well"};
      for (int r = 0; r < well; ++r)
        if (columns_.of[r] && !columns_.xyz) row.values[r] = number(*columns_.of[r], names[r]);
      if (columns_.xyz) {
        row.point = {number(columns_.xyz->x, "x"), number(columns_.xyz->y, "y"), number(columns_.xyz->z, "z")};
      }
      if (columns_.of[well] && *columns_.of[well] < fields.size()) row.well = fields[*columns_.of[well]];
      if (row.well.empty()) row.well = file_.path.stem().string();
      const auto [it, fresh] = by_well_.try_emplace(row.well);
      if (fresh) order_.push_back(row.well);
      it->second.push_back(std::move(row));
    }
    if (order_.empty()) file_.fail("the table holds no point of a well");
  }

  std::vector<Vec3> path(const std::vector<Row>& rows, FileContents& contents) const {
    std::vector<Vec3> points;
    if (columns_.xyz) {
      refuse_survey_without_names(rows);
      for (const Row& row : rows)
        if (points.empty() || points.back() != row.point) points.push_back(row.point);
      return points;
    }
    const Vec3 head = head_of_path(file_, reading_);
    const double unit =
        columns_.md_unit.empty() ? 1 : length_unit_in_metres(lines_, columns_.md_unit) / reading_.metres;
    const double up = reading_.head_is_depth ? -1 : 1;
    if (is_survey()) {
      contents.notes.push_back("the path is made from " + std::to_string(rows.size()) +
                               " stations (measured depth, inclination, azimuth from the north of the map) by minimum "
                               "curvature");
      points = path_of_survey(stations_of(file_, rows));
    } else {
      for (const Row& row : rows) points.push_back({row.values[dx], row.values[dy], -row.values[tvd]});
    }
    for (Vec3& p : points) p = {head.x + unit * p.x, head.y + unit * p.y, head.z + up * unit * p.z};
    return points;
  }

  /// Throws if three columns without names are a deviation survey instead of x, y, z.
  void refuse_survey_without_names(const std::vector<Row>& rows) const {
    if (!is_guessed_) return;
    bool is_survey = rows.size() > 1;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Vec3& p = rows[i].point;
      is_survey = is_survey && p.x >= 0 && (i == 0 || p.x > rows[i - 1].point.x) && p.y >= 0 && p.y <= 180 &&
                  p.z >= 0 && p.z <= 360;
    }
    if (is_survey)
      refuse_columns(
          "its three columns have no names and could be measured depth, inclination and azimuth as well as "
          "x, y, z");
  }

  const InputFile& file_;
  const WellReading& reading_;
  LineReader lines_;
  Separation separation_;
  WellColumns columns_;
  bool has_header_ = false, is_guessed_ = false;
  std::vector<std::string> order_;
  std::map<std::string, std::vector<Row>> by_well_;
};

Vec3 direction(const SurveyStation& s) {
  constexpr double degree = std::numbers::pi / 180;
  const double i = s.inclination * degree, a = s.azimuth * degree;
  return {std::sin(i) * std::sin(a), std::sin(i) * std::cos(a), -std::cos(i)};
}

}  // namespace

std::vector<Vec3> path_of_survey(const std::vector<SurveyStation>& stations, double most_turn) {
  std::vector<Vec3> path{{0, 0, 0}};
  if (stations.empty()) return path;
  if (stations.front().md > 0) path.push_back({0, 0, -stations.front().md});
  for (std::size_t k = 1; k < stations.size(); ++k) {
    const Vec3 from = direction(stations[k - 1]), to = direction(stations[k]), start = path.back();
    const double length = stations[k].md - stations[k - 1].md;
    const Vec3 normal = cross(from, to);
    const double turn = std::atan2(std::sqrt(dot(normal, normal)), dot(from, to));  // also near 0
    // Turning angle in radians below which an arc is straight: it bulges by about 1e-8 of its length.
    constexpr double straight = 1e-7;
    if (turn < straight) {
      path.push_back(start + length * from);
      continue;
    }
    const int n = std::max(1, static_cast<int>(std::ceil(turn * 180 / (std::numbers::pi * most_turn))));
    for (int i = 1; i <= n; ++i) {  // along the arc of the well path, the direction turns uniformly from `from` to `to`
      const double s = static_cast<double>(i) / n, scale = length / (turn * std::sin(turn));
      path.push_back(start +
                     scale * ((std::cos((1 - s) * turn) - std::cos(turn)) * from + (1 - std::cos(s * turn)) * to));
    }
  }
  return path;
}

FileContents read_well_table(const InputFile& file, const WellReading& reading) {
  return WellTableReader(file, reading).read();
}

}  // namespace geomesh::geomodel

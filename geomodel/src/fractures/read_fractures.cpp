// SPDX-License-Identifier: GPL-3.0-or-later
#include "fractures/read_fractures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <optional>

#include "fractures/fracture_surfaces.hpp"
#include "readers/text/text.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double degree = std::numbers::pi / 180;

using Fields = std::vector<std::string_view>;

/// Splits a line at commas, semicolons, braces and blanks.
Fields split(std::string_view line) {
  Fields fields;
  constexpr std::string_view between = ",;{}()[] \t\r";
  for (std::size_t at = line.find_first_not_of(between); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(between, at), line.size());
    fields.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(between, end);
  }
  return fields;
}

class FractureReader {
 public:
  FractureReader(const InputFile& file, const FractureFileOptions& options)
      : file_(file), options_(options), lines_(file) {}

  std::vector<Fracture> read() {
    while (lines_.next()) {
      const std::string_view line = trim(lines_.line());
      if (line.empty() || line.front() == '#') continue;
      take(split(line));
    }
    if (fractures_.empty()) file_.fail("holds no fracture");
    return std::move(fractures_);
  }

 private:
  void take(const Fields& fields) {
    const bool is_first = is_first_;
    is_first_ = false;
    if (fields.empty()) return;
    if (starts_with_ignoring_case(fields.front(), "nPolygons")) {
      is_dfnworks_ = true;
    } else if (starts_with_ignoring_case(fields.front(), "POLYGON")) {
      add_well_known_text(fields);
    } else if (is_first && !to_double(fields.front())) {
      read_header(fields);
    } else if (!columns_.empty()) {
      add_row(fields);
    } else if (is_dfnworks_) {
      add_counted_polygon(fields);
    } else if (options_.layout == FractureFileOptions::Layout::ellipses) {
      add_ellipse(numbers(fields), is_first);
    } else if (!(is_first && fields.size() == 6)) {  // six numbers in the first line are bounds of PorePy's domain
      add_polygon(numbers(fields));
    }
  }

  std::vector<double> numbers(const Fields& fields) const {
    std::vector<double> values;
    for (const std::string_view field : fields) values.push_back(finite_number(lines_, field, "a number"));
    return values;
  }

  /// Reads a fracture from POLYGON Z ((x y z, ...)), whose last corner repeats the first one.
  void add_well_known_text(const Fields& fields) {
    const std::size_t first = fields.size() > 1 && !to_double(fields[1]) ? 2 : 1;
    add_polygon(numbers({fields.begin() + static_cast<std::ptrdiff_t>(first), fields.end()}));
  }

  void read_header(const Fields& fields) {
    for (std::size_t i = 0; i < fields.size(); ++i) columns_.emplace(to_lower(fields[i]), i);
    for (const char* name : {"x", "y", "z", "dip_direction", "dip"})
      if (!columns_.contains(name))
        lines_.fail(std::string("the header has no column '") + name +
                    "'; x, y, z, radius (or major and minor), dip_direction and dip were expected");
    if (!columns_.contains("radius") && !(columns_.contains("major") && columns_.contains("minor")))
      lines_.fail("the header has no column 'radius', nor 'major' and 'minor'");
  }

  std::optional<double> column(const Fields& fields, const char* name) const {
    const auto at = columns_.find(name);
    if (at == columns_.end()) return std::nullopt;
    if (at->second >= fields.size()) lines_.fail(std::string("the line ends before the column '") + name + "'");
    return finite_number(lines_, fields[at->second], name);
  }

  void add_row(const Fields& fields) {
    Ellipse ellipse;
    ellipse.center = {*column(fields, "x"), *column(fields, "y"), *column(fields, "z")};
    const std::optional<double> radius = column(fields, "radius");
    ellipse.major = radius ? *radius : *column(fields, "major");
    ellipse.minor = radius ? *radius : *column(fields, "minor");
    const auto [strike, dip] = axes_of_plane(*column(fields, "dip_direction"), *column(fields, "dip"));
    turn_axes(ellipse, strike, dip, column(fields, "angle").value_or(0) * degree);
    const auto name = columns_.find("name");
    add(ellipse, options_.n_corners, PolygonSize::same_area,
        name != columns_.end() && name->second < fields.size() ? std::string(fields[name->second]) : std::string());
  }

  static void turn_axes(Ellipse& ellipse, const Vec3& x, const Vec3& y, double angle) {
    ellipse.x_axis = std::cos(angle) * x + std::sin(angle) * y;
    ellipse.y_axis = std::cos(angle) * y - std::sin(angle) * x;
  }

  /// Reads an ellipse in PorePy's form: it lies in the plane z = 0 and is rotated in this plane; then it is rotated by
  /// its dip about a line through its centre, at the angle `strike` from the x axis.
  void add_ellipse(const std::vector<double>& v, bool is_first) {
    if (is_first && v.size() == 6) return;  // the domain
    if (v.size() != 8 && v.size() != 9)
      lines_.fail(
          "eight or nine numbers were expected (center x, y, z, major, minor, angles of the major axis, the "
          "strike and the dip, number of corners); found " +
          std::to_string(v.size()));
    const double unit = options_.degrees ? degree : 1, strike = v[6] * unit, dip = v[7] * unit;
    Ellipse ellipse{{v[0], v[1], v[2]}, v[3], v[4], {}, {}};
    const Vec3 along{std::cos(strike), std::sin(strike), 0};
    const Vec3 across{-std::sin(strike) * std::cos(dip), std::cos(strike) * std::cos(dip), std::sin(dip)};
    turn_axes(ellipse, along, across, v[5] * unit - strike);
    add(ellipse, v.size() == 9 ? static_cast<int>(std::lround(v[8])) : options_.n_corners, PolygonSize::inscribed, "");
  }

  void add(const Ellipse& ellipse, int n_corners, PolygonSize size, std::string name) {
    if (!(ellipse.major > 0 && ellipse.minor > 0)) lines_.fail("a radius (half axis) above zero was expected");
    if (n_corners < 3 || n_corners > 10'000) lines_.fail("three corners or more were expected");
    add_corners(polygon_of(ellipse, n_corners, size), std::move(name));
  }

  void add_counted_polygon(const Fields& fields) {
    const std::vector<double> values = numbers(fields);
    if (values.size() < 10 || values.size() != 1 + 3 * static_cast<std::size_t>(std::max(0.0, values[0])))
      lines_.fail("the number of corners and three coordinates of each were expected; found " +
                  std::to_string(values.size()) + " numbers");
    add_polygon({values.begin() + 1, values.end()});
  }

  void add_polygon(const std::vector<double>& values) {
    if (values.size() < 9 || values.size() % 3 != 0)
      lines_.fail("x, y, z of three corners or more were expected; found " + std::to_string(values.size()) +
                  " numbers" + (values.size() == 8 ? " (for ellipses say layout: ellipses)" : ""));
    std::vector<Vec3> corners;
    for (std::size_t i = 0; i < values.size(); i += 3) corners.push_back({values[i], values[i + 1], values[i + 2]});
    if (corners.size() > 3 && corners.front() == corners.back()) corners.pop_back();
    if (const std::string fault = plane_fault(corners); !fault.empty()) lines_.fail(fault);
    add_corners(std::move(corners), "");
  }

  void add_corners(std::vector<Vec3> corners, std::string name) {
    if (name.empty()) name = options_.name + "_" + std::to_string(fractures_.size() + 1);
    fractures_.push_back({std::move(name), std::move(corners), lines_.number()});
  }

  const InputFile& file_;
  const FractureFileOptions& options_;
  LineReader lines_;
  std::map<std::string, std::size_t> columns_;
  bool is_first_ = true, is_dfnworks_ = false;
  std::vector<Fracture> fractures_;
};

}  // namespace

std::vector<Fracture> read_fracture_file(const std::filesystem::path& path, const FractureFileOptions& options) {
  if (is_file_of_surfaces(path)) return fractures_of_surfaces(path, options.name);
  const InputFile file = load_input_file(path);
  return FractureReader(file, options).read();
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Extrudes lines of a section into surfaces, declared in geomesh/geomodel/section.hpp.
#include <algorithm>
#include <cmath>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "geomesh/geomodel/section.hpp"
#include "readers/tables/first_lines.hpp"
#include "readers/text/frame.hpp"
#include "readers/triangles/polygon.hpp"

namespace geomesh::geomodel {
namespace {

/// Reads polylines from a text with one point of a section per line.
class SectionText {
 public:
  SectionText(const InputFile& file, const ExtrudeSpec& spec) : file_(file), lines_(file), spec_(spec) {}

  /// Reads polylines from a text with one point of a section per line; returns an empty list for any other text.
  std::vector<Polyline> read() {
    bool is_first = true;
    while (lines_.next()) {
      const std::string_view text = trim(lines_.line());
      if (text.empty() || text.front() == '>') {
        end_line();
        heading_ = name_in_heading(text);
        continue;
      }
      if (text.front() == '#' || text.front() == '!') continue;
      if (is_first) {
        is_first = false;
        separation_ = sniff_separation(text);
        const std::size_t n_numbers = count_numbers(text);
        if (n_numbers == 0) {
          if (!read_names(fields_of_line(text, separation_))) return {};
          continue;
        }
        if (n_numbers != 2 || fields_of_line(text, separation_).size() > 3) return {};
        if (fields_of_line(text, separation_).size() == 3) id_ = 2;
      }
      add(separation_.split(text));
    }
    end_line();
    return std::move(found_);
  }
  bool is_depth() const { return is_depth_; }

 private:
  /// Returns the name of a line from its heading: "> A", or "> -L"A"" as GMT writes it.
  static std::string name_in_heading(std::string_view text) {
    if (!text.empty()) text = trim(text.substr(1));
    if (text.starts_with("-L")) text = trim(text.substr(2));
    if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return std::string(text);
  }

  bool read_names(const std::vector<std::string_view>& fields) {
    bool has_place = false, has_height = false;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::string name = column_name_and_unit(fields[i]).first;
      const HeightColumn height = height_column(name);
      if (height.is_height && !height.time && !has_height) {
        height_ = i, has_height = true, is_depth_ = height.depth;
      } else if (name == (spec_.axis == 1 ? "x" : "y") || name == (spec_.axis == 1 ? "easting" : "northing") ||
                 name == "s" || name == "distance" || name == "offset") {
        place_ = i, has_place = true;
      } else if (name == "id" || name == "polygon" || name == "name" || name == "unit" || name == "line") {
        id_ = i;
      }
    }
    return has_place && has_height;
  }

  void add(const std::vector<std::string_view>& fields) {
    if (fields.size() <= std::max(place_, height_)) lines_.fail("a place along the section and a height were expected");
    const auto s = separation_.number(fields[place_]), z = separation_.number(fields[height_]);
    if (!s || !z || !std::isfinite(*s) || !std::isfinite(*z))
      lines_.fail("a place along the section and a height were expected, as numbers");
    const std::string id = id_ && *id_ < fields.size() ? std::string(fields[*id_]) : "";
    if (id != at_id_) end_line();
    at_id_ = id;
    points_.push_back(spec_.axis == 1 ? Vec3{*s, 0, *z} : Vec3{0, *s, *z});
  }

  void end_line() {
    const std::string& given = at_id_.empty() ? heading_ : at_id_;
    const std::string name = given.empty() ? "line " + std::to_string(found_.size() + 1) : given;
    if (!points_.empty()) found_.push_back({name, file_.shown(), std::move(points_)});
    points_.clear();
  }

  const InputFile& file_;
  LineReader lines_;
  const ExtrudeSpec& spec_;
  Separation separation_;
  std::size_t place_ = 0, height_ = 1;
  std::optional<std::size_t> id_;
  bool is_depth_ = false;
  std::string at_id_, heading_;  ///< id and heading line of the polyline that is being read
  std::vector<Vec3> points_;
  std::vector<Polyline> found_;
};

/// Returns twice the area of a closed line in the section; positive if the line is counter-clockwise as seen with z up
/// and the section's axis to the right.
double turning(const std::vector<Vec3>& line, std::size_t along_section) {
  double sum = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec3 &a = line[i], &b = line[(i + 1) % line.size()];
    sum += a[along_section] * b.z - b[along_section] * a.z;
  }
  return sum;
}

}  // namespace

FileContents read_section(const std::filesystem::path& file, const ExtrudeSpec& spec) {
  FileContents contents;
  const InputFile input = load_input_file(file);
  if (!looks_binary(input)) {
    SectionText text(input, spec);
    contents.polylines = text.read();
    contents.frame.depth = contents.frame.z_named = text.is_depth();
    contents.format = "lines of a section";
    if (!contents.polylines.empty()) convert_by_frame(input, contents);
  }
  if (contents.polylines.empty()) contents = read_surface_file(file);
  if (contents.polylines.empty())
    throw Error(ErrorKind::invalid_input,
                input.shown() +
                    ": holds no line of a section; a place along the section and a height a line were "
                    "expected, with or without a first line of names (x, z)");
  return contents;
}

TriangulatedSurface extrude_lines(const std::vector<Polyline>& lines, const ExtrudeSpec& spec, bool closes,
                                  const std::string& name) {
  TriangulatedSurface made;
  const std::size_t axis = spec.axis == 1 ? 1 : 0, along = 1 - axis;
  for (const Polyline& line : lines) {
    std::vector<Vec3> corners;
    for (const Vec3& p : line.points)
      if (corners.empty() || corners.back() != p) corners.push_back(p);
    const bool closed = closes || (corners.size() > 3 && corners.front() == corners.back());
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() < (closed ? 3u : 2u)) continue;
    // Closed lines become counter-clockwise as seen with the axis of extrusion pointing away from the viewer, so that
    // the normals of the extruded surface point outward.
    if (closed && (turning(corners, along) > 0) == (axis == 0)) std::reverse(corners.begin(), corners.end());
    const auto first = static_cast<VertexIndex>(made.points.size()), n = static_cast<VertexIndex>(corners.size());
    for (const double end : {spec.from, spec.to})
      for (Vec3 p : corners) {
        p[axis] = end;
        made.points.push_back(p);
      }
    for (VertexIndex i = 0; i + (closed ? 0 : 1) < n; ++i) {
      const VertexIndex a = first + i, b = first + (i + 1) % n;
      made.triangles.push_back({a, b + n, b});
      made.triangles.push_back({a, a + n, b + n});
    }
    if (!closed) continue;
    std::vector<VertexIndex> loop(n), far(n);
    for (VertexIndex i = 0; i < n; ++i) loop[i] = first + i, far[i] = first + 2 * n - 1 - i;
    for (const auto& cap : {loop, far}) {
      const std::vector<Triangle> triangles = triangulate_polygon(made.points, cap);
      if (triangles.empty())
        throw Error(ErrorKind::invalid_input, "surface " + name + ": the line '" + line.name +
                                                  "' of the section crosses itself or encloses no area");
      made.triangles.insert(made.triangles.end(), triangles.begin(), triangles.end());
    }
  }
  if (made.triangles.empty())
    throw Error(ErrorKind::invalid_input, "surface " + name + ": its section holds no line that could be drawn out");
  return made;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Interprets lines and points of map programs (Shapefile, GeoPackage, GeoJSON), which a module reads with GDAL: which
// column is the name, and which is the height if the points have none.
#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "modules/module.hpp"
#include "readers/formats.hpp"
#include "readers/text/frame.hpp"
#include "readers/text/text.hpp"
#include "readers/vectors/vector_module.hpp"

namespace geomesh::geomodel {
namespace {

const VectorModule& vector_module() {
  static const VectorModule& module = module_table_of<VectorModule>(
      {"geomesh-gdal.so", vector_reader_function, "Shapefile, GeoPackage and GeoJSON are read with GDAL by",
       "geomesh-gdal", "libgdal-dev"});
  return module;
}

/// Returns the name of a map feature: that in its text columns, else that of its layer.
std::string name_of(const VectorFeature& feature) {
  static constexpr std::array names{"name",  "fault", "fault_name", "horizon",   "surface", "formation",
                                    "layer", "unit",  "well",       "well_name", "label",   "id"};
  for (const char* wanted : names)
    for (const auto& [column, value] : feature.texts)
      if (equals_ignoring_case(column, wanted) && !trim(value).empty()) return std::string(trim(value));
  return feature.layer;
}

class VectorReader {
 public:
  explicit VectorReader(const InputFile& file) : file_(file), found_(vector_module().read(file.path.string().c_str())) {
    if (found_.error.find(".shx") != std::string::npos)
      file.fail(
          "the file with the same name and the ending .shx is missing or damaged: the files of a Shapefile (.shp, "
          ".shx, .dbf, .prj) belong together, so copy all of them");
    if (!found_.error.empty()) file.fail(found_.error);
  }

  FileContents read() {
    contents_.format = found_.format == "ESRI Shapefile" ? "Shapefile"
                       : found_.format == "GPKG"         ? "GeoPackage"
                                                         : found_.format;
    contents_.frame.crs = found_.system;
    contents_.frame.geographic = found_.geographic;
    if (std::abs(found_.metres_per_unit - 0.3048) < 1e-9) contents_.frame.unit = "ft";
    if (std::abs(found_.metres_per_unit - 1200.0 / 3937.0) < 1e-9) contents_.frame.unit = "ftUS";
    if (!contents_.frame.unit.empty()) contents_.frame.z_unit = "";
    for (VectorFeature& feature : found_.features) add(feature);
    number_lines();
    if (contents_.polylines.empty() && contents_.point_sets.empty()) file_.fail("holds no lines and no points");
    tell_heights();
    convert_by_frame(file_, contents_);
    for (const std::string& text : found_.warnings) contents_.warnings.push_back("GDAL says: " + text);
    return std::move(contents_);
  }

 private:
  void add(VectorFeature& feature) {
    const std::optional<double> height = height_of(feature);
    const std::string name = name_of(feature);
    const auto place = [&](Vec3& p) {
      if (height) p.z = *height;
    };
    for (std::vector<Vec3>& line : feature.lines) {
      std::for_each(line.begin(), line.end(), place);
      contents_.polylines.push_back({name, file_.shown(), std::move(line)});
    }
    if (feature.points.empty()) return;
    std::for_each(feature.points.begin(), feature.points.end(), place);
    const auto [row, is_new] = set_of_.try_emplace(name, contents_.point_sets.size());
    if (is_new) contents_.point_sets.push_back({name, file_.shown(), {}});
    std::vector<Vec3>& points = contents_.point_sets[row->second].points;
    points.insert(points.end(), feature.points.begin(), feature.points.end());
  }

  /// Returns the height of a map feature whose points have none: the value of the first column that is named like a
  /// height. Nothing if the points have heights, or if there is no such column.
  std::optional<double> height_of(const VectorFeature& feature) {
    if (feature.has_z) return std::nullopt;
    for (const auto& [column, value] : feature.numbers) {
      const HeightColumn height = height_column(column);
      const std::string name = to_lower(column);
      const bool is_contour = name == "contour" || name == "level" || name == "isoline";
      if ((!height.is_height || height.time) && !is_contour) continue;
      height_column_ = column;
      contents_.frame.depth = contents_.frame.depth || height.depth;
      return value;
    }
    ++n_flat_;
    return std::nullopt;
  }

  void number_lines() {
    std::map<std::string, std::size_t> count, at;
    for (const Polyline& line : contents_.polylines) ++count[line.name];
    for (Polyline& line : contents_.polylines)
      if (const std::string name = line.name; count[name] > 1) line.name = name + "__" + std::to_string(++at[name]);
  }

  void tell_heights() {
    if (!height_column_.empty()) contents_.notes.push_back("heights are those of the column '" + height_column_ + "'");
    if (n_flat_ > 0)
      contents_.warnings.push_back(std::to_string(n_flat_) +
                                   " features have no heights, neither of their own nor in a column (z, elevation, "
                                   "depth): they lie at 0");
  }

  const InputFile& file_;
  VectorFile found_;
  FileContents contents_;
  std::map<std::string, std::size_t> set_of_;
  std::string height_column_;
  std::size_t n_flat_ = 0;
};

}  // namespace

bool is_vector(const InputFile& file) {
  const std::string_view text = file.text();
  if (text.starts_with(std::string_view("\0\0\x27\x0a", 4)) || text.starts_with("SQLite format 3")) return true;
  return trim(text.substr(0, 1000)).starts_with('{') &&
         text.substr(0, 5000).find("\"Feature") != std::string_view::npos;
}

FileContents read_vector(const InputFile& file) { return VectorReader(file).read(); }

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the reader of a file: by its content, and by its extension only if the content does not decide.
#include <algorithm>
#include <array>
#include <cmath>

#include "geomesh/geomodel/readers.hpp"
#include "readers/formats.hpp"
#include "readers/text/no_data.hpp"
#include "readers/text/text.hpp"
#include "readers/text/units.hpp"
#include "readers/vtk_legacy.hpp"

namespace geomesh::geomodel {
namespace {

struct Format {
  const char* name;
  const char* extensions;  ///< blank-separated
  bool (*recognises)(const InputFile&);
  FileContents (*read)(const InputFile&);
};

/// Formats of surface files in the order in which they are tried: formats that identify themselves come before those
/// that are recognised by the form of their lines.
constexpr std::array formats{
    Format{"GOCAD", ".ts .ml .pl .vs .wl .mx .gp", is_gocad, read_gocad},
    Format{"PLY", ".ply", is_ply, read_ply},
    Format{"VTK XML", ".vtp .vtu", is_vtk_xml, read_vtk_xml},
    Format{"VTK legacy", ".vtk", is_vtk_legacy, read_vtk_legacy},
    Format{"OFF", ".off", is_off, read_off},
    Format{"GeoTIFF", ".tif .tiff", is_geotiff, read_geotiff},
    Format{"netCDF or HDF5 grid", ".nc .nc4 .cdf .h5 .hdf5", is_netcdf, read_netcdf},
    Format{"Shapefile, GeoPackage, GeoJSON", ".shp .gpkg .geojson", is_vector, read_vector},
    Format{"OMF", ".omf", is_omf, read_omf},
    Format{"DXF", ".dxf", is_dxf, read_dxf},
    Format{"Surfer grid (text)", "", is_surfer_text, read_surfer_text},
    Format{"Surfer 6 grid", "", is_surfer_6, read_surfer_6},
    Format{"Surfer 7 grid", ".grd", is_surfer_7, read_surfer_7},
    Format{"ESRI ASCII grid", ".asc", is_esri_ascii, read_esri_ascii},
    Format{"ZMAP+ grid", ".zmap .zmp", is_zmap, read_zmap},
    Format{"CPS-3 grid", ".cps3 .cps", is_cps3, read_cps3},
    Format{"Irap classic grid", "", is_irap_binary, read_irap_binary},
    Format{"Irap classic grid", ".irap .gri .fgr", is_irap_text, read_irap_text},
    Format{"EarthVision", "", is_earth_vision, read_earth_vision},
    Format{"Petrel points", "", is_petrel_points, read_petrel_points},
    Format{"Charisma fault sticks", "", is_charisma, read_charisma},
    Format{"STL", ".stl", is_stl, read_stl},
    Format{"OBJ", ".obj", is_obj, read_obj},
    Format{"points (XYZ, CSV)", ".xyz .csv .txt .dat .pts", is_xyz, read_xyz},
};

const Format* by_extension(const InputFile& file) {
  const std::string wanted = file.extension();
  if (wanted.empty()) return nullptr;
  for (const Format& f : formats) {
    const std::string all = std::string(f.extensions) + " ";
    if (*f.extensions && all.find(wanted + " ") != std::string::npos) return &f;
  }
  return nullptr;
}

/// A file format from which no surface can be read, with advice on what to do instead.
struct Stranger {
  std::string_view begins;  ///< first bytes of a file of the format; empty if only the extension identifies it
  const char* extensions;   ///< blank-separated
  const char* advice;
};
constexpr std::array strangers{
    Stranger{{}, ".zip .gz .7z .rar .kmz", "an archive is not read: unpack it, and name the file that was in it"},
    Stranger{{"PK\x03\x04", 4},
             ".xlsx .xlsm .ods",
             "a workbook of Excel or LibreOffice is not read: save the sheet with the points as CSV"},
    Stranger{{"\xd0\xcf\x11\xe0", 4}, ".xls", "a workbook of Excel is not read: save the sheet with the points as CSV"},
    Stranger{{},
             ".sgy .segy",
             "SEG-Y holds seismic traces, not surfaces: export the interpreted horizons and faults from the "
             "interpretation program as points (XYZ), ZMAP+, CPS-3 or GOCAD"},
    Stranger{{"~V", 2},
             ".las",
             "LAS holds logs along a well, not its path: give the deviation survey (MD, inclination, azimuth) or x, y, "
             "z of the path as a table"},
    Stranger{{"\xff\xfe", 2}, "", "the text is UTF-16 ('Unicode text'): save it as CSV or as text in UTF-8"},
};

void refuse_strangers(const InputFile& file) {
  for (const Stranger& stranger : strangers) {
    const std::string all = std::string(stranger.extensions) + " ", own = file.extension();
    const bool begins = !stranger.begins.empty() && file.text().starts_with(stranger.begins);
    if (begins || (!own.empty() && all.find(own + " ") != std::string::npos)) file.fail(stranger.advice);
  }
}

[[noreturn]] void refuse_unknown(const InputFile& file) {
  if (trim(file.text()).empty()) file.fail("the file is empty");
  refuse_strangers(file);
  if (const Format* f = by_extension(file)) {
    file.fail(std::string(looks_binary(file) ? "a binary file, not " : "does not begin as ") + f->name +
              ", though its extension says so");
  }
  std::string known;
  for (const Format& f : formats)
    if (known.find(f.name) == std::string::npos) known += std::string(known.empty() ? "" : ", ") + f.name;
  file.fail("its format is not known; these are read: " + known);
}

}  // namespace

namespace {

void keep_used_points(TriangulatedSurface& surface) {
  std::vector<VertexIndex> row(surface.points.size(), no_vertex);
  for (const Triangle& t : surface.triangles)
    for (const VertexIndex v : t) row[v] = 0;
  std::vector<Vec3> kept;
  for (std::size_t v = 0; v < row.size(); ++v) {
    if (row[v] == no_vertex) continue;
    row[v] = static_cast<VertexIndex>(kept.size());
    kept.push_back(surface.points[v]);
  }
  for (Triangle& t : surface.triangles)
    for (VertexIndex& v : t) v = row[v];
  surface.points = std::move(kept);
}

/// Returns whether a surface is a layer, like a horizon, apart from unusual heights (`odd`): most triangles have no
/// such corner, and these have one height over each place of the map. Only then are the unusual heights removed;
/// otherwise the flat base of a fault or body, which is far from its other vertices too, would be lost.
bool is_layer_without(const TriangulatedSurface& s, const std::vector<double>& heights,
                      std::span<const OddHeight> odd) {
  const auto is_odd = [&](VertexIndex v) {
    return std::any_of(odd.begin(), odd.end(), [&](const OddHeight& o) { return o.value == heights[v]; });
  };
  double signed_area = 0, area = 0, area_without = 0;
  for (const Triangle& t : s.triangles) {
    const Vec3 &a = s.points[t[0]], &b = s.points[t[1]], &c = s.points[t[2]];
    const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    signed_area += twice;
    area += std::abs(twice);
    if (std::none_of(t.begin(), t.end(), is_odd)) area_without += std::abs(twice);
  }
  constexpr double nearly_all = 0.99, most = 0.5;
  return std::abs(signed_area) > nearly_all * area && area_without > most * area;
}

/// Returns heights as the numbers in the file, because formats other than grids and tables convert units while reading.
std::vector<double> heights_in_file(const std::vector<Vec3>& points, const SourceFrame& frame) {
  const std::string& unit = frame.z_unit.empty() ? frame.unit : frame.z_unit;
  const double factor = length_unit_in_metres(unit).value_or(1) * (frame.depth ? -1 : 1);
  std::vector<double> heights;
  heights.reserve(points.size());
  for (const Vec3& p : points) {
    const double v = p.z / factor, rounded = std::round(v * 1000) / 1000;
    heights.push_back(std::abs(v - rounded) <= 1e-12 * std::abs(v) ? rounded : v);
  }
  return heights;
}

void keep_no_data_alone(std::vector<OddHeight>& odd) {
  std::erase_if(odd, [](const OddHeight& o) { return o.kind != OddHeight::Kind::no_data; });
}

/// Adds a message on unusual heights to the warnings, unless the same message is there already.
void tell_odd(const std::string& name, const std::vector<Vec3>& points, const std::vector<OddHeight>& odd,
              const char* what, FileContents& contents) {
  for (std::string& text :
       describe_odd_heights(odd, name, what, [&](std::size_t row) { return map_place_words(points[row]); }))
    if (std::find(contents.warnings.begin(), contents.warnings.end(), text) == contents.warnings.end())
      contents.warnings.push_back(std::move(text));
}

/// Removes the points of polylines whose heights mean "no value". The heights of all polylines are examined together,
/// because a single line may have few points.
void drop_no_data_of_lines(const InputFile& file, FileContents& contents) {
  std::vector<Vec3> points;
  for (const Polyline& line : contents.polylines) points.insert(points.end(), line.points.begin(), line.points.end());
  const std::vector<double> heights = heights_in_file(points, contents.frame);
  std::vector<OddHeight> odd = find_odd_heights(heights, file.options);
  keep_no_data_alone(odd);
  if (odd.empty()) return;
  tell_odd(file.path.stem().string(), points, odd, "points on lines", contents);
  std::size_t row = 0;
  for (Polyline& line : contents.polylines)
    std::erase_if(line.points, [&](const Vec3&) { return is_left_out(heights[row++], odd); });
  std::erase_if(contents.polylines, [](const Polyline& line) { return line.points.size() < 2; });
}

/// Removes vertices and points whose heights mean "no value", and reports heights that are implausible. The readers of
/// grids and tables have done this before.
void drop_no_data(const InputFile& file, FileContents& contents) {
  for (TriangulatedSurface& surface : contents.surfaces) {
    const bool from_grid = std::any_of(contents.grids.begin(), contents.grids.end(),
                                       [&](const GridSummary& g) { return g.surface == surface.name; });
    if (from_grid) continue;
    const std::vector<double> heights = heights_in_file(surface.points, contents.frame);
    std::vector<OddHeight> odd = find_odd_heights(heights, file.options);
    if (!odd.empty() && !is_layer_without(surface, heights, odd)) keep_no_data_alone(odd);
    tell_odd(surface.name, surface.points, odd, "vertices", contents);
    keep_no_data_alone(odd);
    if (odd.empty()) continue;
    std::erase_if(surface.triangles, [&](const Triangle& t) {
      return std::any_of(t.begin(), t.end(), [&](VertexIndex v) { return is_left_out(heights[v], odd); });
    });
    if (surface.triangles.empty()) file.fail("no triangle of '" + surface.name + "' has heights at its corners");
    keep_used_points(surface);
    contents.regions.clear();  // The regions of a GOCAD model refer to rows of triangles, some of which were removed.
  }
  for (PointSet& set : contents.point_sets) {
    const std::vector<double> heights = heights_in_file(set.points, contents.frame);
    const std::vector<OddHeight> odd = find_odd_heights(heights, file.options);
    tell_odd(set.name, set.points, odd, "points", contents);
    std::size_t row = 0;
    std::erase_if(set.points, [&](const Vec3&) { return is_left_out(heights[row++], odd); });
  }
  drop_no_data_of_lines(file, contents);
}

void names_in_utf8(FileContents& contents) {
  const auto fix = [](std::string& text) { text = as_utf8(text); };
  for (auto& s : contents.surfaces) fix(s.name);
  for (auto& l : contents.polylines) fix(l.name);
  for (auto& p : contents.points) fix(p.name);
  for (auto& s : contents.point_sets) fix(s.name);
  for (auto& r : contents.regions) fix(r.name);
  for (auto& g : contents.grids) fix(g.surface);
  for (auto* texts : {&contents.arrays, &contents.notes, &contents.warnings})
    for (std::string& text : *texts) fix(text);
}

}  // namespace

static InputFile load(const std::filesystem::path& path, const ReadOptions& options) {
  InputFile file = load_input_file(path);
  file.options = options;
  // UTF-8 files from Windows begin with a byte order mark, which is removed.
  if (file.text().starts_with("\xef\xbb\xbf")) file.bytes.erase(0, 3);
  return file;
}

FileContents read_well_file(const std::filesystem::path& path, const WellReading& reading) {
  const InputFile file = load(path, reading.options);
  const auto format = std::find_if(formats.begin(), formats.end(), [&](const Format& f) { return f.recognises(file); });
  if (format == formats.end() && (looks_binary(file) || trim(file.text()).empty())) refuse_unknown(file);
  if (format == formats.end()) refuse_strangers(file);
  const bool is_table = format == formats.end() || format->read == read_xyz;
  FileContents contents = is_table ? read_well_table(file, reading) : format->read(file);
  if (!is_table) drop_no_data(file, contents);
  names_in_utf8(contents);
  return contents;
}

FileContents read_surface_file(const std::filesystem::path& path, const ReadOptions& options) {
  const InputFile file = load(path, options);
  for (const Format& format : formats) {
    if (!format.recognises(file)) continue;
    FileContents contents = format.read(file);
    drop_no_data(file, contents);
    names_in_utf8(contents);
    return contents;
  }
  refuse_unknown(file);
}

}  // namespace geomesh::geomodel

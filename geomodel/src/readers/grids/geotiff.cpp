// SPDX-License-Identifier: GPL-3.0-or-later
// GeoTIFF through GDAL: pixel-is-area and pixel-is-point come out of its geotransform alike, as do no-data tag, scale
// and offset. The raster is taken from memory and its size compared with the file's before anything is allocated.
#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

#include "readers/formats.hpp"
#include "readers/grids/grid.hpp"
#include "readers/text/frame.hpp"

namespace geomesh::geomodel {
namespace {

/// GDAL's messages are collected instead of printed as long as it stands; the last one is told by CPLGetLastErrorMsg
/// too.
class QuietScope {
 public:
  QuietScope() {
    CPLErrorReset();
    CPLPushErrorHandlerEx(collect, &messages);
  }
  ~QuietScope() { CPLPopErrorHandler(); }
  QuietScope(const QuietScope&) = delete;
  QuietScope& operator=(const QuietScope&) = delete;

  std::vector<std::string> messages;

 private:
  static void CPL_STDCALL collect(CPLErr level, CPLErrorNum, const char* text) {
    auto& messages = *static_cast<std::vector<std::string>*>(CPLGetErrorHandlerUserData());
    if (level >= CE_Warning && messages.size() < 5) messages.emplace_back(text);
  }
};

struct CloseDataset {
  void operator()(GDALDataset* d) const { GDALClose(d); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

/// The bytes of the file under a name that GDAL can open.
class MemoryFile {
 public:
  explicit MemoryFile(const InputFile& file)
      : name_("/vsimem/geomesh_" + std::to_string(reinterpret_cast<std::uintptr_t>(&file)) + ".tif") {
    auto* bytes = reinterpret_cast<GByte*>(const_cast<char*>(file.bytes.data()));  // opened for reading alone
    VSIFCloseL(VSIFileFromMemBuffer(name_.c_str(), bytes, file.size(), FALSE));
  }
  ~MemoryFile() { VSIUnlink(name_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

[[noreturn]] void fail_with_reason(const InputFile& file, const std::string& what) {
  const std::string reason = CPLGetLastErrorMsg();
  file.fail(what + (reason.empty() ? "" : ": " + reason));
}

Dataset open(const InputFile& file, const std::string& name) {
  static std::once_flag registered;
  std::call_once(registered, [] {
    CPLSetConfigOption("GDAL_CACHEMAX", "64");
    GDALRegister_GTiff();
  });
  const char* const drivers[] = {"GTiff", nullptr};
  const char* const no_siblings[] = {nullptr};
  Dataset data(static_cast<GDALDataset*>(
      GDALOpenEx(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers, nullptr, no_siblings)));
  if (!data) fail_with_reason(file, "the TIFF file cannot be read");
  return data;
}

/// Columns and rows, refused where a compressed file could not hold them.
std::pair<std::size_t, std::size_t> raster_size(const InputFile& file, GDALDataset& data) {
  constexpr std::size_t most_nodes_a_byte = 2000, most_nodes = 400'000'000;
  const auto n_columns = static_cast<std::size_t>(data.GetRasterXSize()),
             n_rows = static_cast<std::size_t>(data.GetRasterYSize());
  if (n_columns < 2 || n_rows < 2) file.fail("the raster has fewer than two columns or rows");
  if (n_columns > std::min(file.size() * most_nodes_a_byte, most_nodes) / n_rows) {
    file.fail("the raster is given as " + std::to_string(n_columns) + " by " + std::to_string(n_rows) +
              " cells, which a file of " + std::to_string(file.size()) +
              " bytes does not hold or the memory would not; cut it to the area of the model");
  }
  return {n_columns, n_rows};
}

void describe_crs(GDALDataset& data, FileContents& contents) {
  const OGRSpatialReference* crs = data.GetSpatialRef();
  if (!crs) return;
  const char* authority = crs->GetAuthorityName(nullptr);
  const char* code = crs->GetAuthorityCode(nullptr);
  if (authority && code && EQUAL(authority, "EPSG")) contents.frame.crs = std::string("epsg:") + code;
  if (const char* name = crs->GetName(); name && contents.frame.crs.empty()) contents.frame.crs = name;
  contents.frame.geographic = crs->IsGeographic() != 0;
  if (crs->IsProjected()) {
    const char* unit = nullptr;
    const double metres = crs->GetLinearUnits(&unit);
    if (std::abs(metres - 0.3048) < 1e-9) contents.frame.unit = "ft";
    if (std::abs(metres - 1200.0 / 3937.0) < 1e-9) contents.frame.unit = "ftUS";
    if (metres == 1000) contents.frame.unit = "km";
  }
}

/// Heights of band 1 at the cells' centres; rows as in the file.
NodeLattice read_nodes(const InputFile& file, GDALDataset& data, GDALRasterBand& band) {
  double t[6];
  if (data.GetGeoTransform(t) != CE_None)
    file.fail("the TIFF file says nowhere where it lies (no geotransform, no tie points): a GeoTIFF was expected");
  for (const double v : t)
    if (!std::isfinite(v)) file.fail("the georeference holds a number that is not finite");
  if (t[1] * t[5] - t[2] * t[4] == 0) file.fail("the georeference gives cells of no area");
  const auto [n_columns, n_rows] = raster_size(file, data);
  int has_no_data = 0;
  const double no_data = band.GetNoDataValue(&has_no_data), scale = band.GetScale(), offset = band.GetOffset();
  NodeLattice lattice{n_columns, n_rows, {}};
  std::vector<double> row(n_columns);
  for (std::size_t j = 0; j < n_rows; ++j) {
    const CPLErr error = band.RasterIO(GF_Read, 0, static_cast<int>(j), static_cast<int>(n_columns), 1, row.data(),
                                       static_cast<int>(n_columns), 1, GDT_Float64, 0, 0);
    if (error != CE_None)
      fail_with_reason(file, "row " + std::to_string(j) + " of the raster cannot be read (truncated?)");
    for (std::size_t i = 0; i < n_columns; ++i) {
      const double u = static_cast<double>(i) + 0.5, v = static_cast<double>(j) + 0.5;
      const bool present = std::isfinite(row[i]) && !(has_no_data && row[i] == no_data);
      lattice.nodes.push_back({t[0] + u * t[1] + v * t[2], t[3] + u * t[4] + v * t[5],
                               present ? row[i] * scale + offset : std::numeric_limits<double>::quiet_NaN()});
    }
  }
  return lattice;
}

}  // namespace

bool is_geotiff(const InputFile& file) {
  const std::string_view head = file.text().substr(0, 4);
  return head == std::string_view("II*\0", 4) || head == std::string_view("MM\0*", 4) ||
         head == std::string_view("II+\0", 4) || head == std::string_view("MM\0+", 4);
}

FileContents read_geotiff(const InputFile& file) {
  const QuietScope quiet;
  const MemoryFile memory(file);
  const Dataset data = open(file, memory.name());
  if (data->GetRasterCount() < 1) file.fail("the TIFF file holds no band");
  GDALRasterBand& band = *data->GetRasterBand(1);
  const NodeLattice lattice = read_nodes(file, *data, band);
  FileContents contents;
  contents.format = "GeoTIFF";
  describe_crs(*data, contents);
  if (const std::string unit = band.GetUnitType(); !unit.empty()) contents.frame.z_unit = unit == "metre" ? "m" : unit;
  double t[6];
  data->GetGeoTransform(t);
  const double rotation = std::atan2(t[4], t[1]) * 180 / 3.14159265358979323846;
  const Vec3& first = lattice.nodes[(lattice.n_rows - 1) * lattice.n_columns];
  add_lattice(file, file.path.stem().string(), lattice,
              {{}, 0, 0, 0, {first.x, first.y}, {std::hypot(t[1], t[4]), std::hypot(t[2], t[5])}, rotation, true},
              contents);
  contents.notes.push_back(
      "values of cells: they stand at the cells' centres, so the surface ends half a cell inside the raster");
  if (data->GetRasterCount() > 1)
    contents.warnings.push_back("band 1 of " + std::to_string(data->GetRasterCount()) + " is taken as height");
  convert_by_frame(file, contents);
  for (const std::string& text : quiet.messages) contents.warnings.push_back("GDAL says: " + text);
  return contents;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Reads rasters with GDAL: a module that the program loads when it finds a GeoTIFF. Its interface is
// readers/grids/geotiff_plugin.hpp.
#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "readers/grids/geotiff_plugin.hpp"

namespace {

struct CloseDataset {
  void operator()(GDALDataset* d) const { GDALClose(d); }
};

/// Makes the bytes of a file available under a name that GDAL can open.
class MemoryFile {
 public:
  MemoryFile(const char* bytes, std::size_t size)
      : name_("/vsimem/geomesh_" + std::to_string(reinterpret_cast<std::uintptr_t>(bytes)) + ".tif") {
    auto* opened_for_reading_alone = reinterpret_cast<GByte*>(const_cast<char*>(bytes));
    VSIFCloseL(VSIFileFromMemBuffer(name_.c_str(), opened_for_reading_alone, size, FALSE));
  }
  ~MemoryFile() { VSIUnlink(name_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

struct Raster : GeomeshRaster {
  Raster(const char* bytes, std::size_t size) : GeomeshRaster{}, file(bytes, size) {}
  MemoryFile file;  // closed last
  std::unique_ptr<GDALDataset, CloseDataset> data;
  std::string error_text, unit_text, system_text;
  std::vector<std::string> warnings;
  std::size_t n_warnings_told = 0;
};

/// While this object exists, GDAL's messages are stored in the raster instead of printed; CPLGetLastErrorMsg also
/// returns the last one.
class Listening {
 public:
  explicit Listening(Raster& raster) {
    CPLErrorReset();
    CPLPushErrorHandlerEx(collect, &raster);
  }
  ~Listening() { CPLPopErrorHandler(); }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;

 private:
  static void CPL_STDCALL collect(CPLErr level, CPLErrorNum, const char* text) {
    constexpr std::size_t most_warnings = 5;
    auto& warnings = static_cast<Raster*>(CPLGetErrorHandlerUserData())->warnings;
    if (level >= CE_Warning && warnings.size() < most_warnings) warnings.emplace_back(text);
  }
};

const char* with_reason(Raster& raster, const char* what) {
  const std::string reason = CPLGetLastErrorMsg();
  raster.error_text = what + (reason.empty() ? "" : ": " + reason);
  return raster.error_text.c_str();
}

void describe_system(Raster& raster) {
  raster.metres_per_unit = 1;
  const OGRSpatialReference* crs = raster.data->GetSpatialRef();
  if (!crs) return;
  const char *authority = crs->GetAuthorityName(nullptr), *code = crs->GetAuthorityCode(nullptr);
  if (authority && code && EQUAL(authority, "EPSG")) {
    raster.system_text = std::string("epsg:") + code;
  } else if (const char* name = crs->GetName()) {
    raster.system_text = name;
  }
  raster.is_geographic = crs->IsGeographic() != 0;
  if (crs->IsProjected()) raster.metres_per_unit = crs->GetLinearUnits();
}

void describe_band(Raster& raster) {
  GDALRasterBand& band = *raster.data->GetRasterBand(1);
  raster.no_data = band.GetNoDataValue(&raster.has_no_data);
  raster.scale = band.GetScale();
  raster.offset = band.GetOffset();
  raster.unit_text = band.GetUnitType();
}

void open_into(Raster& raster) {
  static std::once_flag registered;
  std::call_once(registered, [] {
    CPLSetConfigOption("GDAL_CACHEMAX", "64");
    GDALRegister_GTiff();
  });
  const Listening listening(raster);
  const char* const drivers[] = {"GTiff", nullptr};
  const char* const no_siblings[] = {nullptr};
  raster.data.reset(static_cast<GDALDataset*>(
      GDALOpenEx(raster.file.name().c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers, nullptr, no_siblings)));
  if (!raster.data) {
    with_reason(raster, "the TIFF file cannot be read");
    return;
  }
  raster.n_columns = static_cast<std::size_t>(raster.data->GetRasterXSize());
  raster.n_rows = static_cast<std::size_t>(raster.data->GetRasterYSize());
  raster.n_bands = static_cast<std::size_t>(raster.data->GetRasterCount());
  raster.has_transform = raster.data->GetGeoTransform(raster.transform) == CE_None;
  describe_system(raster);
  if (raster.n_bands > 0) describe_band(raster);
}

GeomeshRaster* open_raster(const char* bytes, std::size_t size) {
  auto raster = std::make_unique<Raster>(bytes, size);
  try {
    open_into(*raster);
  } catch (const std::exception& e) {  // no exception may cross the interface
    raster->error_text = e.what();
  }
  raster->error = raster->error_text.c_str();
  raster->unit_of_heights = raster->unit_text.c_str();
  raster->system = raster->system_text.c_str();
  return raster.release();
}

const char* read_row(GeomeshRaster* opened, std::size_t row, double* heights) {
  Raster& raster = *static_cast<Raster*>(opened);
  const Listening listening(raster);
  const auto n = static_cast<int>(raster.n_columns);
  const CPLErr error = raster.data->GetRasterBand(1)->RasterIO(GF_Read, 0, static_cast<int>(row), n, 1, heights, n, 1,
                                                               GDT_Float64, 0, 0);
  return error == CE_None ? nullptr : with_reason(raster, "cannot be read (truncated?)");
}

const char* next_warning(GeomeshRaster* opened) {
  Raster& raster = *static_cast<Raster*>(opened);
  return raster.n_warnings_told < raster.warnings.size() ? raster.warnings[raster.n_warnings_told++].c_str() : nullptr;
}

void close_raster(GeomeshRaster* opened) { delete static_cast<Raster*>(opened); }

}  // namespace

extern "C" __attribute__((visibility("default"))) const GeomeshRasterReader* geomesh_raster_reader() {
  static constexpr GeomeshRasterReader reader{geomesh::geomodel::geomesh_raster_reader_version, open_raster, read_row,
                                              next_warning, close_raster};
  return &reader;
}

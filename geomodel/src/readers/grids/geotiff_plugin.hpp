// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The interface between the reader of GeoTIFF and the module that reads TIFF with GDAL (geomodel/plugins/gdal.cpp):
/// plain data and three functions, so that the module may be built separately. GDAL needs about sixty shared libraries;
/// a program that reads no GeoTIFF does not load them.
#pragma once

#include <cstddef>

extern "C" {

/// An open raster, or the reason why it could not be opened. Its texts are valid as long as it exists.
struct GeomeshRaster {
  const char* error;  ///< empty if the raster is open
  std::size_t n_columns, n_rows, n_bands;
  int has_transform;
  /// As GDAL's geotransform: position of (column, row), counted from the corner of the first cell.
  double transform[6];
  int has_no_data;
  double no_data, scale, offset;  ///< of band 1
  const char* unit_of_heights;    ///< unit of band 1, as written
  const char* system;             ///< "epsg:CODE", else the system's name, else empty
  int is_geographic;
  double metres_per_unit;  ///< unit of x and y in metres; 1 for degrees
};

/// The functions of the module.
struct GeomeshRasterReader {
  int version;  ///< geomesh_raster_reader_version of the header with which it was built
  /// Never returns null. `bytes` must outlive the raster.
  GeomeshRaster* (*open)(const char* bytes, std::size_t size);
  /// Reads a row of band 1 as written, from the north. Returns null, or the reason why it cannot be read, valid as long
  /// as the raster exists.
  const char* (*read_row)(GeomeshRaster* raster, std::size_t row, double* heights);
  /// Returns the next message of GDAL; null if there are no more.
  const char* (*next_warning)(GeomeshRaster* raster);
  void (*close)(GeomeshRaster* raster);
};
}

namespace geomesh::geomodel {

constexpr int geomesh_raster_reader_version = 1;

/// Loads the module at the first call. Throws Error{usage} that names the package if it is missing.
const GeomeshRasterReader& geotiff_plugin();

}  // namespace geomesh::geomodel

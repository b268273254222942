// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The border between the reader of GeoTIFF and the module that reads TIFF by GDAL (geomodel/plugins/gdal.cpp): plain
/// data and three functions, so that the module may be built apart. GDAL needs about sixty shared libraries; a program
/// that reads no GeoTIFF does without them.
#pragma once

#include <cstddef>

extern "C" {

/// An open raster, or why it could not be opened. Its texts live as long as it does.
struct GeomeshRaster {
  const char* error;  ///< empty where the raster is open
  std::size_t n_columns, n_rows, n_bands;
  int has_transform;
  double transform[6];  ///< as GDAL's geotransform: place of (column, row), counted from the corner of the first cell
  int has_no_data;
  double no_data, scale, offset;  ///< of band 1
  const char* unit_of_heights;    ///< of band 1, as written
  const char* system;             ///< "epsg:CODE", else the system's name, else empty
  int is_geographic;
  double metres_per_unit;  ///< of x and y; 1 for degrees
};

/// What the module gives.
struct GeomeshRasterReader {
  int version;  ///< geomesh_raster_reader_version of the header it was built with
  /// Never null. `bytes` must outlive the raster.
  GeomeshRaster* (*open)(const char* bytes, std::size_t size);
  /// Row of band 1 as written, from the north; null, or why it cannot be read, as long as the raster lives.
  const char* (*read_row)(GeomeshRaster* raster, std::size_t row, double* heights);
  /// The next thing that GDAL complained about; null where nothing is left.
  const char* (*next_warning)(GeomeshRaster* raster);
  void (*close)(GeomeshRaster* raster);
};
}

namespace geomesh::geomodel {

constexpr int geomesh_raster_reader_version = 1;

/// Loads the module at the first call. Throws Error{usage} that names the package where there is none.
const GeomeshRasterReader& geotiff_plugin();

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The interface between the reader of GeoTIFF and the module that reads TIFF with GDAL (geomodel/plugins/gdal.cpp):
/// plain data and three functions, so that the module may be built separately. GDAL needs about sixty shared libraries;
/// a program that reads no GeoTIFF does not load them.
#pragma once

#include <cstddef>

extern "C" {

/// A raster that the module has opened, or the reason why it could not be opened. Its texts exist as long as this
/// object.
struct GeomeshRaster {
  const char* error;  ///< reason why the raster could not be opened; empty if it is open
  std::size_t n_columns, n_rows, n_bands;
  int has_transform;
  /// Position of (column, row), counted from the corner of the first cell, as in GDAL's geotransform.
  double transform[6];
  int has_no_data;
  double no_data, scale, offset;  ///< of band 1
  const char* unit_of_heights;    ///< unit of the heights in band 1, as the file writes it
  const char* system;             ///< coordinate system of the raster: "epsg:CODE", else its name, else empty
  int is_geographic;
  double metres_per_unit;  ///< metres per unit of the raster's x and y; 1 for degrees
};

struct GeomeshRasterReader {
  int version;  ///< version of this interface with which the GDAL module was built
  /// Opens a raster from memory. Never returns null. `bytes` must outlive the raster.
  GeomeshRaster* (*open)(const char* bytes, std::size_t size);
  /// Reads one row of band 1 as the file has it; rows count from the north. Returns null, or the reason why the row
  /// cannot be read, as a text that is valid as long as the raster exists.
  const char* (*read_row)(GeomeshRaster* raster, std::size_t row, double* heights);
  /// Returns the next warning that GDAL issued; null if there are no more.
  const char* (*next_warning)(GeomeshRaster* raster);
  void (*close)(GeomeshRaster* raster);
};
}

namespace geomesh::geomodel {

constexpr int geomesh_raster_reader_version = 1;

/// Loads the module that reads rasters, at the first call. Throws Error{usage} with its package if it is missing.
const GeomeshRasterReader& geotiff_plugin();

}  // namespace geomesh::geomodel

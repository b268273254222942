// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The interface between the reader of lines and points of map programs and the module that reads them with GDAL
/// (geomodel/plugins/gdal_vector.cpp). C++ types are passed through it, so both sides must come from the same build;
/// exceptions are not.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

struct VectorFeature {
  std::string layer;
  std::vector<std::pair<std::string, std::string>> texts;  ///< names and values of the text columns of a map feature
  std::vector<std::pair<std::string, double>> numbers;     ///< names and values of the numeric columns of a map feature
  bool has_z = false;                    ///< whether the points of the map feature have a z coordinate
  std::vector<std::vector<Vec3>> lines;  ///< lines of the map feature, and rings of its polygons
  std::vector<Vec3> points;
};

struct VectorFile {
  std::string error;   ///< reason why the file was not read; empty if it was
  std::string format;  ///< "Shapefile", ...
  std::string system;  ///< coordinate system of the layer: "epsg:CODE", else its name, else empty
  bool geographic = false;
  double metres_per_unit = 1;
  std::vector<VectorFeature> features;
  std::vector<std::string> warnings;  ///< of GDAL
};

struct VectorModule {
  const char* version;  ///< GEOMESH_MODULE_VERSION
  VectorFile (*read)(const char* path);
};
/// Name of the function that the module exports: const VectorModule* geomesh_vector_reader().
constexpr const char* vector_reader_function = "geomesh_vector_reader";

}  // namespace geomesh::geomodel

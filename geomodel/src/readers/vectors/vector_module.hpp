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

/// One feature of a layer.
struct VectorFeature {
  std::string layer;
  std::vector<std::pair<std::string, std::string>> texts;  ///< names and values of its text columns
  std::vector<std::pair<std::string, double>> numbers;     ///< names and values of its numeric columns
  bool has_z = false;                                      ///< whether its points have heights of their own
  std::vector<std::vector<Vec3>> lines;                    ///< lines and rings of polygons
  std::vector<Vec3> points;
};

struct VectorFile {
  std::string error;   ///< empty if the file was read
  std::string format;  ///< "Shapefile", ...
  std::string system;  ///< "epsg:CODE", else the system's name, else empty
  bool geographic = false;
  double metres_per_unit = 1;
  std::vector<VectorFeature> features;
  std::vector<std::string> warnings;  ///< of GDAL
};

struct VectorModule {
  const char* version;  ///< GEOMESH_MODULE_VERSION
  VectorFile (*read)(const char* path);
};
/// Name of the module's function: const VectorModule* geomesh_vector_reader().
constexpr const char* vector_reader_function = "geomesh_vector_reader";

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The border between the reader of lines and points of map programs and the module that reads them by GDAL
/// (geomodel/plugins/gdal_vector.cpp). Types of C++ cross it, so both sides are of one build; exceptions do not.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// One feature of a layer.
struct VectorFeature {
  std::string layer;
  std::vector<std::pair<std::string, std::string>> texts;  ///< names and values of its columns of text
  std::vector<std::pair<std::string, double>> numbers;     ///< and of its columns of numbers
  bool has_z = false;                                      ///< its points have heights of their own
  std::vector<std::vector<Vec3>> lines;                    ///< lines and rings of polygons
  std::vector<Vec3> points;
};

struct VectorFile {
  std::string error;   ///< empty where the file was read
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
/// The function of the module: const VectorModule* geomesh_vector_reader().
constexpr const char* vector_reader_function = "geomesh_vector_reader";

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The border between the reader of fields and the module that reads netCDF and HDF5 files
/// (geomodel/plugins/netcdf_grids.cpp). Types of C++ cross it, so both sides are of one build.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace geomesh::geomodel {

/// A variable over three axes.
struct NetcdfField {
  std::string name;                         ///< empty: none was chosen
  std::array<std::vector<double>, 3> axes;  ///< places along x, y, z as the file has them, in equal steps, rising
  std::vector<double> values;               ///< x fastest; NaN: no value
  std::vector<std::string> names;           ///< of all variables over three axes
};

struct NetcdfFieldModule {
  const char* version;  ///< GEOMESH_MODULE_VERSION
  /// The variable over three axes of that name, with or without its groups; without a name, the only one. Throws
  /// Error{invalid_input} where the file is damaged, an axis has no places or its steps have several lengths.
  NetcdfField (*read)(const std::filesystem::path& file, const std::string& name);
};
/// The function of the module: const NetcdfFieldModule* geomesh_netcdf_fields().
constexpr const char* netcdf_fields_function = "geomesh_netcdf_fields";

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The interface between the reader of fields and the module that reads netCDF and HDF5 files
/// (geomodel/plugins/netcdf_grids.cpp). C++ types are passed through it, so both sides must come from the same build.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace geomesh::geomodel {

/// A variable of a netCDF or HDF5 file with three dimensions.
struct NetcdfField {
  std::string name;  ///< name of the netCDF or HDF5 variable; empty if the file has no suitable one
  /// Coordinates along the variable's axes x, y and z as in the file; they must be ascending and evenly spaced.
  std::array<std::vector<double>, 3> axes;
  std::vector<double> values;      ///< values of the 3D variable with x varying fastest; NaN where there is none
  std::vector<std::string> names;  ///< names of all variables of the file with three dimensions
};

struct NetcdfFieldModule {
  const char* version;  ///< GEOMESH_MODULE_VERSION
  /// Reads the 3D netCDF or HDF5 variable of this name (with or without its groups); if the name is empty, the only
  /// one. Throws Error{invalid_input} if the file is damaged, or if an axis has no coordinates or uneven steps.
  NetcdfField (*read)(const std::filesystem::path& file, const std::string& name);
};
/// Name of the function that the module exports: const NetcdfFieldModule* geomesh_netcdf_fields().
constexpr const char* netcdf_fields_function = "geomesh_netcdf_fields";

}  // namespace geomesh::geomodel

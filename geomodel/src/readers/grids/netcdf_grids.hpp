// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The border between the reader of netCDF and HDF5 grids and the module that reads these files by netCDF
/// (geomodel/plugins/netcdf_grids.cpp). Types of C++ cross it, so both sides are of one build.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "readers/grids/grid.hpp"

namespace geomesh::geomodel {

/// A variable over two axes, with the places of its nodes.
struct NetcdfGrid {
  std::string name;             ///< of the variable, with the groups that it is in: "group/variable"
  NodeLattice lattice;          ///< as the file has the numbers, scale_factor and add_offset applied; z NaN: no value
  std::string z_name;           ///< standard_name or long_name, else the variable's own name
  std::string z_unit, xy_unit;  ///< as written; empty where the file names none
  std::string positive;         ///< "up", "down" or empty
  std::string system;           ///< "epsg:CODE", else the system's name, else empty
  bool geographic = false;      ///< x and y are longitude and latitude in degrees
  bool cell_centred = false;    ///< GMT's pixel registration
  bool regular = false;         ///< equal spacing along each axis, up to rounding
};

struct NetcdfGrids {
  std::vector<NetcdfGrid> grids;
  std::vector<std::string> others;  ///< variables that are no grid of heights, each with the reason in brackets
};

struct NetcdfGridModule {
  const char* version;  ///< GEOMESH_MODULE_VERSION
  /// Throws Error{invalid_input} where the file is damaged.
  NetcdfGrids (*read)(const std::filesystem::path& file);
};
/// The function of the module: const NetcdfGridModule* geomesh_netcdf_grids().
constexpr const char* netcdf_grids_function = "geomesh_netcdf_grids";

}  // namespace geomesh::geomodel

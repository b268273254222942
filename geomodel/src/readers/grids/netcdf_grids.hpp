// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The interface between the reader of netCDF and HDF5 grids and the module that reads these files with the netCDF
/// library (geomodel/plugins/netcdf_grids.cpp). C++ types are passed through it, so both sides must come from the same
/// build.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "readers/grids/grid.hpp"

namespace geomesh::geomodel {

/// A grid in a netCDF or HDF5 file: a variable with two dimensions, and the positions of its nodes.
struct NetcdfGrid {
  std::string name;  ///< name of the netCDF variable with its groups: "group/variable"
  /// Numbers of the netCDF file after scale_factor and add_offset are applied; z is NaN if a node has no value.
  NodeLattice lattice;
  std::string z_name;           ///< standard_name or long_name of the netCDF heights, else the variable's own name
  std::string z_unit, xy_unit;  ///< units of the grid's heights and positions as written; empty if the file names none
  std::string positive;         ///< attribute `positive` of the heights: "up", "down" or empty
  std::string system;           ///< coordinate system of the grid: "epsg:CODE", else its name, else empty
  bool geographic = false;      ///< whether x and y are longitude and latitude in degrees
  bool cell_centred = false;    ///< GMT's pixel registration
  bool regular = false;         ///< whether spacing along each axis is constant, up to rounding
};

struct NetcdfGrids {
  std::vector<NetcdfGrid> grids;
  std::vector<std::string> others;  ///< variables that are not grids of heights, each with the reason in parentheses
};

struct NetcdfGridModule {
  const char* version;  ///< GEOMESH_MODULE_VERSION
  /// Reads the grids of a netCDF file. Throws Error{invalid_input} if the file is damaged.
  NetcdfGrids (*read)(const std::filesystem::path& file);
};
/// Name of the function that the module exports: const NetcdfGridModule* geomesh_netcdf_grids().
constexpr const char* netcdf_grids_function = "geomesh_netcdf_grids";

}  // namespace geomesh::geomodel

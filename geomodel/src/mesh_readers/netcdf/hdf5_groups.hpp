// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The groups of an HDF5 file, checked before the netCDF library reads it. That library opens all groups along all
/// links at once: where a group holds a link to itself or to a group above, it does not end, and takes memory until
/// there is none.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace geomesh::geomodel {

struct Hdf5Groups {
  std::string fault;                ///< why the file must not be opened, and what to do; empty where it may
  std::set<std::string> unwritten;  ///< paths of arrays of which the file holds no value, as "group/array"
};

/// Reads each group once, by its address in the file. A file of another kind has neither fault nor arrays.
Hdf5Groups check_hdf5_groups(const std::filesystem::path& file);

}  // namespace geomesh::geomodel

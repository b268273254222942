// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks the groups of an HDF5 file before the netCDF library reads it. That library opens all groups along all links
/// at once: if a group has a link to itself or to a group above, it does not terminate and fills all memory.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace geomesh::geomodel {

struct Hdf5Groups {
  std::string fault;  ///< reason why the file must not be opened, and what the user can do; empty if it may be opened
  std::set<std::string> unwritten;  ///< paths, as "group/array", of HDF5 arrays that have no value in the file
};

/// Checks the groups of an HDF5 file, reading each one once, identified by its address in the file. For a file of
/// another kind, both results are empty.
Hdf5Groups check_hdf5_groups(const std::filesystem::path& file);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Modules that were built beside the test program.
#pragma once

#include <filesystem>
#include <string>

namespace geomesh::geomodel::testing {

/// `name`: gdal, proj ...
inline bool has_module(const std::string& name) {
  std::error_code error;
  return std::filesystem::exists(
      std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / ("geomesh-" + name + ".so"), error);
}

}  // namespace geomesh::geomodel::testing

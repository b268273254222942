// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A folder for files of this test process alone: tests run side by side.
#pragma once

#include <filesystem>
#include <string>

#include "common/operating_system.hpp"

namespace geomesh::geomodel::testing {

/// Made at the first call, removed with all in it when the process ends.
inline const std::filesystem::path& scratch_folder() {
  struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("geomesh_test_" + std::to_string(id_of_this_process()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  };
  static const Folder folder;
  return folder.path;
}

}  // namespace geomesh::geomodel::testing

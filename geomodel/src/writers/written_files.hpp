// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A set of files that are only valid together: if one of them cannot be written, those before it are removed.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

namespace geomesh::geomodel {

class WrittenFiles {
 public:
  WrittenFiles() = default;
  WrittenFiles(const WrittenFiles&) = delete;
  WrittenFiles& operator=(const WrittenFiles&) = delete;
  ~WrittenFiles() {
    std::error_code ignored;
    for (const std::filesystem::path& file : files_) std::filesystem::remove(file, ignored);
  }
  void add(std::filesystem::path file) { files_.push_back(std::move(file)); }
  void add(const std::vector<std::filesystem::path>& files) { files_.insert(files_.end(), files.begin(), files.end()); }
  /// Keeps all files and returns their paths, once all of them are written; without this call the files are removed.
  std::vector<std::filesystem::path> keep() { return std::exchange(files_, {}); }

 private:
  std::vector<std::filesystem::path> files_;
};

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Dimensions and variables of a netCDF file by their names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace geomesh::geomodel {

/// Everything throws Error{invalid_input} where the file is damaged. Memory is bounded by what the file can hold.
class NetcdfReader {
 public:
  /// Classic, with 64-bit offsets or numbers, or netCDF-4. Throws Error{usage} where the file cannot be opened.
  explicit NetcdfReader(const std::filesystem::path& path);
  ~NetcdfReader();
  NetcdfReader(const NetcdfReader&) = delete;
  NetcdfReader& operator=(const NetcdfReader&) = delete;

  [[noreturn]] void refuse(const std::string& why) const;
  bool has(const std::string& variable) const;
  /// 0 where there is none.
  std::size_t dimension(const std::string& name) const;
  bool is_single_precision(const std::string& variable) const;
  /// Exactly n numbers; of a variable over times those of the first one.
  std::vector<double> doubles(const std::string& variable, std::size_t n) const;
  std::vector<std::int64_t> integers(const std::string& variable, std::size_t n) const;
  /// One text a row; as many empty ones where there is no such variable.
  std::vector<std::string> texts(const std::string& variable, std::size_t n) const;
  /// Empty where there is none.
  std::string attribute(const std::string& variable, const std::string& name) const;

 private:
  struct Range {
    int id;
    std::vector<std::size_t> start, count;
  };
  Range range(const std::string& variable, std::size_t n) const;

  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads dimensions and variables of a netCDF file by their names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace geomesh::geomodel {

/// Reader of a netCDF file. All functions throw Error{invalid_input} if the file is damaged. Memory is bounded by what
/// the file can contain.
class NetcdfReader {
 public:
  /// Opens a netCDF file: classic, with 64-bit offsets or data, or netCDF-4. Throws Error{usage} if it cannot be
  /// opened.
  explicit NetcdfReader(const std::filesystem::path& path);
  ~NetcdfReader();
  NetcdfReader(const NetcdfReader&) = delete;
  NetcdfReader& operator=(const NetcdfReader&) = delete;

  [[noreturn]] void refuse(const std::string& why) const;
  bool has(const std::string& variable) const;
  /// Returns the length of a netCDF dimension; 0 if the file has no such dimension.
  std::size_t dimension(const std::string& name) const;
  bool is_single_precision(const std::string& variable) const;
  /// Returns the n numbers of a netCDF variable; of a variable with time steps, those of the first step.
  std::vector<double> doubles(const std::string& variable, std::size_t n) const;
  std::vector<std::int64_t> integers(const std::string& variable, std::size_t n) const;
  /// Returns the n texts of a netCDF variable, one for each row; n empty texts if there is no such variable.
  std::vector<std::string> texts(const std::string& variable, std::size_t n) const;
  /// Returns an attribute of a netCDF variable; an empty text if the variable does not have it.
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

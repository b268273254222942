// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes a netCDF file that is defined completely before its numbers are written, because the netCDF library would
/// move existing data for each later definition.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace geomesh::geomodel {

/// Writer of netCDF files in the classic format with 64-bit offsets, which every netCDF reader supports. A variable may
/// have 4 GiB, and the file any size. Numbers are 32-bit integers or doubles.
class NetcdfWriter {
 public:
  /// Writes entries [first, first + n) of a netCDF variable, counted along its first dimension; false on failure.
  using Put = std::function<bool(std::size_t first, std::size_t n, const void* data)>;

  /// Adds a netCDF dimension of the given length; 0 means the unlimited dimension.
  void add_dimension(const std::string& name, std::size_t size) { dimensions_.emplace_back(name, size); }
  void add_ints(const std::string& name, const std::string& dimension, std::vector<int> values);
  /// Adds a netCDF variable of integers, which `write` provides piece by piece.
  void add_ints(const std::string& name, std::vector<std::string> dimensions, std::function<bool(const Put&)> write);
  void add_doubles(const std::string& name, std::vector<std::string> dimensions,
                   std::function<std::vector<double>()> values);
  /// Adds a netCDF variable of texts, stored in rows of a fixed length that are padded with zeros.
  void add_texts(const std::string& name, const std::string& dimension, std::vector<std::string> texts);
  /// Adds an attribute to the netCDF variable that was added last.
  void add_attribute(const std::string& name, const std::string& value);
  void add_global(const std::string& name, const std::string& value) { texts_.emplace_back(name, value); }
  void add_global(const std::string& name, int value) { ints_.emplace_back(name, value); }
  void add_global(const std::string& name, float value) { floats_.emplace_back(name, value); }

  /// Writes the netCDF file. Returns false if it cannot be written, or if a variable is too large for the format.
  bool write(const std::filesystem::path& file) const;

 private:
  enum class Type { text, integer, real };
  struct Variable {
    std::string name;
    Type type;
    std::vector<std::string> dimensions;
    std::vector<std::pair<std::string, std::string>> attributes;
    std::function<bool(const Put&)> write;
  };
  bool define(int file, std::vector<int>& ids) const;
  bool put_all(int file, const std::vector<int>& ids) const;
  std::size_t size_of(const std::string& dimension) const;

  std::vector<std::pair<std::string, std::size_t>> dimensions_;
  std::vector<Variable> variables_;
  std::vector<std::pair<std::string, std::string>> texts_;
  std::vector<std::pair<std::string, int>> ints_;
  std::vector<std::pair<std::string, float>> floats_;
};

/// Number of bytes reserved for each name in an Exodus file, including the zero byte at its end.
inline constexpr std::size_t exodus_name_room = 256;

}  // namespace geomesh::geomodel

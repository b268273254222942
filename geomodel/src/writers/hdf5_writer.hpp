// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// HDF5 files being written (built only where HDF5 is there): the same bytes whenever they are written.
#pragma once

#include <hdf5.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace geomesh::geomodel {

/// An HDF5 file being written. Every failure of the library is a failure to write the file.
class Hdf5Writer {
 public:
  /// `payload`: bytes of all numbers. `n_sets`: data sets and groups, each of which takes some room of its own.
  Hdf5Writer(const std::filesystem::path& temporary, const std::filesystem::path& file, std::size_t payload,
             std::size_t n_sets = 0);
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  /// Writes rows that are in memory: type in memory, first row, number of rows.
  using WriteRows = std::function<void(hid_t in_memory, const void* data, std::size_t n_rows)>;
  /// Rows of `width` numbers. `name` may be a path whose groups are there.
  void put(const std::string& name, hid_t type, const void* data, std::size_t n, std::size_t width);
  /// The same piece by piece: `give` calls the function that it is handed for one piece after the other.
  void put_pieces(const std::string& name, hid_t type, std::size_t n, std::size_t width,
                  const std::function<void(const WriteRows&)>& give);
  void group(const std::string& name);
  /// Attributes of a group: a text of fixed length, and whole numbers.
  void attribute(const std::string& group, const char* name, const std::string& text);
  void attribute(const std::string& group, const char* name, const std::vector<std::int64_t>& numbers);
  void close();

 private:
  template <class T>
  T require(T status) const;
  const std::filesystem::path& file_;
  hid_t id_ = -1;
};

}  // namespace geomesh::geomodel

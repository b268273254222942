// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes HDF5 files (built only if HDF5 is available) whose bytes do not depend on when they are written.
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

/// An HDF5 file that is being written. Every failure of the library is reported as a failure to write the file.
class Hdf5Writer {
 public:
  /// Opens an HDF5 file for writing. `payload` is the number of bytes of all numbers, `n_sets` the number of data sets
  /// and groups, each of which needs some further space.
  Hdf5Writer(const std::filesystem::path& temporary, const std::filesystem::path& file, std::size_t payload,
             std::size_t n_sets = 0);
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  /// Function that writes `n_rows` rows of numbers of the type `in_memory` to an HDF5 data set.
  using WriteRows = std::function<void(hid_t in_memory, const void* data, std::size_t n_rows)>;
  /// Writes an HDF5 data set with rows of `width` numbers. `name` may be a path whose groups exist.
  void put(const std::string& name, hid_t type, const void* data, std::size_t n, std::size_t width);
  /// Writes an HDF5 data set piece by piece: `give` gets a function that writes rows, and calls it for each piece.
  void put_pieces(const std::string& name, hid_t type, std::size_t n, std::size_t width,
                  const std::function<void(const WriteRows&)>& give);
  void group(const std::string& name);
  /// Writes attributes of an HDF5 group: a text of fixed length, and integers.
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

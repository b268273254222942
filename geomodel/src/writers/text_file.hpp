// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Large text and binary files of solvers, written a megabyte at a time. A file is either complete or absent.
#pragma once

#include <charconv>
#include <concepts>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

class OutputText {
 public:
  explicit OutputText(const std::filesystem::path& path) : file_(path, std::ios::binary) {}

  OutputText& operator<<(std::string_view text) {
    buffer_.append(text);
    if (buffer_.size() > size_t{1} << 20) flush();
    return *this;
  }
  template <std::integral T>
  OutputText& operator<<(T value) {
    return number(value);
  }
  OutputText& operator<<(double value) { return number(value); }
  OutputText& operator<<(const Vec3& p) { return *this << p.x << " " << p.y << " " << p.z; }
  template <class T>
  OutputText& raw(const T& value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    return *this << std::string_view(bytes, sizeof(T));
  }
  /// Closes the file; returns false if something could not be written.
  bool close() {
    flush();
    file_.close();
    return !file_.fail();
  }

 private:
  using size_t = std::size_t;
  void flush() {
    file_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }
  /// Appends a number; a double as the shortest text that reads back to the same double, independent of the locale.
  template <class T>
  OutputText& number(T value) {
    char digits[32];
    return *this << std::string_view(
               digits, static_cast<std::size_t>(std::to_chars(digits, digits + sizeof digits, value).ptr - digits));
  }
  std::ofstream file_;
  std::string buffer_;
};

/// Writes a file whose contents a function composes. The file is either complete or absent. Throws Error{usage} if it
/// cannot be written.
void write_output_text(const std::filesystem::path& file, const std::function<void(OutputText&)>& compose);

}  // namespace geomesh::geomodel

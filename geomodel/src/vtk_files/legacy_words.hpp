// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads words, lines and blocks of numbers from a legacy VTK file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "vtk_files/vtk_data.hpp"

namespace geomesh::geomodel {

/// Reads the file from front to back. All functions throw Error{invalid_input} if the file does not contain what is
/// expected.
class LegacyWords {
 public:
  explicit LegacyWords(const InputFile& file) : file_(file), rest_(file.text()) {}

  bool binary = false;

  [[noreturn]] void fail(const std::string& message) const;
  /// Returns the next line without its end; empty at the end of the file.
  std::string_view line();
  /// Returns the next word in lower case; empty at the end of the file.
  std::string keyword();
  /// Returns the same as keyword() without advancing.
  std::string next_keyword() const;
  /// Returns the next name, with characters %XX decoded.
  std::string name();
  /// Returns a count that is not negative, for items that take at least one bit each.
  std::size_t count(const char* what);
  /// Returns a type of numbers; texts and bits are types too.
  VtkType type();
  /// Returns the remaining words of this line.
  std::vector<std::string_view> words_of_line();

  /// Returns `n` values of the type, from the next line on if the file is binary.
  VtkColumn values(std::string name, VtkType type, std::size_t n_tuples, std::size_t n_components);

 private:
  void end_line();
  void read_binary(VtkColumn& column, std::size_t n);
  void read_texts(VtkColumn& column, std::size_t n);
  std::string_view bytes(std::size_t n);
  std::size_t length_of_text();

  const InputFile& file_;
  std::string_view rest_;
};

}  // namespace geomesh::geomodel

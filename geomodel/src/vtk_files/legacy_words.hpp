// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads words, lines and blocks of numbers from a legacy VTK file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "vtk_files/vtk_data.hpp"

namespace geomesh::geomodel {

/// Reads a legacy VTK file from front to back. All functions throw Error{invalid_input} if the file does not contain
/// what is expected.
class LegacyWords {
 public:
  explicit LegacyWords(const InputFile& file) : file_(file), rest_(file.text()) {}

  bool binary = false;

  [[noreturn]] void fail(const std::string& message) const;
  std::string_view line();
  std::string keyword();
  std::string next_keyword() const;
  /// Returns the next name, in which characters encoded as %XX are decoded.
  std::string name();
  /// Returns the next word as a count of items, which take at least one bit each; throws if the VTK file is too short.
  std::size_t count(const char* what);
  /// Reads the name of a value type, such as "float"; the types of text ("string") and bits are value types, too.
  VtkType type();
  std::vector<std::string_view> words_of_line();

  /// Reads an array of `n_tuples` tuples of this type. In a binary file its values begin on the next line.
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

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Words, lines and blocks of numbers of a legacy VTK file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "vtk_files/vtk_data.hpp"

namespace geomesh::geomodel {

/// Goes through the file from front to back. Everything throws Error{invalid_input} where the file does not hold it.
class LegacyWords {
 public:
  explicit LegacyWords(const InputFile& file) : file_(file), rest_(file.text()) {}

  bool binary = false;

  [[noreturn]] void fail(const std::string& message) const;
  /// Without its end; empty at the end of the file.
  std::string_view line();
  /// In small letters; empty at the end of the file.
  std::string keyword();
  /// As keyword(), and the place does not move.
  std::string next_keyword() const;
  /// With its characters %XX put back.
  std::string name();
  /// A count that is no negative number, of things of which each takes a bit at least.
  std::size_t count(const char* what);
  /// A type of numbers; texts and bits too.
  VtkType type();
  /// The other words of this line.
  std::vector<std::string_view> words_of_line();

  /// `n` values of the type, from the next line on where the file is binary.
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

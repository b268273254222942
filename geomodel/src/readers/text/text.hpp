// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Lines, tokens and numbers of text formats, without copies and independent of the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geomesh/core/geometry.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

/// Iterates over the lines of a file; line ends may be LF, CRLF or (throughout) CR.
class LineReader {
 public:
  explicit LineReader(const InputFile& file);
  bool next();
  /// Steps back by one line, so that the current line is read again.
  void step_back();
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }  ///< from 1
  const InputFile& file() const { return *file_; }
  [[noreturn]] void fail(const std::string& message) const { file_->fail(number_, message); }

 private:
  const InputFile* file_;
  std::string_view line_;
  std::size_t start_ = 0, next_ = 0, number_ = 0;
  char line_end_;
};

/// Iterates over the words of one line, which blanks separate.
class Tokens {
 public:
  explicit Tokens(std::string_view line) : rest_(line) {}
  std::string_view next();
  /// Returns the next token; if it is in double quotes, the trimmed text between them.
  std::string_view next_quoted();
  std::string_view rest() const;
  bool at_end() const { return rest().empty(); }

 private:
  std::string_view rest_;
};

/// Iterates over tokens across line ends, for formats in which line breaks have no meaning. `#` begins a comment if
/// `comment` is set.
class TokenStream {
 public:
  explicit TokenStream(const InputFile& file, char comment = '\0') : file_(&file), comment_(comment) {}
  std::string_view next();
  std::size_t line() const { return line_; }  ///< number of the line of the token read last
  std::size_t position() const { return at_; }
  std::size_t bytes_left() const { return file_->size() - at_; }
  [[noreturn]] void fail(const std::string& message) const { file_->fail(line_, message); }
  const InputFile& file() const { return *file_; }

  /// Returns the next token as a finite number; throws an error that `what` was expected if it is none.
  double number(const char* what);
  std::int64_t integer(const char* what);
  /// Reads the number of points, triangles or other items that follow in the text. Throws if the rest of the file is
  /// shorter than `least_bytes` for each of them.
  std::size_t count(const char* what, std::size_t least_bytes);

 private:
  const InputFile* file_;
  std::size_t at_ = 0, line_ = 1;
  char comment_;
};

std::string_view trim(std::string_view s);
std::string to_lower(std::string_view s);
/// Returns the decimal digits at the end of a name; empty if it does not end in digits.
std::string_view digits_at_end(std::string_view name);
bool equals_ignoring_case(std::string_view a, std::string_view b);
bool starts_with_ignoring_case(std::string_view s, std::string_view prefix);

/// Converts a whole token to a number: '.' is the decimal point whatever the locale, a leading '+' and a Fortran
/// exponent (1.5D3) are allowed; NaN and infinities count as numbers. Returns nothing if the token is not a number.
std::optional<double> to_double(std::string_view token);
std::optional<std::int64_t> to_integer(std::string_view token);

/// Converts a token to a finite coordinate; throws an error with the line and `what` if it is none.
double finite_number(const LineReader& at, std::string_view token, const char* what);
Vec3 read_point(const LineReader& at, Tokens& tokens, std::string_view id);

}  // namespace geomesh::geomodel

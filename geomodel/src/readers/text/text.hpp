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
  /// Advances to the next line; returns false at the end of the file.
  bool next();
  /// Makes the current line the next one again.
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

/// Blank-separated tokens of one line.
class Tokens {
 public:
  explicit Tokens(std::string_view line) : rest_(line) {}
  /// Returns the next token, empty at the end.
  std::string_view next();
  /// Returns the next token, or the text between double quotes, trimmed.
  std::string_view next_quoted();
  /// Returns the rest of the line, trimmed.
  std::string_view rest() const;
  bool at_end() const { return rest().empty(); }

 private:
  std::string_view rest_;
};

/// Tokens across line ends, for formats in which line breaks have no meaning. `#` begins a comment if `comment` says
/// so.
class TokenStream {
 public:
  explicit TokenStream(const InputFile& file, char comment = '\0') : file_(&file), comment_(comment) {}
  /// Returns the next token, empty at the end of the file.
  std::string_view next();
  std::size_t line() const { return line_; }  ///< line of the last token
  std::size_t position() const { return at_; }
  std::size_t bytes_left() const { return file_->size() - at_; }
  [[noreturn]] void fail(const std::string& message) const { file_->fail(line_, message); }
  const InputFile& file() const { return *file_; }

  /// Returns a finite number; throws an error that `what` was expected here.
  double number(const char* what);
  /// Returns an integer; throws for anything else.
  std::int64_t integer(const char* what);
  /// Returns a count for which the rest of the file is large enough with `least_bytes` per item; otherwise throws.
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
/// Returns `a == b` without regard to case (ASCII).
bool equals_ignoring_case(std::string_view a, std::string_view b);
bool starts_with_ignoring_case(std::string_view s, std::string_view prefix);

/// Returns the whole token as a number: '.' is the decimal point whatever the locale, a leading '+' and a Fortran
/// exponent (1.5D3) are allowed; NaN and infinities are numbers here. Returns nothing if the token is not a number.
std::optional<double> to_double(std::string_view token);
std::optional<std::int64_t> to_integer(std::string_view token);

/// Returns the token as a finite coordinate; otherwise throws an error with the line and `what`.
double finite_number(const LineReader& at, std::string_view token, const char* what);
/// Reads three finite coordinates of point `id` from the next tokens.
Vec3 read_point(const LineReader& at, Tokens& tokens, std::string_view id);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Lines, tokens and numbers of text formats, without copies and without a locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geomesh/core/geometry.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

/// Walks the lines of a file; line ends may be LF, CRLF or (throughout) CR.
class LineReader {
 public:
  explicit LineReader(const InputFile& file);
  /// Goes to the next line; false at the end of the file.
  bool next();
  /// The next line will be this one again.
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
  /// The next token, empty at the end.
  std::string_view next();
  /// The next token, or what stands between double quotes, trimmed.
  std::string_view next_quoted();
  /// What is left of the line, trimmed.
  std::string_view rest() const;
  bool at_end() const { return rest().empty(); }

 private:
  std::string_view rest_;
};

/// Tokens across line ends, for formats in which line breaks carry no meaning. `#` begins a comment where `comment`
/// says so.
class TokenStream {
 public:
  explicit TokenStream(const InputFile& file, char comment = '\0') : file_(&file), comment_(comment) {}
  /// The next token, empty at the end of the file.
  std::string_view next();
  std::size_t line() const { return line_; }  ///< of the last token
  std::size_t position() const { return at_; }
  std::size_t bytes_left() const { return file_->size() - at_; }
  [[noreturn]] void fail(const std::string& message) const { file_->fail(line_, message); }
  const InputFile& file() const { return *file_; }

  /// A finite number or an error that says `what` was expected here.
  double number(const char* what);
  /// A whole number or an error.
  std::int64_t integer(const char* what);
  /// A count that the rest of the file can hold at `least_bytes` a piece, or an error.
  std::size_t count(const char* what, std::size_t least_bytes);

 private:
  const InputFile* file_;
  std::size_t at_ = 0, line_ = 1;
  char comment_;
};

std::string_view trim(std::string_view s);
std::string to_lower(std::string_view s);
/// The decimal digits at the end of a name; empty where it ends otherwise.
std::string_view digits_at_end(std::string_view name);
/// As `a == b` without regard to case (ASCII).
bool equals_ignoring_case(std::string_view a, std::string_view b);
bool starts_with_ignoring_case(std::string_view s, std::string_view prefix);

/// The whole token as a number: '.' as decimal point whatever the locale, a leading '+' and a Fortran exponent (1.5D3)
/// allowed; NaN and infinities are numbers here. Empty where the token is none.
std::optional<double> to_double(std::string_view token);
std::optional<std::int64_t> to_integer(std::string_view token);

/// The token as a finite coordinate; otherwise an error naming the line and `what`.
double finite_number(const LineReader& at, std::string_view token, const char* what);
/// Three finite coordinates from the tokens to come, of point `id`.
Vec3 read_point(const LineReader& at, Tokens& tokens, std::string_view id);

}  // namespace geomesh::geomodel

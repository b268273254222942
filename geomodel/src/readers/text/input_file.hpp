// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One complete input file in memory, and the form of error messages about it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/read_options.hpp"

namespace geomesh::geomodel {

/// An input file, read into memory at once. Readers limit allocations by `bytes.size()`, never by a count in the file.
struct InputFile {
  std::filesystem::path path;
  std::string bytes;
  ReadOptions options{};  ///< settings in the project file for reading this file

  std::string_view text() const { return bytes; }
  std::size_t size() const { return bytes.size(); }
  /// Returns the extension of the file in lower case with its dot; empty if there is none.
  std::string extension() const;
  /// Returns the path of the file as the user gave it.
  std::string shown() const { return path.string(); }

  /// Throws Error{invalid_input} with the message "FILE: message" or "FILE:line: message".
  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail(std::size_t line, const std::string& message) const;
};

/// Reads a whole file into memory. Throws Error{usage} if the file is missing, is a folder or cannot be read.
InputFile load_input_file(const std::filesystem::path& path);

/// Formats a token for a message: quoted, cut to 40 characters, control characters replaced.
std::string in_quotes(std::string_view token);

/// Converts a text to UTF-8. Valid UTF-8 is returned unchanged; otherwise the bytes are taken as Latin-1, the encoding
/// of names in much older software (Windows-1252 without its own characters).
std::string as_utf8(std::string_view text);

/// Returns true if the first kilobyte contains bytes that no text file has.
bool looks_binary(const InputFile& file);

}  // namespace geomesh::geomodel

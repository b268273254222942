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

/// A file that is read at once: every reader parses from memory and limits allocations by `bytes.size()`, never by a
/// count in the file.
struct InputFile {
  std::filesystem::path path;
  std::string bytes;
  ReadOptions options{};  ///< options of the project for the file

  std::string_view text() const { return bytes; }
  std::size_t size() const { return bytes.size(); }
  /// Returns the extension in lower case with its dot; empty if there is none.
  std::string extension() const;
  /// Returns the path as the user gave it.
  std::string shown() const { return path.string(); }

  /// Throws Error{invalid_input} "FILE: message" or "FILE:line: message".
  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail(std::size_t line, const std::string& message) const;
};

/// Throws Error{usage} if the file is missing, is a folder or cannot be read.
InputFile load_input_file(const std::filesystem::path& path);

/// Formats a token for a message: quoted, cut to 40 characters, control characters replaced.
std::string in_quotes(std::string_view token);

/// Returns the text itself if it is valid UTF-8; otherwise interprets its bytes as Latin-1 (Windows-1252 without its
/// own characters), the encoding of names in much older software.
std::string as_utf8(std::string_view text);

/// Returns true if the first kilobyte contains bytes that no text file has.
bool looks_binary(const InputFile& file);

}  // namespace geomesh::geomodel

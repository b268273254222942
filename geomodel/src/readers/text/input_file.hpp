// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One whole input file in memory, and the way in which readers complain about it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/read_options.hpp"

namespace geomesh::geomodel {

/// A file read at once: every reader parses from memory and bounds what it allocates by `bytes.size()`, never by a
/// count that the file claims.
struct InputFile {
  std::filesystem::path path;
  std::string bytes;
  ReadOptions options{};  ///< what the project says about the file

  std::string_view text() const { return bytes; }
  std::size_t size() const { return bytes.size(); }
  /// Extension in lower case with its dot; empty where there is none.
  std::string extension() const;
  /// The path as the user gave it.
  std::string shown() const { return path.string(); }

  /// Throws Error{invalid_input} "FILE: message" or "FILE:line: message".
  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail(std::size_t line, const std::string& message) const;
};

/// Throws Error{usage} where the file is missing, a folder or cannot be read.
InputFile load_input_file(const std::filesystem::path& path);

/// Text of a token for a message: quoted, cut to 40 characters, control characters replaced.
std::string in_quotes(std::string_view token);

/// The text itself where it is valid UTF-8; otherwise its bytes as Latin-1 (Windows-1252 without its own signs), in
/// which much older software writes names.
std::string as_utf8(std::string_view text);

/// True where the first kilobyte holds bytes that no text file has.
bool looks_binary(const InputFile& file);

}  // namespace geomesh::geomodel

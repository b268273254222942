// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Formats names of files for a browser and for a shell.
#pragma once

#include <filesystem>
#include <string>

namespace geomesh::app {

/// Returns an address such as "file:///home/me/out/dome.html": absolute, with characters that an address must not
/// contain written as %XX (RFC 3986).
std::string file_address(const std::filesystem::path& file);

/// Returns a file's name as typed in a shell: quoted if it has other characters than letters, digits and ._-/+=:,@%.
std::string shell_word(const std::filesystem::path& file);

}  // namespace geomesh::app

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Names of files as a browser and a shell take them.
#pragma once

#include <filesystem>
#include <string>

namespace geomesh::app {

/// "file:///home/me/out/dome.html": absolute, with what an address may not hold written as %XX (RFC 3986).
std::string file_address(const std::filesystem::path& file);

/// The name as it is typed in a shell: in single quotes where it holds more than letters, digits and ._-/+=:,@%.
std::string shell_word(const std::filesystem::path& file);

}  // namespace geomesh::app

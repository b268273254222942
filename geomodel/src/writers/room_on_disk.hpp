// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Room for a file, asked for before a library writes it that does not survive a full disk.
#pragma once

#include <cstddef>
#include <filesystem>

namespace geomesh::geomodel {

/// Makes `temporary` a file of that many bytes, which the library then writes over. Throws Error{usage} about `file`
/// where the disk has no room, or the folder cannot be written to. HDF5 1.10 dies at the end of the program where it
/// could not write a file.
void require_room(const std::filesystem::path& temporary, const std::filesystem::path& file, std::size_t bytes);

}  // namespace geomesh::geomodel

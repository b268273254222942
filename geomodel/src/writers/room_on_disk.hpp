// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reserves disk space for a file before a library that does not survive a full disk writes it.
#pragma once

#include <cstddef>
#include <filesystem>

namespace geomesh::geomodel {

/// Fills the file `temporary` with the given number of bytes, which the HDF5 library then overwrites. Throws
/// Error{usage} about `file` if the disk is full, or if the folder is not writable. Without this, HDF5 1.10 crashes at
/// the end of the program if it could not write a file.
void require_room(const std::filesystem::path& temporary, const std::filesystem::path& file, std::size_t bytes);

}  // namespace geomesh::geomodel

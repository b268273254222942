// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Times in an HDF5 file that a library wrote, set to zero: the same bytes whenever it is written.
#pragma once

#include <filesystem>

namespace geomesh::geomodel {

/// Sets the times of every group and data set in the closed file to zero. For libraries that make these themselves and
/// so leave no way to ask for none (libmedc). Object headers of version 2 have times; others stay as they are. False
/// where the file cannot be read or written, or where a header is not as documented. O(objects).
/// Followed: HDF5 File Format Specification 3.0, IV.A.1.b.
bool clear_hdf5_times(const std::filesystem::path& file);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sets the times in an HDF5 file to zero, so that the bytes of a file that a library wrote do not depend on when it
/// was written.
#pragma once

#include <filesystem>

namespace geomesh::geomodel {

/// Sets the times of every group and data set in the closed file to zero. This is needed for libraries that create
/// groups and data sets themselves and have no option to omit times (libmedc). Only object headers of version 2 have
/// times. Returns false if the file cannot be read or written, or if a header is not as documented. O(objects). Source:
/// HDF5 File Format Specification 3.0, IV.A.1.b.
bool clear_hdf5_times(const std::filesystem::path& file);

}  // namespace geomesh::geomodel

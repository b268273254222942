// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The header of a classic netCDF file (formats CDF-1, CDF-2 and CDF-5), checked before the library reads it. The
/// library believes the counts in a header: of a damaged file of 3 kB it reserves gigabytes, or reads for minutes
/// behind its end.
#pragma once

#include <filesystem>

namespace geomesh::geomodel {

/// False where a list, name, attribute or variable without records would not fit into the file, a variable names a
/// dimension that is not there, or the header ends early. True for files of other kinds, of which HDF5 is one. Linear
/// in the header. Followed: "The NetCDF Classic Format Specification" (Unidata).
bool netcdf_header_is_sound(const std::filesystem::path& file);

}  // namespace geomesh::geomodel

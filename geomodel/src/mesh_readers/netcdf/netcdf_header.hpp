// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The header of a classic netCDF file (formats CDF-1, CDF-2 and CDF-5), checked before the library reads it. The
/// library believes the counts in a header: of a damaged file of 3 kB it reserves gigabytes, or reads for minutes
/// behind its end.
#pragma once

#include <filesystem>
#include <string>

namespace geomesh::geomodel {

/// Why the file must not be read; empty where it may, and for files of other kinds, of which HDF5 is one. It must not
/// where a list, name, attribute or variable would not fit into the file, records that the header counts are missing at
/// its end (the library reads zeros there), a variable names a dimension that is not there, or the header ends early.
/// Linear in the header. Followed: "The NetCDF Classic Format Specification" (Unidata).
std::string netcdf_header_fault(const std::filesystem::path& file);

}  // namespace geomesh::geomodel

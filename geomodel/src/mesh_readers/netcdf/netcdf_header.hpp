// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The header of a classic netCDF file (formats CDF-1, CDF-2 and CDF-5), checked before the netCDF library reads it.
/// The library trusts the counts in a header: for a damaged file of 3 kB it reserves gigabytes, or reads for minutes
/// beyond its end.
#pragma once

#include <filesystem>
#include <string>

namespace geomesh::geomodel {

/// Returns the reason why a classic netCDF file must not be read; empty if it may, and for files of other kinds such as
/// HDF5. Reasons are: a list, name, attribute or variable that does not fit into the file; records that the header
/// counts but that are missing at the end (the library reads zeros there); a variable with a dimension that does not
/// exist; a header that ends early. Linear in the header. Source: "The NetCDF Classic Format Specification" (Unidata).
std::string netcdf_header_fault(const std::filesystem::path& file);

}  // namespace geomesh::geomodel

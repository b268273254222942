// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Shared by the readers of VTK meshes: opens files by their extension, and finds arrays by their names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "vtk_files/vtk_data.hpp"

namespace geomesh::geomodel::checking {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why);

/// Whether a VTK file may have no points. A mesh must have some, but a file of curves or faces may be empty.
enum class May { not_be_empty, be_empty };

/// Reads a VTK file. Throws Error{usage} if it cannot be opened, and Error{invalid_input} if it is damaged, of another
/// kind, or empty (unless `may` is be_empty).
VtkData read_vtk_file(const std::filesystem::path& path, VtkData::Kind kind, May may = May::not_be_empty);

/// Returns the first number of each tuple of an array. Values that are not 32-bit integers (an array of floats may hold
/// anything) become the least integer, which is never an id.
std::vector<std::int32_t> integers_of(const VtkColumn& column);
/// Returns the first number of each tuple of the VTK array with this name; an empty list if there is no such array.
std::vector<std::int32_t> integers_of(const VtkTable& table, const char* name);
/// Returns names by id: the field array `region:chalk` holds the id of the region chalk. Files of geomesh 0.1 have the
/// pair of arrays <what>_ids and <what>_names instead.
std::map<std::int32_t, std::string> names_of(const VtkTable& field, const std::string& what);
/// Returns the ids in the VTK field arrays whose names begin with `prefix`, in the order of the file.
std::vector<std::int32_t> ids_in_order(const VtkTable& field, const std::string& prefix);
std::vector<std::string> texts_of(const VtkTable& field, const char* name);
/// Returns the lists that a VTK field array contains one after the other; a second array has their offsets.
std::vector<std::vector<std::int32_t>> lists_of(const VtkTable& field, const char* offsets_name, const char* ids_name,
                                                const std::filesystem::path& path);

}  // namespace geomesh::geomodel::checking

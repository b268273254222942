// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Shared by the readers of VTK's meshes: files by their extension, and arrays by their names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "vtk_files/vtk_data.hpp"

namespace geomesh::geomodel::checking {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why);

/// A mesh must have points; a model may have no curve, and another tool's mesh no face.
enum class May { not_be_empty, be_empty };

/// Throws Error{usage} if the file cannot be opened, Error{invalid_input} if it is of another kind, damaged, or empty
/// although it must not be.
VtkData read_vtk_file(const std::filesystem::path& path, VtkData::Kind kind, May may = May::not_be_empty);

/// Returns the first number of each tuple. Values that are not 32-bit integers (an array of floats may hold anything)
/// become the least one, which is never an id.
std::vector<std::int32_t> integers_of(const VtkColumn& column);
/// Returns an empty list if there is no such array.
std::vector<std::int32_t> integers_of(const VtkTable& table, const char* name);
/// Returns names by id: the field array `region:chalk` holds the id of the region chalk. Files of geomesh 0.1 have the
/// pair of arrays <what>_ids and <what>_names instead.
std::map<std::int32_t, std::string> names_of(const VtkTable& field, const std::string& what);
/// Returns the ids in arrays whose names have this beginning, in the order of the file.
std::vector<std::int32_t> ids_in_order(const VtkTable& field, const std::string& prefix);
std::vector<std::string> texts_of(const VtkTable& field, const char* name);
/// Returns the concatenated lists, divided at the offsets.
std::vector<std::vector<std::int32_t>> lists_of(const VtkTable& field, const char* offsets_name, const char* ids_name,
                                                const std::filesystem::path& path);

}  // namespace geomesh::geomodel::checking

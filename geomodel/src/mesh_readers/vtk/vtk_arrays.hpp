// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the readers of VTK's meshes have in common: files by their extension, and arrays by their names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "vtk_files/vtk_data.hpp"

namespace geomesh::geomodel::checking {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why);

/// A mesh holds points; a model may have no curve, and another tool's mesh no face.
enum class May { not_be_empty, be_empty };

/// Throws Error{usage} where the file cannot be opened, Error{invalid_input} where it is of another kind, damaged, or
/// empty and may not be.
VtkData read_vtk_file(const std::filesystem::path& path, VtkData::Kind kind, May may = May::not_be_empty);

/// The first number of each tuple. What is no 32-bit number (an array of floats may hold anything) becomes the least
/// one, which no id is.
std::vector<std::int32_t> integers_of(const VtkColumn& column);
/// Empty where there is no such array.
std::vector<std::int32_t> integers_of(const VtkTable& table, const char* name);
/// Names by id: the field array `region:chalk` holds the id of the region chalk. Files of geomesh 0.1 have the pair of
/// arrays <what>_ids and <what>_names instead.
std::map<std::int32_t, std::string> names_of(const VtkTable& field, const std::string& what);
/// The ids in arrays whose names begin so, in the order of the file.
std::vector<std::int32_t> ids_in_order(const VtkTable& field, const std::string& prefix);
std::vector<std::string> texts_of(const VtkTable& field, const char* name);
/// Lists one after the other, cut at the offsets.
std::vector<std::vector<std::int32_t>> lists_of(const VtkTable& field, const char* offsets_name, const char* ids_name,
                                                const std::filesystem::path& path);

}  // namespace geomesh::geomodel::checking

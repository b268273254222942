// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Files of one part where no process has the whole mesh.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geomesh/geomodel/write_options.hpp"
#include "partition/mesh_parts.hpp"

namespace geomesh::geomodel {

/// The part's own files, as write_format names and fills them; of the first part also those that all parts have in
/// common. Formats are vtu, exodus, msh and msh-binary; throws Error{usage} for others, and where the numbers are more
/// than the format can count.
std::vector<std::filesystem::path> write_given_part(const ModelMesh& mesh, const MeshParts& parts, std::int32_t number,
                                                    const std::string& format, const std::filesystem::path& stem,
                                                    const WriteOptions& options);

/// @name By format
/// @{
std::vector<std::filesystem::path> write_vtu_part(const ModelMesh& mesh, const MeshParts& parts, std::int32_t number,
                                                  const WriteOptions& options, const std::filesystem::path& stem);
std::vector<std::filesystem::path> write_exodus_part(const ModelMesh& mesh, const MeshParts& parts,
                                                     const WriteOptions& options, const std::filesystem::path& stem);
/// @}

}  // namespace geomesh::geomodel

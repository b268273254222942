// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes files of one part if no process has the whole mesh.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geomesh/geomodel/write_options.hpp"
#include "partition/mesh_parts.hpp"

namespace geomesh::geomodel {

/// Writes the part's own files with the names and contents of write_format, and with the first part also the files that
/// all parts share. Formats are vtu, exodus, msh and msh-binary; throws Error{usage} for others, and if numbers exceed
/// what the format can store.
std::vector<std::filesystem::path> write_given_part(const ModelMesh& mesh, const MeshParts& parts, std::int32_t number,
                                                    const std::string& format, const std::filesystem::path& stem,
                                                    const WriteOptions& options);

/// @name Writers by format
/// @{
std::vector<std::filesystem::path> write_vtu_part(const ModelMesh& mesh, const MeshParts& parts, std::int32_t number,
                                                  const WriteOptions& options, const std::filesystem::path& stem);
std::vector<std::filesystem::path> write_exodus_part(const ModelMesh& mesh, const MeshParts& parts,
                                                     const WriteOptions& options, const std::filesystem::path& stem);
/// @}

}  // namespace geomesh::geomodel

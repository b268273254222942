// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes the files of one part of a mesh when no process has the whole mesh.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geomesh/geomodel/write_options.hpp"
#include "partition/mesh_parts.hpp"

namespace geomesh::geomodel {

/// Writes the files of one part of a mesh with the names and contents that write_format would give them. With the first
/// part, it also writes the files that all parts share. Formats are vtu, exodus, msh and msh-binary; throws
/// Error{usage} for others, and if numbers exceed what the format can store.
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

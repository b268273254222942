// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Exodus files of one mesh in parts (NAME.e.N.K), put together by their global numbers.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "mesh_readers/raw_mesh.hpp"

namespace geomesh::geomodel {

struct ExodusPartFiles {
  std::filesystem::path whole;               ///< NAME.e, which need not be there
  std::vector<std::filesystem::path> parts;  ///< NAME.e.N.0 to NAME.e.N.(N-1)
};
/// From the name of one part; nothing where it is no such name.
std::optional<ExodusPartFiles> exodus_part_files(const std::filesystem::path& file);

/// A part with the global numbers, from 1, of its nodes and elements.
struct ExodusPartMesh {
  RawMesh mesh;
  std::vector<int> nodes, tetrahedra;
};
/// Nodes and elements by rising number. Throws Error{invalid_input} where a number is missing, has two places or is
/// owned by two parts.
RawMesh merge_exodus_parts(std::vector<ExodusPartMesh> parts, const std::filesystem::path& whole);

}  // namespace geomesh::geomodel

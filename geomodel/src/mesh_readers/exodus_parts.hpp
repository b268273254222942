// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Combines Exodus files with the parts of one mesh (NAME.e.N.K) by their global numbers.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "mesh_readers/raw_mesh.hpp"

namespace geomesh::geomodel {

struct ExodusPartFiles {
  std::filesystem::path whole;               ///< NAME.e, which need not exist
  std::vector<std::filesystem::path> parts;  ///< NAME.e.N.0 to NAME.e.N.(N-1)
};
/// Derives the files from the name of one part; returns nothing if the name has another form.
std::optional<ExodusPartFiles> exodus_part_files(const std::filesystem::path& file);

/// A part with the global numbers, from 1, of its nodes and elements.
struct ExodusPartMesh {
  RawMesh mesh;
  std::vector<int> nodes, tetrahedra;
};
/// Combines parts; nodes and elements are in ascending order of their numbers. Throws Error{invalid_input} if a number
/// is missing, has two places or is owned by two parts.
RawMesh merge_exodus_parts(std::vector<ExodusPartMesh> parts, const std::filesystem::path& whole);

}  // namespace geomesh::geomodel

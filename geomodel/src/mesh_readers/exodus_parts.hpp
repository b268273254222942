// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Combines the Exodus files that hold the parts of one mesh (NAME.e.N.K) by global numbers.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "mesh_readers/raw_mesh.hpp"

namespace geomesh::geomodel {

struct ExodusPartFiles {
  std::filesystem::path whole;  ///< NAME.e, the Exodus file that the whole mesh would have; it need not exist
  std::vector<std::filesystem::path> parts;  ///< NAME.e.N.0 to NAME.e.N.(N-1)
};
/// Derives the names of the files of all parts from that of one part; returns nothing if the name has another form.
std::optional<ExodusPartFiles> exodus_part_files(const std::filesystem::path& file);

/// A part of a mesh, with the numbers of its nodes and elements in the whole mesh, from 1.
struct ExodusPartMesh {
  RawMesh mesh;
  std::vector<int> nodes, tetrahedra;
};
/// Combines the parts of a mesh; nodes and elements are in ascending order of their global numbers. Throws
/// Error{invalid_input} if a number is missing, if a node has two places, or if an element is in two parts.
RawMesh merge_exodus_parts(std::vector<ExodusPartMesh> parts, const std::filesystem::path& whole);

}  // namespace geomesh::geomodel

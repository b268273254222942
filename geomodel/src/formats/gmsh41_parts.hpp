// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes Gmsh 4.1 files in parts.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "formats/gmsh_groups.hpp"
#include "geomesh/geomodel/write_options.hpp"
#include "partition/solver_part.hpp"

namespace geomesh::geomodel {

/// Function that writes one part into its file.
using GmshPartBody =
    std::function<void(OutputText& out, const MeshParts& parts, const SolverPart& part, const GmshGroups& groups)>;
/// Writes NAME_K.msh for part K from 1, with gmsh's own naming, and the JSON beside them; with one layer of ghosts.
std::vector<std::filesystem::path> write_gmsh_parts(const SolverMesh& mesh, const WriteOptions& options,
                                                    const std::filesystem::path& stem, const GmshPartBody& body);

/// Writes NAME_K.msh for part K from 1, in the same way as gmsh splits a partitioned mesh. Nodes and elements have
/// their numbers in the whole mesh. Each block is an entity, and its cells in one part form a partitioned entity with
/// the block as parent. Elements of other parts that touch the part are in its ghost entity, with their owner in
/// $GhostElements. Returns the files and the JSON beside them.
std::vector<std::filesystem::path> write_gmsh41_parts(const SolverMesh& mesh, const WriteOptions& options,
                                                      const std::filesystem::path& stem, Encoding encoding);
/// Writes only the parts that are available here, and the JSON with the first part.
std::vector<std::filesystem::path> write_gmsh41_parts(const SolverMesh& mesh, const MeshParts& parts,
                                                      const WriteOptions& options, const std::filesystem::path& stem,
                                                      Encoding encoding);

}  // namespace geomesh::geomodel

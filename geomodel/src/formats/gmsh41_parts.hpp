// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Gmsh 4.1 in parts.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "formats/gmsh_groups.hpp"
#include "geomesh/geomodel/write_options.hpp"
#include "partition/solver_part.hpp"

namespace geomesh::geomodel {

/// Writes one part into its file.
using GmshPartBody =
    std::function<void(OutputText& out, const MeshParts& parts, const SolverPart& part, const GmshGroups& groups)>;
/// NAME_K.msh for part K from 1, as gmsh itself names them, and the JSON beside them; with one layer of ghosts.
std::vector<std::filesystem::path> write_gmsh_parts(const SolverMesh& mesh, const WriteOptions& options,
                                                    const std::filesystem::path& stem, const GmshPartBody& body);

/// NAME_K.msh for part K from 1, as gmsh itself splits a partitioned mesh. Nodes and elements have their numbers in the
/// whole mesh. Each block is an entity, and its cells of one part a partitioned entity with the block as parent.
/// Elements of others that touch the part are in its ghost entity, with their owner in $GhostElements. Returns the
/// files and the JSON beside them.
std::vector<std::filesystem::path> write_gmsh41_parts(const SolverMesh& mesh, const WriteOptions& options,
                                                      const std::filesystem::path& stem, Encoding encoding);
/// Those parts alone that are here; the JSON where the first is.
std::vector<std::filesystem::path> write_gmsh41_parts(const SolverMesh& mesh, const MeshParts& parts,
                                                      const WriteOptions& options, const std::filesystem::path& stem,
                                                      Encoding encoding);

}  // namespace geomesh::geomodel

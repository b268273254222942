// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes a mesh to several Gmsh 4.1 files, one for each part.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "formats/gmsh_groups.hpp"
#include "geomesh/geomodel/write_options.hpp"
#include "partition/solver_part.hpp"

namespace geomesh::geomodel {

/// Function that writes one part of a mesh into its Gmsh file.
using GmshPartBody =
    std::function<void(OutputText& out, const MeshParts& parts, const SolverPart& part, const GmshGroups& groups)>;
/// Writes NAME_K.msh for each part K from 1, named as gmsh names parts, and the JSON file beside them. Each part has
/// one layer of ghost elements.
std::vector<std::filesystem::path> write_gmsh_parts(const SolverMesh& mesh, const WriteOptions& options,
                                                    const std::filesystem::path& stem, const GmshPartBody& body);

/// Writes NAME_K.msh for part K from 1, in the same way as gmsh splits a partitioned mesh. Nodes and elements have
/// their numbers in the whole mesh. Each block is an entity, and its cells in one part form a partitioned entity with
/// the block as parent. Elements of other parts that touch the part are in its ghost entity; $GhostElements lists their
/// owners. Returns the paths of the parts and of the JSON file beside them.
std::vector<std::filesystem::path> write_gmsh41_parts(const SolverMesh& mesh, const WriteOptions& options,
                                                      const std::filesystem::path& stem, Encoding encoding);
/// Writes only those parts of the mesh that this process has, and the JSON file together with the first part.
std::vector<std::filesystem::path> write_gmsh41_parts(const SolverMesh& mesh, const MeshParts& parts,
                                                      const WriteOptions& options, const std::filesystem::path& stem,
                                                      Encoding encoding);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes a mesh in parts: STEM.pvtu and one STEM.partK.vtu for each part K.
#pragma once

#include <filesystem>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"
#include "partition/mesh_parts.hpp"

namespace geomesh::geomodel {

/// Writes a mesh in parts. Each part contains its tetrahedra and one layer of ghosts: the cells of other parts that
/// touch the part in a node. Arrays of cells and points: GlobalCellIds and GlobalPointIds (Int64, rows of the mesh in
/// one file), vtkGhostType (UInt8, 1 where another part owns it; a point belongs to the lowest part that has a cell at
/// it), cell array `partition` (the part that owns the cell). Returns the paths of the files, the .pvtu last; if one of
/// them cannot be written, none is left behind.
std::vector<std::filesystem::path> write_pvtu(const ModelMesh& mesh, const WriteOptions& options,
                                              const std::filesystem::path& stem);
/// Writes only those parts of a mesh that this process has, and the .pvtu with the first part.
std::vector<std::filesystem::path> write_pvtu(const ModelMesh& mesh, const MeshParts& parts,
                                              const WriteOptions& options, const std::filesystem::path& stem);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Readers of mesh files, one for each format. They check only indices; everything else is left to the mesh checker.
/// Each reader throws Error{usage} if the file cannot be opened, Error{invalid_input} if it cannot be understood.
#pragma once

#include <filesystem>

#include "mesh_readers/raw_mesh.hpp"

namespace geomesh::geomodel {

RawMesh read_gmsh_mesh(const std::filesystem::path& file);  // reads Gmsh files of versions 2.2 and 4.1, text and binary
RawMesh read_abaqus_mesh(const std::filesystem::path& file);  // C3D4, C3D10
RawMesh read_exodus_mesh(const std::filesystem::path& file);
RawMesh read_med_mesh(const std::filesystem::path& file);  // with libmedc
RawMesh read_mfem_mesh(const std::filesystem::path& file);
// The reader of VTU files also reads NAME.faces.vtp and NAME.curves.vtp if they exist.
RawMesh read_vtu_mesh(const std::filesystem::path& file);

}  // namespace geomesh::geomodel

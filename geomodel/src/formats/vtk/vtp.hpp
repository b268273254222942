// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes the constrained faces to NAME.faces.vtp, and curves and named points to NAME.curves.vtp.
#pragma once

#include <filesystem>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel {

void write_faces_vtp(const ModelMesh& mesh, Compression compression, const std::filesystem::path& file);
void write_curves_vtp(const ModelMesh& mesh, Compression compression, const std::filesystem::path& file);

}  // namespace geomesh::geomodel

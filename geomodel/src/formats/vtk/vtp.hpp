// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes NAME.faces.vtp and NAME.curves.vtp beside NAME.vtu: constrained faces; curves and marked points.
#pragma once

#include <filesystem>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel {

void write_faces_vtp(const ModelMesh& mesh, Compression compression, const std::filesystem::path& file);
void write_curves_vtp(const ModelMesh& mesh, Compression compression, const std::filesystem::path& file);

}  // namespace geomesh::geomodel

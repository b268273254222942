// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Starter inputs: small files that a solver runs as they are, with the names of this very mesh and the project's
/// attributes as materials. Each takes the stem of a mesh file that is written already with its JSON, writes its file
/// beside it and returns its name. Heat flows through the model in steady state, from the lowest outer surface to the
/// highest; PyLith computes the settling under a load instead, as it knows no heat.
#pragma once

#include <filesystem>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

std::filesystem::path write_calculix_starter(const ModelMesh& mesh, const std::filesystem::path& stem);  // .job.inp
std::filesystem::path write_dolfinx_starter(const ModelMesh& mesh, const std::filesystem::path& stem);   // .dolfinx.py
std::filesystem::path write_ogs_starter(const ModelMesh& mesh, const std::filesystem::path& stem);       // .ogs.prj
std::filesystem::path write_pylith_starter(const ModelMesh& mesh, const std::filesystem::path& stem);    // .pylith.cfg

}  // namespace geomesh::geomodel

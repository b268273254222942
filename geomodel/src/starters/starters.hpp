// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes starter inputs: small files that a solver runs unchanged, with the names of the given mesh and the project's
/// attributes as materials. Each function takes the stem of a mesh file that was already written with its JSON file,
/// writes a file beside it and returns its name. In these problems heat flows through the model in steady state, from
/// the lowest outer surface to the highest; PyLith has no heat flow, so it computes the settling under a load.
#pragma once

#include <filesystem>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

std::filesystem::path write_calculix_starter(const ModelMesh& mesh, const std::filesystem::path& stem);  // .job.inp
std::filesystem::path write_dolfinx_starter(const ModelMesh& mesh, const std::filesystem::path& stem);   // .dolfinx.py
std::filesystem::path write_ogs_starter(const ModelMesh& mesh, const std::filesystem::path& stem);       // .ogs.prj
std::filesystem::path write_pylith_starter(const ModelMesh& mesh, const std::filesystem::path& stem);    // .pylith.cfg

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The job of geomesh-mpi: one mesh, with a part on each rank.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/project.hpp"
#include "ranks.hpp"

namespace geomesh::app {

struct RanksRequest {
  std::filesystem::path project;
  std::optional<std::filesystem::path> directory;  ///< output directory, which overrides the project's output.directory
};

/// Makes and writes the mesh of a project. Returns the lines to be printed, on rank 0 only. No file gets its final name
/// before all ranks have written their files. An error is thrown on its rank only, and the caller must end all ranks.
std::vector<std::string> mesh_on_ranks(const RanksRequest& request, const Ranks& ranks, const RunContext& context);

}  // namespace geomesh::app

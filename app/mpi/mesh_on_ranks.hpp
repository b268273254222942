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

/// Meshes and writes; returns lines for a person, on rank 0 only. No file gets its final name before all ranks have
/// written theirs. Errors of a rank are thrown only there, and the caller must end all ranks.
std::vector<std::string> mesh_on_ranks(const RanksRequest& request, const Ranks& ranks, const RunContext& context);

}  // namespace geomesh::app

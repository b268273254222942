// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The job of geomesh-mpi: one mesh, a part on each rank.
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
  std::optional<std::filesystem::path> directory;  ///< wins over the project's output.directory
};

/// Meshes and writes; returns lines for a person, on rank 0 alone. No file has its name before all ranks have written
/// theirs. Errors of a rank are thrown there alone: the caller ends all ranks.
std::vector<std::string> mesh_on_ranks(const RanksRequest& request, const Ranks& ranks, const RunContext& context);

}  // namespace geomesh::app

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Summarises a finished run for a person: a few lines that are always shown, and details on request.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/refinement.hpp"
#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel {

struct Summary {
  /// Number of elements, units with their volumes, the size and tolerance used, and the verdict.
  std::vector<std::string> lines;
  /// All regions, shapes of the elements, and properties of the mesh that would make solvers fail.
  std::vector<std::string> details;
};

/// Returns the summary of a report whose mesh, quality and verdicts are set. `refinement` contains the requested mesh
/// settings.
Summary summarise(const Report& report, const RefinementSettings& refinement);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a finished run says to a person: a few lines for everyone, further ones for who asks.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/refinement.hpp"
#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel {

struct Summary {
  std::vector<std::string> lines;    ///< counts, units with their volumes, what steered the mesh, the verdict
  std::vector<std::string> details;  ///< every region, shapes of the elements, what solvers would fail at
};

/// The summary of a report whose mesh, quality and verdicts are set. `refinement` is what was requested of the mesh.
Summary summarise(const Report& report, const RefinementSettings& refinement);

}  // namespace geomesh::geomodel

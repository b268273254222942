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
  std::vector<std::string> lines;    ///< always shown: numbers of elements, volumes of units, size, tolerance, verdict
  std::vector<std::string> details;  ///< shown on request: all regions, element shapes, elements that solvers reject
};

/// Returns the summary of a report whose mesh, quality and verdicts are set. `refinement` has the requested settings.
Summary summarise(const Report& report, const RefinementSettings& refinement);

}  // namespace geomesh::geomodel

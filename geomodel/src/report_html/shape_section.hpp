// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The page's section on the shape of the elements.
#pragma once

#include <string>

#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel::page {

/// Returns a table with statistics of the whole mesh and of each region; histograms of the whole mesh, and of the least
/// angles by region. Those of the whole mesh are least dihedral angles as in the paper's Figure 11, all dihedral
/// angles, radius ratios, and edges relative to the target size; then the worst elements with place and cause.
std::string shape_section(const QualityReport& report, const ModelMesh& mesh);

/// Returns the section on what solvers will do with the mesh.
std::string solver_section(const SolverVerdict& verdict);

}  // namespace geomesh::geomodel::page

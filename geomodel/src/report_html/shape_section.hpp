// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The page's section on the shape of the elements.
#pragma once

#include <string>

#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel::page {

/// Statistics of the whole and of each region in a table; histograms of the whole, and of the least angles by region.
/// Those of the whole are least dihedral angles as in the paper's Figure 11, all dihedral angles, radius ratios, edges
/// against the asked size; the worst elements with place and cause.
std::string shape_section(const QualityReport& report, const ModelMesh& mesh);

/// What solvers will make of the mesh.
std::string solver_section(const SolverVerdict& verdict);

}  // namespace geomesh::geomodel::page

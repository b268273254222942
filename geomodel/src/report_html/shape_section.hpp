// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes the sections of the HTML report on element shapes and on solvers.
#pragma once

#include <string>

#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel::page {

/// Returns a section with a table of shape statistics for the whole mesh and each region, histograms, and the worst
/// elements with position and cause. The histograms of the whole mesh show the least dihedral angles as in the paper's
/// Figure 11, all dihedral angles, radius ratios, and edges relative to the target size; those of regions show the
/// least dihedral angles.
std::string shape_section(const QualityReport& report, const ModelMesh& mesh);

/// Returns the report's section that says which kinds of solvers can use the mesh.
std::string solver_section(const SolverVerdict& verdict);

}  // namespace geomesh::geomodel::page

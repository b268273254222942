// SPDX-License-Identifier: MIT
/// @file
/// What must hold of every result of tetrahedralize(), decided apart from the code that made it.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh::test {

/// All faults found: cells not exactly positive; faces shared by more than two cells or seen twice from one side; facet faces that are no
/// mesh faces or name wrong cells; a facet that its faces do not cover (area) or leave (distance); unused or equal points; component faces
/// that are no facet faces; volume other than the divergence theorem gives over the faces. Empty where all is well.
std::vector<std::string> faults_of(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh);

/// Sum of the cells' volumes, in extended precision.
long double volume_of(const ConstrainedTetrahedralization& mesh);

/// Tetrahedralizes and joins all faults (errors thrown too) in one string: empty where all is well.
std::string mesh_and_check(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options = {},
                           ConstrainedTetrahedralization* result = nullptr);

}  // namespace geomesh::test

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Compares a solver's file (.msh, .inp, .e, .med) with the .vtu of the same name beside it.
#pragma once

#include <filesystem>

#include "geomesh/geomodel/check.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel::checking {

/// Checks that the elements, faces, edges and nodes under each name are the same in both files, compared by the
/// coordinates of their corners and midpoint nodes (`not_as_in_vtu`). `output` determines which parts solvers get. If a
/// format has no edges, the nodes of curves are compared. Returns false, with a message, if there is no .vtu, if the
/// format has no names, or if a file is not understood (prisms); returns false for VTK files. O(n log n).
bool check_as_in_vtu(const std::filesystem::path& mesh, const WriteOptions& output, CheckResult& result);

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A solver's file (.msh, .inp, .e, .med) against the .vtu of the same name beside it.
#pragma once

#include <filesystem>

#include "geomesh/geomodel/check.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel::checking {

/// Whether what stands under each name has the same places in both files (`not_as_in_vtu`): elements, faces, edges and
/// nodes by their corners, and nodes in the middle of edges. `output` tells what solvers are given of it. Where a
/// format has no edges the nodes of curves are asked. False, and said, where there is no .vtu, where the format has no
/// names, and where a file is not understood (prisms); false for files of VTK. O(n log n).
bool check_as_in_vtu(const std::filesystem::path& mesh, const WriteOptions& output, CheckResult& result);

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The grid of tetrahedra as VTK's XML holds it: points, cells and their arrays.
#pragma once

#include "formats/vtk/vtu_cells.hpp"
#include "writers/vtk_xml.hpp"

namespace geomesh::geomodel {

/// Sections in the order point data, cell data, points, cells. All arguments must live until it is written.
VtkDocument vtu_document(const ModelMesh& mesh, const WriteOptions& options, const VtuLayout& layout);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The grid of tetrahedra in VTK's XML format: points, cells and their arrays.
#pragma once

#include "formats/vtk/vtu_cells.hpp"
#include "writers/vtk_xml.hpp"

namespace geomesh::geomodel {

/// Returns the XML sections in the order point data, cell data, points, cells. All arguments must exist until the
/// document is written.
VtkDocument vtu_document(const ModelMesh& mesh, const WriteOptions& options, const VtuLayout& layout);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The grid of tetrahedra in VTK's XML format: points, cells and their arrays.
#pragma once

#include "formats/vtk/vtu_cells.hpp"
#include "writers/vtk_xml.hpp"

namespace geomesh::geomodel {

/// Describes a VTU file: its sections are point data, cell data, points and cells, in this order. All arguments must
/// exist until the file is written.
VtkDocument vtu_document(const ModelMesh& mesh, const WriteOptions& options, const VtuLayout& layout);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The parts of a mesh that a picture shows, as VTK data.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "geomesh/geomodel/palette.hpp"

namespace geomesh::picture {

struct MeshFile {
  vtkSmartPointer<vtkUnstructuredGrid> cells;
  vtkSmartPointer<vtkPolyData> faces;  ///< faces on surfaces, from NAME.faces.vtp; null if there is no such file
  std::map<int, std::string> region_names, surface_names;
  geomodel::GivenColours colours;   ///< colours of the project, from NAME.report.json if it exists
  std::vector<int> region_of_cell;  ///< region of each cell; 0 if the file has no regions
};

/// Reads a mesh, and the faces and colours beside it. Throws std::runtime_error if the file has no tetrahedra.
MeshFile read_mesh_file(const std::filesystem::path& file);

/// Returns the boundary of the tetrahedra that `wanted` accepts, shaded flat, with cell array `value` from `value_of`.
vtkSmartPointer<vtkPolyData> outside_of(const MeshFile& mesh, const std::function<bool(vtkIdType)>& wanted,
                                        const std::function<double(vtkIdType)>& value_of);

/// Returns the tetrahedra with a cell array `value`, by which they are coloured, that holds their region's id.
vtkSmartPointer<vtkUnstructuredGrid> with_region_values(const MeshFile& mesh);

/// The side of a vertical plane to which its normal points.
struct HalfSpace {
  std::array<double, 2> origin, normal;
};
/// Cuts cells along a plane and returns the part on one side of it.
vtkSmartPointer<vtkUnstructuredGrid> beyond(vtkUnstructuredGrid* grid, const HalfSpace& half);

vtkSmartPointer<vtkPolyData> outside_of(vtkUnstructuredGrid* grid);

void centre_of(const MeshFile& mesh, vtkIdType cell, double centre[3]);

/// Returns the smallest dihedral angle of a tetrahedron in degrees.
double smallest_dihedral(const MeshFile& mesh, vtkIdType cell);

/// Returns the faces of all surfaces except the sides of the box, with the id of the surface as cell array `value`.
/// Returns null if there are none.
vtkSmartPointer<vtkPolyData> inner_surfaces(const MeshFile& mesh);

}  // namespace geomesh::picture

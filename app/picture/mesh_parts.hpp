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
  vtkSmartPointer<vtkPolyData> faces;  ///< of NAME.faces.vtp; null where there is none
  std::map<int, std::string> region_names, surface_names;
  geomodel::GivenColours colours;   ///< of the project, from NAME.report.json where it is
  std::vector<int> region_of_cell;  ///< 0 where the file has no regions
};

/// Throws std::runtime_error where the file holds no tetrahedra.
MeshFile read_mesh_file(const std::filesystem::path& file);

/// The outside of the tetrahedra that `wanted` takes, flat shaded; cell array `value` from `value_of`.
vtkSmartPointer<vtkPolyData> outside_of(const MeshFile& mesh, const std::function<bool(vtkIdType)>& wanted,
                                        const std::function<double(vtkIdType)>& value_of);

/// The tetrahedra with their region as cell array `value`.
vtkSmartPointer<vtkUnstructuredGrid> with_region_values(const MeshFile& mesh);

/// The side of an upright plane that its normal points to.
struct HalfSpace {
  std::array<double, 2> origin, normal;
};
/// The part of the cells in the half space, cut along the plane.
vtkSmartPointer<vtkUnstructuredGrid> beyond(vtkUnstructuredGrid* grid, const HalfSpace& half);

vtkSmartPointer<vtkPolyData> outside_of(vtkUnstructuredGrid* grid);

/// The centre of a tetrahedron.
void centre_of(const MeshFile& mesh, vtkIdType cell, double centre[3]);

/// Smallest dihedral angle, in degrees.
double smallest_dihedral(const MeshFile& mesh, vtkIdType cell);

/// Faces of the surfaces, sides of the box left out; cell array `value` holds the id. Null where there are none.
vtkSmartPointer<vtkPolyData> inner_surfaces(const MeshFile& mesh);

}  // namespace geomesh::picture

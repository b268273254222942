// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads scalar fields from files.
#pragma once

#include <variant>
#include <vector>

#include "geomesh/geomodel/scalar_field.hpp"
#include "level_sets/fields/grid_field.hpp"

namespace geomesh::geomodel {

struct TetrahedralField {
  std::vector<Vec3> points;
  std::vector<double> values;  ///< per point
  std::vector<Tetrahedron> cells;
};

using FieldOfFile = std::variant<GridField::Lattice, TetrahedralField>;

/// Reads a scalar field from .vti (point or cell data; values of cells are those at their centres), .npy (three axes x,
/// y, z, with the origin and spacing that the project gives), netCDF and HDF5 (a variable over three axes) and .vtu
/// (tetrahedra with point data). Throws Error{invalid_input} with file and place: another format, no such array, a
/// value that is not finite, another kind of cell.
FieldOfFile read_field_file(const LevelSetSpec& spec);

/// Reads a three-dimensional variable of a netCDF or HDF5 file as a grid. Throws Error{invalid_input} if there is none.
GridField::Lattice read_netcdf_lattice(const LevelSetSpec& spec);

/// Reads a NumPy array with three axes as a grid, with x varying fastest. Throws Error{invalid_input} if the file is
/// damaged or is another kind of array.
GridField::Lattice read_npy(const LevelSetSpec& spec);

}  // namespace geomesh::geomodel

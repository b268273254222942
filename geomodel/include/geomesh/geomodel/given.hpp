// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Input that a program passes in memory instead of in files. The Python module uses it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geomesh/geomodel/project.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Contents of inputs, by the name of the surface or well to which they belong.
using GivenInputs = std::map<std::string, std::shared_ptr<const FileContents>>;

/// Scalar functions, by the name of the surface that is their level set. For the second and further functions of a
/// surface, `further_field` returns the key.
using GivenFields = std::map<std::string, std::shared_ptr<FieldFunction>>;

/// Returns the key in GivenFields of function number `entry` (from 1) of a surface. Surface names contain no line
/// break, so keys are unique.
inline std::string further_field(const std::string& name, std::size_t entry) {
  return entry == 1 ? name : name + "\n" + std::to_string(entry);
}

/// Makes the input of a triangulated surface from arrays in memory. Throws Error{invalid_input} with the rows that are
/// wrong: a coordinate that is not finite or a triangle with a point that does not exist. Also throws if it has no
/// triangle.
FileContents given_surface(std::string name, std::vector<Vec3> points, std::vector<Triangle> triangles);

/// Makes the input of points from which a surface is to be interpolated (docs/input-formats.md: `gridding`). Throws if
/// a coordinate is not finite.
FileContents given_points(std::string name, std::vector<Vec3> points);

/// Makes the input of a well's path. Throws if a coordinate is not finite, or if there are fewer than two points.
FileContents given_polyline(std::string name, std::vector<Vec3> points);

/// Heights at the nodes of a regular grid.
struct GivenGrid {
  std::size_t n_rows = 0, n_columns = 0;
  std::span<const double> heights;  ///< height of the grid node at index row * n_columns + column; NaN if it has none
  Vec2 origin;                      ///< position of the grid node in row 0, column 0
  Vec2 spacing;         ///< distances between columns along x and between rows along y, before the rotation; positive
  double rotation = 0;  ///< rotation of the grid about its origin in degrees, counter-clockwise
};
/// Makes a surface with two triangles for each cell of a grid, as the readers of grid files do. Throws
/// Error{invalid_input} if no cell has values at all of its nodes, or if heights and nodes differ in number.
FileContents given_grid(std::string name, const GivenGrid& grid);

/// A project that a program holds in memory.
struct GivenProject {
  std::string text;  ///< text of the project in YAML, or in JSON, which is YAML too
  std::string name = "model";
  std::filesystem::path folder;  ///< folder to which file names in the project text are relative
  GivenInputs inputs;            ///< inputs of the surfaces and wells that have no `file`
  GivenFields fields{};          ///< functions of the surfaces that are level sets without a file (no key `field`)
};

/// Reads a project given in memory. Each surface and each well has either a file or an input in memory. Throws as
/// read_project does.
Project read_given_project(const GivenProject& given);

}  // namespace geomesh::geomodel

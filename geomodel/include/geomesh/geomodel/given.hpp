// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a program holds in memory in place of files: the Python module's way in, and that of any other caller.
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

/// Contents of inputs by the name of the surface or well that they are for.
using GivenInputs = std::map<std::string, std::shared_ptr<const FileContents>>;

/// Functions by the name of the surface that is a level set of them. The functions of further entries of one name are
/// called by `further_field`.
using GivenFields = std::map<std::string, std::shared_ptr<FieldFunction>>;

/// The key in GivenFields of the `entry`-th entry of one name, from 1. No name holds a line break.
inline std::string further_field(const std::string& name, std::size_t entry) {
  return entry == 1 ? name : name + "\n" + std::to_string(entry);
}

/// A triangulated surface. Throws Error{invalid_input} with the rows in trouble: a coordinate that is not finite, a
/// triangle that names a point which is not there, no triangle.
FileContents given_surface(std::string name, std::vector<Vec3> points, std::vector<Triangle> triangles);

/// Points that are to become a surface (docs/input-formats.md: `gridding`). Throws as given_surface.
FileContents given_points(std::string name, std::vector<Vec3> points);

/// A well's path. Throws as given_surface, and where there are fewer than two points.
FileContents given_polyline(std::string name, std::vector<Vec3> points);

/// Heights at the nodes of a regular grid.
struct GivenGrid {
  std::size_t n_rows = 0, n_columns = 0;
  std::span<const double> heights;  ///< row * n_columns + column; NaN where there is none
  Vec2 origin;                      ///< the node of row 0, column 0
  Vec2 spacing;                     ///< of columns along x and of rows along y, before the rotation; positive
  double rotation = 0;              ///< degrees counter-clockwise about the origin
};
/// Two triangles a cell, as of grid files. Throws Error{invalid_input} where no cell has its nodes or the sizes
/// disagree.
FileContents given_grid(std::string name, const GivenGrid& grid);

/// A project that a program holds in memory.
struct GivenProject {
  std::string text;  ///< as a project file (YAML, or JSON, which is YAML)
  std::string name = "model";
  std::filesystem::path folder;  ///< what file names in the text are relative to
  GivenInputs inputs;            ///< of surfaces and wells without a `file`
  GivenFields fields{};          ///< of surfaces with a `value` and without a `field`
};

/// Errors as of read_project of a file; an entry has either a file or a given input.
Project read_given_project(const GivenProject& given);

}  // namespace geomesh::geomodel

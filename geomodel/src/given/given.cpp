// SPDX-License-Identifier: GPL-3.0-or-later
#include "geomesh/geomodel/given.hpp"

#include <cmath>

#include "geomesh/geomodel/model_error.hpp"
#include "readers/grids/grid.hpp"

namespace geomesh::geomodel {
namespace {

const char* const format_name = "arrays in memory";

[[noreturn]] void refuse(const std::string& name, const std::string& message, ErrorContext context = {}) {
  ModelItems items;
  items.add_surface(name);
  for (const Index row : context.facets) items.add_triangle(name, row);
  throw ModelError(ErrorKind::invalid_input, name + ": " + message, std::move(items), std::move(context));
}

void require_finite(const std::string& name, const std::vector<Vec3>& points) {
  for (std::size_t row = 0; row < points.size(); ++row) {
    const Vec3& p = points[row];
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    ErrorContext context;
    context.vertices.push_back(static_cast<VertexIndex>(row));
    refuse(name, "point " + std::to_string(row) + " (rows from 0) has a coordinate that is not finite",
           std::move(context));
  }
}

void require_points_there(const std::string& name, const std::vector<Triangle>& triangles, std::size_t n_points) {
  for (std::size_t row = 0; row < triangles.size(); ++row)
    for (const VertexIndex v : triangles[row]) {
      if (v < n_points) continue;
      ErrorContext context;
      context.facets.push_back(static_cast<Index>(row));
      refuse(name,
             "triangle " + std::to_string(row) + " (rows from 0) names point " + std::to_string(v) +
                 ", but there are " + std::to_string(n_points) + " points",
             std::move(context));
    }
}

FileContents empty_contents() {
  FileContents contents;
  contents.format = format_name;
  return contents;
}

}  // namespace

FileContents given_surface(std::string name, std::vector<Vec3> points, std::vector<Triangle> triangles) {
  if (triangles.empty()) refuse(name, "the surface has no triangle");
  require_finite(name, points);
  require_points_there(name, triangles, points.size());
  FileContents contents = empty_contents();
  TriangulatedSurface surface;
  surface.name = std::move(name);
  surface.points = std::move(points);
  surface.triangles = std::move(triangles);
  contents.surfaces.push_back(std::move(surface));
  return contents;
}

FileContents given_points(std::string name, std::vector<Vec3> points) {
  require_finite(name, points);
  FileContents contents = empty_contents();
  contents.point_sets.push_back({std::move(name), "", std::move(points)});
  return contents;
}

FileContents given_polyline(std::string name, std::vector<Vec3> points) {
  require_finite(name, points);
  if (points.size() < 2) refuse(name, "a well's path needs two points or more");
  FileContents contents = empty_contents();
  contents.polylines.push_back({std::move(name), "", std::move(points)});
  return contents;
}

FileContents given_grid(std::string name, const GivenGrid& given) {
  if (given.n_rows < 2 || given.n_columns < 2 || given.heights.size() != given.n_rows * given.n_columns)
    refuse(name, "a grid needs two rows and two columns or more, and a height (or NaN) for each node; found " +
                     std::to_string(given.n_rows) + " by " + std::to_string(given.n_columns) + " with " +
                     std::to_string(given.heights.size()) + " heights");
  Grid grid;
  grid.name = name;
  grid.n_columns = given.n_columns;
  grid.n_rows = given.n_rows;
  grid.x0 = given.origin.x;
  grid.y0 = given.origin.y;
  grid.dx = given.spacing.x;
  grid.dy = given.spacing.y;
  grid.rotation = given.rotation;
  grid.heights.assign(given.heights.begin(), given.heights.end());
  for (double& height : grid.heights)
    if (!std::isfinite(height)) height = std::nan("");
  InputFile as_file;  // for messages alone
  as_file.path = name;
  return grid_contents(as_file, format_name, grid);
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/objects_of_file.hpp"

#include <algorithm>
#include <map>

#include "geomesh/geomodel/sticks.hpp"

namespace geomesh::geomodel {
namespace {

FileContents without_objects(const FileContents& contents) {
  FileContents part;
  part.format = contents.format;
  part.frame = contents.frame;
  part.arrays = contents.arrays;
  return part;
}

FileContents with_surface(const FileContents& contents, const TriangulatedSurface& surface) {
  FileContents part = without_objects(contents);
  part.surfaces.push_back(surface);
  std::copy_if(contents.grids.begin(), contents.grids.end(), std::back_inserter(part.grids),
               [&](const GridSummary& grid) { return grid.surface == surface.name; });
  return part;
}

/// Divides the polylines of a file into objects, one with all lines of each name, in the order of the names.
std::vector<FileContents> objects_of_lines(const FileContents& contents) {
  std::vector<FileContents> objects;
  std::map<std::string, std::size_t> row_of;
  for (const Polyline& line : contents.polylines) {
    const auto [row, is_new] = row_of.try_emplace(name_without_part(line.name), objects.size());
    if (is_new) objects.push_back(without_objects(contents));
    objects[row->second].polylines.push_back(line);
  }
  return objects;
}

}  // namespace

std::vector<FileContents> objects_of_file(const FileContents& contents) {
  std::vector<FileContents> objects;
  for (const TriangulatedSurface& surface : contents.surfaces) objects.push_back(with_surface(contents, surface));
  for (const PointSet& set : contents.point_sets) {
    objects.push_back(without_objects(contents));
    objects.back().point_sets.push_back(set);
  }
  if (objects.empty()) objects = objects_of_lines(contents);
  if (!objects.empty()) {
    objects.front().notes = contents.notes;
    objects.front().warnings = contents.warnings;
  }
  return objects;
}

FileContents object_named(const FileContents& contents, const std::string& name) {
  for (const TriangulatedSurface& surface : contents.surfaces)
    if (surface.name == name) return with_surface(contents, surface);
  FileContents part = without_objects(contents);
  for (const PointSet& set : contents.point_sets)
    if (set.name == name) {
      part.point_sets.push_back(set);
      break;
    }
  return part;
}

}  // namespace geomesh::geomodel

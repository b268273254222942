// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh info`: what a file holds, and what is wrong with it, before anything is meshed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// One triangulated surface. Vertices with equal coordinates count as one, as they do when meshing.
struct SurfaceInfo {
  std::string name;
  std::size_t n_points = 0, n_distinct_points = 0, n_triangles = 0;
  std::size_t n_components = 0;  ///< pieces joined through vertices
  Box3 bounds;
  double area = 0;
  std::size_t n_border_edges = 0, n_borders = 0;  ///< edges of one triangle, and the closed chains that they make
  double border_length = 0;
  std::size_t n_non_manifold_edges = 0;   ///< edges of more than two triangles
  std::size_t n_misoriented_edges = 0;    ///< edges whose two triangles run along them in the same direction
  std::size_t n_degenerate = 0;           ///< triangles of exactly zero area
  std::size_t n_repeated = 0;             ///< triangles on the same three vertices as an earlier one
  std::size_t n_holes = 0;                ///< borders beyond the longest one of each piece
  bool closed = false;                    ///< no border: every edge has an even number of triangles
  double volume = 0;                      ///< enclosed, where closed and oriented alike
  Vec3 border_place, non_manifold_place;  ///< an example of each
};
SurfaceInfo measure_surface(const TriangulatedSurface& surface);

/// A tetrahedral mesh, any tool's.
struct MeshInfo {
  std::size_t n_points = 0, n_tetrahedra = 0, n_other_solids = 0, n_lower_cells = 0;
  Box3 bounds;
  std::string region_array;
  std::vector<std::string> arrays;  ///< of points and cells, with their type
  double volume = 0;                ///< of all tetrahedra
  std::size_t n_inverted = 0;       ///< tetrahedra of exactly zero or negative volume
  struct Region {
    std::int32_t id;
    std::string name;
    std::size_t n_tetrahedra;
    double volume;
  };
  std::vector<Region> regions;
};

struct FileInfo {
  std::string file, format;
  SourceFrame frame;
  std::vector<GridSummary> grids;
  std::vector<std::string> arrays;  ///< properties passed over
  std::vector<SurfaceInfo> surfaces;
  struct Line {
    std::string name;
    std::size_t n_points;
    double length;
    Box3 bounds;
  };
  std::vector<Line> polylines;
  struct Points {
    std::string name;
    std::size_t n_points;
    Box3 bounds;
  };
  std::vector<Points> point_sets;
  std::size_t n_named_points = 0;
  std::vector<std::string> regions;  ///< names that came with the file (GOCAD Model3d, TetGen attributes)
  std::size_t n_facets = 0;          ///< of a PLC file
  std::vector<MeshInfo> meshes;      ///< one for a mesh file
  std::vector<std::string> notes, warnings;
};

/// A project's surfaces, read, built and intersected: what crosses what, over which area and where, what dangles, what
/// has gaps. Errors as read_project, the readers and arrange.
FileInfo describe_project(const std::filesystem::path& path);
/// Project files go to describe_project. Errors as the readers'. Near-linear.
FileInfo describe_file(const std::filesystem::path& path);
/// For a person.
std::string to_text(const FileInfo& info);
/// For a program: the members under their own names.
std::string to_json(const FileInfo& info);

}  // namespace geomesh::geomodel

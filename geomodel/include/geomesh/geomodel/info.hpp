// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh info`: reports what a file contains and what is wrong with it, before anything is meshed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Description of one triangulated surface. Vertices with equal coordinates count as one, as they do in meshing.
struct SurfaceInfo {
  std::string name;
  std::size_t n_points = 0, n_distinct_points = 0, n_triangles = 0;
  std::size_t n_components = 0;  ///< number of pieces of the surface that share no vertex
  Box3 bounds;
  double area = 0;
  /// Number of edges with only one triangle, and of the closed chains that these edges form.
  std::size_t n_border_edges = 0, n_borders = 0;
  double border_length = 0;
  std::size_t n_non_manifold_edges = 0;  ///< number of edges of the surface with more than two triangles
  std::size_t n_misoriented_edges = 0;   ///< number of edges whose two triangles traverse them in the same direction
  std::size_t n_degenerate = 0;          ///< number of triangles whose area is exactly zero
  std::size_t n_repeated = 0;            ///< number of triangles with the same three vertices as an earlier triangle
  std::size_t n_holes = 0;  ///< number of borders without the longest border of each connected component of the surface
  bool closed = false;      ///< whether the surface has no border: every edge has an even number of triangles
  double volume = 0;        ///< enclosed volume, if the surface is closed and consistently oriented
  /// A place on a border of the surface, and a place on an edge with more than two triangles.
  Vec3 border_place, non_manifold_place;
};
SurfaceInfo measure_surface(const TriangulatedSurface& surface);

/// Description of a tetrahedral mesh, written by any tool.
struct MeshInfo {
  std::size_t n_points = 0, n_tetrahedra = 0, n_other_solids = 0, n_lower_cells = 0;
  Box3 bounds;
  std::string region_array;
  std::vector<std::string> arrays;  ///< names and types of the point arrays and cell arrays
  double volume = 0;                ///< of all tetrahedra
  std::size_t n_inverted = 0;       ///< number of tetrahedra whose volume is exactly zero or negative
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
  std::vector<std::string> regions;  ///< names of regions in the file (GOCAD Model3d, TetGen attributes)
  std::size_t n_facets = 0;          ///< number of facets, for files that hold a PLC
  std::vector<MeshInfo> meshes;      ///< the tetrahedral mesh in the file; empty if the file holds surfaces
  std::vector<std::string> notes, warnings;
};

/// Describes a project: reads, builds and intersects its surfaces and reports which of them cross, over which area and
/// where, which have dangling parts, and which have gaps. Throws as read_project, the readers and arrange() do.
FileInfo describe_project(const std::filesystem::path& path);
/// Describes the contents of any file; project files are passed to describe_project. Throws as the readers do. The time
/// is nearly linear in the size of the file.
FileInfo describe_file(const std::filesystem::path& path);
/// For a person.
std::string to_text(const FileInfo& info);
/// Returns the description of a file as JSON for programs, with the names of the members of FileInfo.
std::string to_json(const FileInfo& info);

}  // namespace geomesh::geomodel
